//! Reading the command line, and saying what is wrong with it.

use crate::failure::{Failure, Result};
use crate::output;
use clap::error::ErrorKind;
use clap::{Arg, Command, FromArgMatches};
use imogene::arguments::Arguments;
use imogene::help;

/// What the parser says of numbers, and what a person is told.
const IN_PLAIN_WORDS: [&str; 7] = [
    "is not in 1..18446744073709551615 => is too few; 1 or more is expected",
    "invalid digit found in string => a whole number is expected",
    "cannot parse integer from empty string => a whole number is expected",
    "number too large to fit in target type => the number is too large",
    "number too small to fit in target type => the number is too small",
    "invalid float literal => a number is expected, such as 0.5",
    "cannot parse float from empty string => a number is expected, such as 0.5",
];

/// The arguments; or whether JSON was asked for, and the outcome of what was asked for instead of a command.
pub fn parse() -> Result<Arguments, (bool, Result)> {
    let parsed = command()
        .try_get_matches()
        .and_then(|matches| Arguments::from_arg_matches(&matches));
    parsed.map_err(|error| {
        let json = std::env::args_os().any(|argument| argument == "--json");
        match error.kind() {
            ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
                (false, error.print().map_err(|error| output::lost(&error)))
            }
            ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
                output::complain(error.render());
                (json, Err(Failure::Input("a command is expected".into())))
            }
            _ => (json, Err(Failure::Input(problem(&error)))),
        }
    })
}

/// A negative number is the value of an option, which refuses it in its own words if it has to.
fn command() -> Command {
    let with_negative_numbers = |argument: Arg| {
        let takes_value = !argument.is_positional() && argument.get_action().takes_values();
        argument.allow_negative_numbers(takes_value)
    };
    help::command().mut_subcommands(|command| command.mut_args(with_negative_numbers))
}

/// The parser's message in plain words.
fn problem(error: &clap::Error) -> String {
    let text = error.render().to_string();
    let text = text.trim_end();
    let text = text.strip_prefix("error: ").unwrap_or(text);
    let rows = IN_PLAIN_WORDS.iter();
    let pairs = rows.filter_map(|row| row.split_once(" => "));
    pairs.fold(text.to_owned(), |text, (said, meant)| {
        text.replace(said, meant)
    })
}
