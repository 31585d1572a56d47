//! The command line of imogene: argument parsing and printing, no logic.

mod command;
mod failure;
mod missing;
mod output;

use arguments::Command;
use imogene::arguments::{self, Arguments};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = Arguments::read();
    let json = arguments.json;
    missing::set(arguments.policy());
    let outcome = match &arguments.command {
        Command::Demo(options) => command::demo::run(options, json),
        Command::New(options) => command::new::run(options, json),
        Command::Units => command::units::run(json),
        Command::Processors(options) => command::processors::run(options, json),
        Command::Roots(options) => command::roots::run(options, json),
        Command::Emit(options) => command::emit::run(options, json),
        Command::Contract(options) => command::contract::run(options, json),
        Command::Package(options) => command::package::run(options, json),
        Command::Render(options) => command::render::run(options, json),
        Command::Prepare(options) => command::prepare::run(options, json),
        Command::Cosim(options) => command::cosim::run(options, json),
        Command::Import(options) => command::import::run(options, json),
        Command::Terrain(options) => command::terrain::run(options, json),
        Command::Machine(options) => command::machine::run(options, json),
        Command::Raytrace(options) => command::raytrace::run(options, json),
        Command::Cracks(options) => command::cracks::run(options, json),
        Command::Repair(options) => command::repair::run(options, json),
        Command::Speed(options) => command::speed::run(options, json),
        Command::Check(options) => command::check::run(options, json),
        Command::Detail(options) => command::detail::run(options, json),
        Command::Primitives(options) => command::primitives::run(options, json),
        Command::Trade(options) => command::trade::run(options, json),
        Command::Fit(options) => command::fit::run(options, json),
        Command::Bounds(options) => command::bounds::run(options, json),
        Command::Shading(options) => command::shading::run(options, json),
        Command::Sweep(options) => command::sweep::run(options, json),
        Command::Evaluate(options) => command::evaluate::run(options, json),
        Command::Synth(options) => command::synth::run(options, json),
        Command::Peers(options) => command::peers::run(options, json),
        Command::Prove(options) => command::prove::run(options, json),
        Command::Mutate(options) => command::mutate::run(options, json),
    };
    match outcome.and_then(|()| missing::verdict()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{failure}");
            failure.exit_code()
        }
    }
}
