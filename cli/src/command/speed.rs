//! `imogene speed`.

use crate::arguments::Speed;
use crate::failure::Failure;
use crate::output;
use imogene_verif::engine::Engine;
use imogene_verif::engine::design::Simulator;
use imogene_verif::engine::speed::{self, Drive, Entrant, FRAME, measure};
use imogene_verif::unit;
use std::time::Duration;

/// Measures how fast the engines run a unit, side by side.
pub fn run(options: &Speed, json: bool) -> Result<(), Failure> {
    let request = options.shape.request(&options.unit)?;
    let mut engines = vec![
        Entrant::new(|| unit::subject(&request))?,
        Entrant::new(|| unit::levelised(&request))?,
    ];
    for simulator in Simulator::ALL {
        engines.push(Entrant::new(|| Engine::Verilog(simulator).unit(&request))?);
    }
    let seconds = Duration::from_secs(options.seconds.into());
    let drive = if options.random {
        Drive::Random
    } else {
        Drive::Frame
    };
    let speeds = measure(&engines, drive, seconds)?;
    output::report(json, &speeds, |_| {
        output::text(table(&options.unit, engines[0].options(), &speeds))
    });
    Ok(())
}

fn table(unit: &str, parameters: &str, speeds: &[speed::Speed]) -> String {
    let mut text = format!(
        "{unit} {parameters}, one thread; a frame has {}x{} clocks\n{:<11} {:<12} {:>14} {:>8} {:>12} {:>12} {:>15}",
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
        let bytes = s.vcd_bytes_per_clock;
        let bytes = bytes.map_or("-".into(), |bytes| format!("{bytes:.1}"));
        text += &format!(
            "\n{:<11} {work:<12} {:>14.0} {:>8.1} {:>10.3} s {:>10.2} s {bytes:>15}",
            s.engine, s.clocks_per_second, s.ratio, s.first_clock_seconds, s.frame_seconds
        );
    }
    text
}
