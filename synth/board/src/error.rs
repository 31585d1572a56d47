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
    #[error("there is no board `{0}`; the boards are {1}")]
    Unknown(String, String),
    /// The description of a board is none, or has a value that nothing can be made of.
    #[error("{0}")]
    Description(String),
    /// No dividers give the clock that is asked for.
    #[error("no dividers of the PLL make {0} Hz for the pixels out of the {1} Hz of the board")]
    NoClock(u64, u64),
    /// The design does not fit the part: the first resource that runs out, how many of how many, and what may fit.
    #[error("the design does not fit {0}: it takes {1}; {2}")]
    Excess(String, String, &'static str),
    /// The part has enough of everything, and yet no seed finds a place for all of it.
    #[error(
        "the router finds no place for all cells together on {0}, which has enough of each kind; {1}"
    )]
    Crowded(String, &'static str),
    /// A clock is not reached, or a path between two clocks is longer than the edges it goes between.
    #[error("{0}")]
    Slow(String),
    /// A cell of a routed part without a model.
    #[error("the routed cells cannot be simulated: {0}; --no-simulation makes the bitstream alone")]
    NoModel(String),
    /// A design that does not turn out the same behind the bitstream.
    #[error("{0}")]
    Bitstream(String),
    /// The file of a library of cells, and its package, that is missing.
    #[error("{path} is missing; install the package {1} (scripts/setup --silicon does)", path = .0.display())]
    Library(std::path::PathBuf, &'static str),
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
