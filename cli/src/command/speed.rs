//! `imogene speed`.

use super::frame_in;
use crate::arguments::Speed;
use crate::failure::Result;
use crate::{molecules, output};
use imogene_contract::Unit;
use imogene_golden::format::Format;
use imogene_verif::engine::speed::{self, Drive, Entrant, FRAME, measure};
use imogene_verif::scene;
use serde_json::json;
use std::path::Path;
use std::time::Duration;

pub fn run(options: &Speed, json: bool) -> Result {
    let path = Path::new(&options.unit);
    let is_scene = Unit::from_name(&options.unit).is_err() && path.extension().is_some();
    let (request, clocks) = if is_scene {
        options.given.of_scene()?;
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
    let drive = match options.random {
        true => Drive::Random,
        false => Drive::Frame,
    };
    let stimuli = clocks.map_or_else(|| speed::stimuli(&engines, drive), |clocks| vec![clocks]);
    let seconds = Duration::from_secs(options.seconds.into());
    let speeds = measure(&engines, &stimuli, seconds)?;
    let page = output::page(
        include_str!("speed.txt"),
        json!({
            "unit": options.unit,
            "parameters": engines[0].options(),
            "frame": FRAME,
            "speeds": speeds,
        }),
    )?;
    output::report(json, &speeds, |_| output::text(page));
    Ok(())
}
