//! `imogene speed`.

use super::frame_in;
use crate::arguments::Speed;
use crate::failure::Failure;
use crate::molecules;
use crate::output;
use imogene_contract::Unit;
use imogene_golden::format::Format;
use imogene_verif::engine::speed::{self, Drive, Entrant, FRAME, measure};
use imogene_verif::scene;
use std::path::Path;
use std::time::Duration;

/// Measures how fast the engines run a unit, or the machine of a scene, side by side.
pub fn run(options: &Speed, json: bool) -> Result<(), Failure> {
    let path = Path::new(&options.unit);
    let is_scene = Unit::from_name(&options.unit).is_err() && path.extension().is_some();
    let (request, clocks) = if is_scene {
        let file = molecules::read_scene(path)?;
        let format = Format::new(options.shape.format)?;
        let (_, prepared) = frame_in(&file, None, format)?;
        prepared.refuse_composed()?;
        let (request, clocks) = scene::unit(&prepared, options.shape.rows_per_stage())?;
        (request, Some(clocks))
    } else {
        (options.shape.request(&options.unit)?, None)
    };
    let engines = Entrant::all(&request)?;
    let drive = if options.random {
        Drive::Random
    } else {
        Drive::Frame
    };
    let stimuli = clocks.map_or_else(|| speed::stimuli(&engines, drive), |clocks| vec![clocks]);
    let seconds = Duration::from_secs(options.seconds.into());
    let speeds = measure(&engines, &stimuli, seconds)?;
    output::report(json, &speeds, |_| {
        output::text(table(&options.unit, engines[0].options(), &speeds))
    });
    Ok(())
}

fn table(unit: &str, parameters: &str, speeds: &[speed::Speed]) -> String {
    let mut text = format!(
        "{unit} {parameters}, one thread; xN: N runs side by side, their clocks together; a frame has {}x{} clocks\n{:<11} {:<12} {:>14} {:>8} {:>12} {:>12} {:>15}",
        FRAME.0,
        FRAME.1,
        "engine",
        "work",
        "clocks/second",
        "ratio",
        "first clock",
        "frame",
        "VCD bytes/clock"
    );
    for s in speeds {
        let work = format!("{:?}", s.work).to_lowercase();
        let engine = match s.lanes {
            1 => s.engine.clone(),
            lanes => format!("{} x{lanes}", s.engine),
        };
        let bytes = s.vcd_bytes_per_clock;
        let bytes = bytes.map_or("-".into(), |bytes| format!("{bytes:.1}"));
        text += &format!(
            "\n{engine:<11} {work:<12} {:>14.0} {:>8.2} {:>10.3} s {:>10.2} s {bytes:>15}",
            s.clocks_per_second, s.ratio, s.first_clock_seconds, s.frame_seconds
        );
    }
    text
}
