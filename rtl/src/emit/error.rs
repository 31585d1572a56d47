//! Refusals of the emitter and the simulators.

use crate::catalogue::Unit;
use crate::format::DEPTH_WORDS;
use std::fmt;

/// Why a unit cannot be emitted or simulated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EmitError {
    /// The format is not in the catalogue.
    Format {
        /// The depth word asked for.
        value: usize,
    },
    /// A parameter is out of its legal range.
    Range {
        /// The parameter.
        parameter: &'static str,
        /// The value asked for.
        value: usize,
        /// Least legal value.
        least: usize,
        /// Greatest legal value.
        most: usize,
    },
    /// The unit has no such parameter.
    Foreign {
        /// The parameter.
        parameter: &'static str,
        /// The unit.
        unit: &'static str,
    },
    /// No unit has this name.
    Unit {
        /// The name asked for.
        name: String,
    },
    /// A prefix that no identifier can begin with.
    Prefix {
        /// The prefix asked for.
        prefix: String,
    },
}

impl fmt::Display for EmitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Format { value } => {
                let legal: Vec<_> = DEPTH_WORDS.iter().map(usize::to_string).collect();
                write!(
                    f,
                    "format {value} is not in the catalogue; legal formats are {}",
                    legal.join(", ")
                )
            }
            Self::Range {
                parameter,
                value,
                least,
                most,
            } => {
                write!(
                    f,
                    "{parameter} = {value} is out of range; legal values are {least} to {most}"
                )
            }
            Self::Foreign { parameter, unit } => {
                write!(
                    f,
                    "the unit `{unit}` has no parameter `{parameter}`; `imogene units` lists what each has"
                )
            }
            Self::Unit { name } => {
                let legal: Vec<_> = Unit::ALL.iter().map(|unit| unit.name()).collect();
                write!(
                    f,
                    "there is no unit `{name}`; the units are {}",
                    legal.join(", ")
                )
            }
            Self::Prefix { prefix } => {
                write!(
                    f,
                    "prefix `{prefix}` begins no portable name of a module; legal prefixes begin with a letter and go on with letters, digits and single underscores"
                )
            }
        }
    }
}

impl std::error::Error for EmitError {}
