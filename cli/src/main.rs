//! The command line of imogene: argument parsing and printing, no logic.

mod command;
mod interruption;
mod missing;
mod molecules;
mod output;
mod paths;
mod process;
mod usage;

use imogene::arguments::{self, Arguments, Command};
use imogene::failure::{self, Result};
use imogene_files::{Scratch, limit_memory};
use paths::Paths;
use serde_json::json;
use std::process::ExitCode;

fn main() -> ExitCode {
    let (json, outcome) = match usage::parse() {
        Ok(arguments) => {
            interruption::watch(&arguments.command);
            // Without it temporary files are where they always are.
            let _scratch = Scratch::of_process();
            let outcome = run(&arguments).and_then(|()| missing::verdict());
            (arguments.json, outcome)
        }
        Err((json, outcome)) => (json, outcome),
    };
    end(json, outcome)
}

/// Says what went wrong, and that standard output was lost if it was.
fn end(json: bool, outcome: Result) -> ExitCode {
    if let Err(failure) = &outcome {
        output::complain(failure);
        if let Some(message) = failure.message().filter(|_| json && !output::is_reported()) {
            output::json(&json!({
                "error": { "message": message, "exit_code": failure.exit_code() }
            }));
        }
    }
    let flushed = output::flush();
    if let Err(failure) = &flushed {
        output::complain(failure);
    }
    match outcome.and(flushed) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => ExitCode::from(failure.exit_code()),
    }
}

fn run(arguments: &Arguments) -> Result {
    let json = arguments.json;
    missing::set(arguments.policy());
    if let Some(bytes) = arguments.max_memory {
        limit_memory(bytes);
    }
    Paths::of(&arguments.command).check(json)?;
    match &arguments.command {
        Command::Demo(options) => command::demo::run(options, json),
        Command::New(options) => command::new::run(options, json),
        Command::Units => command::units::units(json),
        Command::Processors(options) => command::units::processors(options, json),
        Command::Roots(options) => command::units::roots(options, json),
        Command::Emit(options) => command::emit::run(options, json),
        Command::Contract(options) => command::units::contract(options, json),
        Command::Package(options) => command::package::run(options, json),
        Command::Render(options) => command::render::run(options, json),
        Command::Prepare(options) => command::prepare::run(options, json),
        Command::Cosim(options) => command::cosim::run(options, json),
        Command::Import(options) => command::import::run(options, json),
        Command::Terrain(options) => command::terrain::run(options, json),
        Command::Machine(options) => command::machine::run(options, json),
        Command::Board(options) => command::board::run(options, json),
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
    }
}
