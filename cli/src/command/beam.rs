//! A beam machine in simulation, for the commands that draw with it.

use crate::failure::Failure;
use crate::output;
use imogene_golden::machine::frame::Frame;
use imogene_prepare::PreparedScene;
use imogene_verif::engine::Engine;
use imogene_verif::report::Report;
use imogene_verif::scene::{self, Options};

/// The report of a scene and the frame that the hardware drew.
pub fn run(
    prepared: &PreparedScene,
    options: &Options,
    engine: Engine,
) -> Result<(Report, Frame), Failure> {
    let pixels = u64::from(prepared.width) * u64::from(prepared.height);
    let outcome = output::during(pixels, "hardware in simulation", |bar| {
        scene::run(prepared, options, engine, || bar.inc(1))
    });
    Ok(outcome?)
}
