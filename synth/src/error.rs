//! Why a unit could not be synthesised.

use imogene_contract::RequestError;
use imogene_tools::{FileError, last_lines};
use thiserror::Error;

/// A synthesis that did not happen.
#[derive(Debug, Error)]
pub enum SynthError {
    /// The unit cannot be emitted.
    #[error("{0}")]
    Emit(#[from] RequestError),
    /// A target whose cells have no simulation models here.
    #[error(
        "the netlist for `{0}` cannot be simulated; targets with models of their cells: ice40-hx8k, ice40-up5k, ecp5-45k, ecp5-85k"
    )]
    NoModels(&'static str),
    /// A target with a cell without a simulation model.
    #[error(
        "the netlist for `{0}` has the cell `{1}`, of which Yosys has no simulation model; ice40-hx8k has models of all its cells"
    )]
    NoModel(&'static str, String),
    /// A tool that is not installed, and the package that contains it.
    #[error(
        "`{0}` is not installed (Python package {1}); `scripts/setup --synth` installs it, or set {variable} to the folder \
         that holds it",
        variable = imogene_tools::FOLDER_VARIABLE
    )]
    MissingTool(&'static str, &'static str),
    /// A tool ran and failed.
    #[error("{tool} failed: {message}")]
    Tool {
        /// Program.
        tool: &'static str,
        /// Last lines of what it said.
        message: String,
    },
    /// The report of a tool is not as expected, and why.
    #[error("the report of {0} cannot be read: {1}")]
    Report(&'static str, String),
    /// The file of a baseline is none, and why.
    #[error("baseline {0}: {1}")]
    Baseline(String, String),
    /// A row has no baseline.
    #[error("the baseline has no figures of {0}; `imogene synth --table` measures every row again")]
    NoBaseline(String),
    /// Figures of other tools are not comparable.
    #[error(
        "the baseline of {row} was measured with {baseline}, and here is {here}; `scripts/setup --synth` installs the tools of the \
         table, `imogene synth --table` makes it with those that are here"
    )]
    OtherTools {
        /// The row.
        row: String,
        /// Tools of the baseline.
        baseline: String,
        /// Tools that are here.
        here: String,
    },
    /// A peer cannot be measured.
    #[error("{0}")]
    Peer(#[from] PeerError),
    /// The picture could not be drawn.
    #[error("the picture cannot be drawn: {0}")]
    Picture(String),
    /// A file could not be read or written.
    #[error(transparent)]
    File(#[from] FileError),
}

impl SynthError {
    /// What is wrong with the report of a tool.
    pub fn report(tool: &'static str, problem: impl ToString) -> Self {
        Self::Report(tool, problem.to_string())
    }

    /// What a tool said before it gave up.
    pub fn tool(tool: &'static str, said: &str) -> Self {
        let message = last_lines(said);
        Self::Tool { tool, message }
    }
}

/// Why a peer cannot be measured.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum PeerError {
    /// A path at which there is no file or no folder.
    #[error("{0}: there is no such {1}")]
    Missing(String, &'static str),
    /// A file is no Verilog by its name.
    #[error("{0}: a file of Verilog ends in .v, one of SystemVerilog in .sv")]
    Ending(String),
    /// A name or value cannot stand in a command of Yosys: what it should be, and what is accepted.
    #[error("`{0}` is no {1}: {2}")]
    Word(String, &'static str, &'static str),
    /// No module has the name of the top, but these are there.
    #[error("there is no module `{0}`; the files hold {modules}", modules = list(.1))]
    Top(String, Vec<String>),
    /// No port is the clock.
    #[error(
        "`{top}` has no clock port {wanted} of one bit; `--clock PORT` names it; the ports are {}",
        list(ports)
    )]
    Clock {
        /// The top module.
        top: String,
        /// The names looked for.
        wanted: String,
        /// The ports that there are.
        ports: Vec<String>,
    },
    /// A port, and its top module, that no register can stand at.
    #[error("port `{0}` of `{1}` is an inout; a register harness needs inputs and outputs")]
    Inout(String, String),
    /// A design without input or output.
    #[error("`{0}` has no {1} beside its clock: there is nothing to measure")]
    NoData(String, &'static str),
    /// Yosys does not take the files.
    #[error("Yosys refuses the peer: {0}")]
    Refused(String),
}

fn list(names: &[String]) -> String {
    match names {
        [] => "none".to_owned(),
        names => names.join(", "),
    }
}
