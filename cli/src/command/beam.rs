//! A beam machine in simulation, for the commands that draw with it.

use crate::failure::Failure;
use crate::output;
use imogene_golden::machine::frame::Frame;
use imogene_prepare::PreparedScene;
use imogene_verif::engine::beam::BeamDesign;
use imogene_verif::engine::built_in::BuiltIn;
use imogene_verif::engine::design::Simulator;
use imogene_verif::report::Report;
use imogene_verif::scene::{self, Options};

/// The report of a scene and the frame that the hardware drew, in a simulator of Verilog or in the built-in one.
pub fn run(
    prepared: &PreparedScene,
    options: &Options,
    simulator: Option<Simulator>,
) -> Result<(Report, Frame), Failure> {
    let pixels = u64::from(prepared.width) * u64::from(prepared.height);
    let bar = output::progress(pixels, "hardware in simulation");
    let done = || bar.inc(1);
    let outcome = match simulator {
        Some(simulator) => {
            let shape = scene::shape_of(prepared, options.rows_per_stage)?;
            let design = BeamDesign::compile(simulator, &shape)?;
            scene::run(prepared, options, |_| design.machine(), done)
        }
        None => {
            let engine = |shape: &_| BuiltIn::new(shape).expect("the shape was checked");
            scene::run(prepared, options, engine, done)
        }
    };
    bar.finish_and_clear();
    Ok(outcome?)
}
