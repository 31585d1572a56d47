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
        "the netlist for `{target}` cannot be simulated; targets with models of their cells: ice40-hx8k, ice40-up5k, ecp5-45k, ecp5-85k"
    )]
    NoModels {
        /// The target.
        target: &'static str,
    },
    /// A cell without a simulation model.
    #[error(
        "the netlist for `{target}` has the cell `{cell}`, of which Yosys has no simulation model; ice40-hx8k has models of all its cells"
    )]
    NoModel {
        /// The cell.
        cell: String,
        /// The target.
        target: &'static str,
    },
    /// A tool is not installed.
    #[error(
        "`{tool}` is not installed (Python package {package}); `scripts/setup --synth` installs it, or set {} to the folder \
         that holds it",
        imogene_tools::FOLDER_VARIABLE
    )]
    MissingTool {
        /// Program looked for.
        tool: &'static str,
        /// Package that contains it.
        package: &'static str,
    },
    /// A tool ran and failed.
    #[error("{tool} failed: {message}")]
    Tool {
        /// Program.
        tool: String,
        /// Last lines of what it said.
        message: String,
    },
    /// The report of a tool is not as expected.
    #[error("the report of {tool} cannot be read: {problem}")]
    Report {
        /// Program.
        tool: &'static str,
        /// What is wrong.
        problem: String,
    },
    /// The file of a baseline is none.
    #[error("baseline {path}: {problem}")]
    Baseline {
        /// The file.
        path: String,
        /// What is wrong.
        problem: String,
    },
    /// A row has no baseline.
    #[error(
        "the baseline has no figures of {row}; `imogene synth --table` measures every row again"
    )]
    NoBaseline {
        /// The row.
        row: String,
    },
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
        Self::Report {
            tool,
            problem: problem.to_string(),
        }
    }

    /// What a tool said before it gave up.
    pub(crate) fn tool(tool: &str, said: &str) -> Self {
        Self::Tool {
            tool: tool.to_owned(),
            message: last_lines(said),
        }
    }
}

/// Why a peer cannot be measured.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum PeerError {
    /// A file is not there.
    #[error("{path}: there is no such {kind}")]
    Missing {
        /// The path.
        path: String,
        /// File or folder.
        kind: &'static str,
    },
    /// A file is no Verilog by its name.
    #[error("{path}: a file of Verilog ends in .v, one of SystemVerilog in .sv")]
    Ending {
        /// The path.
        path: String,
    },
    /// A name or value cannot stand in a command of Yosys.
    #[error("`{text}` is no {what}: {accepted}")]
    Word {
        /// The text.
        text: String,
        /// What it should be.
        what: &'static str,
        /// What is accepted.
        accepted: &'static str,
    },
    /// No module has the name of the top.
    #[error("there is no module `{top}`; the files hold {}", list(modules))]
    Top {
        /// The name.
        top: String,
        /// The modules that there are.
        modules: Vec<String>,
    },
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
    /// A port that no register can stand at.
    #[error("port `{port}` of `{top}` is an inout; a register harness needs inputs and outputs")]
    Inout {
        /// The top module.
        top: String,
        /// The port.
        port: String,
    },
    /// A design without data.
    #[error("`{top}` has no {direction} beside its clock: there is nothing to measure")]
    NoData {
        /// The top module.
        top: String,
        /// Input or output.
        direction: &'static str,
    },
    /// Yosys does not take the files.
    #[error("Yosys refuses the peer: {message}")]
    Refused {
        /// Its error.
        message: String,
    },
}

fn list(names: &[String]) -> String {
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}
