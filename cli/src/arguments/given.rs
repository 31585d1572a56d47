//! The options that stand on the command line.

use crate::failure::{Failure, Result};
use clap::parser::ValueSource;
use clap::{ArgMatches, Args, Command, Error, FromArgMatches};
use imogene_contract::parameters::PARAMETERS;

/// Options of scenes that say nothing of a unit.
const OF_SCENES: [&str; 9] = [
    "size",
    "widths",
    "guards",
    "camera",
    "frame",
    "trace_object",
    "inject_fault",
    "vcd_from",
    "vcd_nets",
];

/// The names of the options that were given; what has its default was not.
#[derive(Clone, Debug)]
pub struct Given(Vec<String>);

impl Given {
    /// Refuses options of a scene.
    pub fn of_unit(&self) -> Result {
        self.refuse(OF_SCENES, "a scene, not for a unit")
    }

    /// Refuses options of a unit alone: a scene says itself how many planes and objects it needs.
    pub fn of_scene(&self) -> Result {
        let parameters = PARAMETERS.iter().map(|parameter| parameter.option);
        let parameters = parameters.filter(|option| *option != "rows-per-stage");
        let options = ["seed", "clocks", "random", "netlist"].into_iter();
        self.refuse(options.chain(parameters), "a unit, not for a scene")
    }

    /// Refuses options of units and scenes.
    pub fn of_neither(&self, what: &str) -> Result {
        let meant = format!("a unit or a scene, not for {what}");
        let both = ["engine", "format", "vcd", "root-form", "rows-per-stage"];
        self.refuse(both, &meant)?;
        self.of_unit().and_then(|()| self.of_scene())
    }

    fn refuse<'a>(&self, options: impl IntoIterator<Item = &'a str>, meant: &str) -> Result {
        let mut options = options.into_iter();
        match options.find(|option| self.0.iter().any(|given| given == option)) {
            Some(option) => {
                let option = option.replace('_', "-");
                Err(Failure::Input(format!("--{option} is for {meant}")))
            }
            None => Ok(()),
        }
    }
}

impl FromArgMatches for Given {
    fn from_arg_matches(matches: &ArgMatches) -> std::result::Result<Given, Error> {
        let is_given = |name: &&str| matches.value_source(name) == Some(ValueSource::CommandLine);
        let names = matches.ids().map(clap::Id::as_str).filter(is_given);
        Ok(Given(names.map(str::to_owned).collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> std::result::Result<(), Error> {
        *self = Given::from_arg_matches(matches)?;
        Ok(())
    }
}

/// It has no options of its own.
impl Args for Given {
    fn augment_args(command: Command) -> Command {
        command
    }

    fn augment_args_for_update(command: Command) -> Command {
        command
    }
}
