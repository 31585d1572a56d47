//! Why a board is not made.

use crate::screen::ScreenError;
use crate::tmds::TmdsError;
use imogene_contract::RequestError;
use imogene_synth::SynthError;
use imogene_tools::{FileError, ToolError};
use thiserror::Error;

/// A board that is not made.
#[derive(Debug, Error)]
pub enum BoardError {
    /// No board has the name.
    #[error("there is no board `{name}`; the boards are {}", .known.join(", "))]
    Unknown {
        /// The name.
        name: String,
        /// Those that there are.
        known: Vec<&'static str>,
    },
    /// The description of a board is none.
    #[error("{file}:{line}:{column}: {problem}")]
    Syntax {
        /// The file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What the parser says.
        problem: String,
    },
    /// A value of a description that nothing can be made of.
    #[error("{file}: {key} is {value}; accepted: {accepted}")]
    Value {
        /// The file.
        file: String,
        /// The key.
        key: &'static str,
        /// Its value.
        value: String,
        /// What would be accepted.
        accepted: &'static str,
    },
    /// No dividers give the clock.
    #[error(
        "no dividers of the PLL make {pixel} Hz for the pixels out of the {input} Hz of the board"
    )]
    NoClock {
        /// Clock of the board.
        input: u64,
        /// Clock that is asked for.
        pixel: u64,
    },
    /// The design does not fit the part.
    #[error("the design does not fit {part}: it takes {excess}; {remedy}")]
    Excess {
        /// The part.
        part: String,
        /// The first resource that runs out: how many of how many.
        excess: String,
        /// What may fit.
        remedy: &'static str,
    },
    /// A clock is not reached.
    #[error("the clock {clock} reaches {achieved:.2} MHz on {part}, {wanted:.2} MHz are asked for")]
    Slow {
        /// The part.
        part: String,
        /// The clock.
        clock: String,
        /// What it reaches, in MHz.
        achieved: f64,
        /// What is asked for.
        wanted: f64,
    },
    /// A path between two clocks that is longer than the edges it goes between.
    #[error(
        "a path from {from} to {to} takes {length:.2} ns on {part}, {most:.2} ns are between their edges"
    )]
    Crossing {
        /// The part.
        part: String,
        /// The clock that it comes from.
        from: String,
        /// The clock that it goes to.
        to: String,
        /// Its length in ns.
        length: f64,
        /// What it may take, in ns.
        most: f64,
    },
    /// A cell of a routed part without a model.
    #[error("the routed cells cannot be simulated: {0}; --no-simulation makes the bitstream alone")]
    NoModel(String),
    /// A design that does not turn out the same behind the bitstream.
    #[error("{0}")]
    Bitstream(String),
    /// A library of cells is missing.
    #[error("{} is missing; install the package {package} (scripts/setup --silicon does)", .path.display())]
    Library {
        /// Its file.
        path: std::path::PathBuf,
        /// Its package.
        package: &'static str,
    },
    /// A layout whose reports cannot be read.
    #[error("the reports of qflow do not say this of the layout: {0}")]
    Layout(String),
    /// A unit cannot be emitted.
    #[error(transparent)]
    Emit(#[from] RequestError),
    /// A tool of the flows fails.
    #[error(transparent)]
    Synth(#[from] SynthError),
    /// A simulator fails.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A text cannot be made from its template.
    #[error("a text cannot be made from its template: {0}")]
    Template(#[from] minijinja::Error),
    /// The channels carry no words.
    #[error(transparent)]
    Tmds(#[from] TmdsError),
    /// The pins show no picture.
    #[error(transparent)]
    Screen(#[from] ScreenError),
}
