//! How programs are run, and how it is said that one is missing or refuses its input.

use crate::file::{FileError, write};
use std::ffi::OsStr;
use std::io;
use std::path::Path;
use std::process::Command;
use thiserror::Error;

/// Lines kept of what a program said before it gave up.
const KEPT_LINES: usize = 20;

/// An outside program and the package that has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Program {
    /// Name of the program.
    pub name: &'static str,
    /// Package that has it.
    pub package: &'static str,
}

/// Verilator.
pub const VERILATOR: Program = Program::new("verilator", "verilator");
/// The compiler of Icarus Verilog.
pub const ICARUS: Program = Program::new("iverilog", "iverilog");
/// The run time of Icarus Verilog.
pub const VVP: Program = Program::new("vvp", "iverilog");
/// The C++ compiler.
pub const COMPILER: Program = Program::new("g++", "g++");
/// Yosys.
pub const YOSYS: Program = Program::new("yosys", "yosys");
/// The logic synthesis and verification program that comes with Yosys.
pub const YOSYS_ABC: Program = Program::new("yosys-abc", "yosys");

/// Why a program did not do its work.
#[derive(Debug, Error)]
pub enum ToolError {
    /// The program is not there.
    #[error("'{}' was not found; install the package '{}' (scripts/setup does)", .0.name, .0.package)]
    Missing(Program),
    /// The program refused its input.
    #[error("{program} refused the design:\n{message}")]
    Refused {
        /// Program.
        program: &'static str,
        /// Last lines of what it said.
        message: String,
    },
    /// A file could not be read or written.
    #[error(transparent)]
    File(#[from] FileError),
}

/// How a run ended, and what the program said.
pub struct Said {
    /// Exit code; none if a signal ended it.
    pub code: Option<i32>,
    /// Standard output.
    pub output: String,
    /// Standard error.
    pub errors: String,
}

impl Said {
    /// Whether it ended with success.
    pub fn succeeded(&self) -> bool {
        self.code == Some(0)
    }

    /// Standard output and then standard error.
    pub fn all(&self) -> String {
        format!("{}{}", self.output, self.errors)
    }
}

/// Runs a command to its end. Fails when it does not start.
pub fn call(command: &mut Command) -> io::Result<Said> {
    let output = command.output()?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    Ok(Said {
        code: output.status.code(),
        output: text(&output.stdout),
        errors: text(&output.stderr),
    })
}

/// The last lines that are not empty of what a tool said, enough to see its error.
pub fn last_lines(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.trim().is_empty());
    let lines: Vec<&str> = lines.collect();
    lines[lines.len().saturating_sub(6)..].join("\n")
}

impl Program {
    /// The program of a name, and its package.
    pub const fn new(name: &'static str, package: &'static str) -> Program {
        Program { name, package }
    }

    /// Runs the program in a folder; returns what it printed. Fails when the program is missing or ends with a
    /// failure.
    pub fn run<A: AsRef<OsStr>>(
        &self,
        arguments: impl IntoIterator<Item = A>,
        folder: &Path,
    ) -> Result<String, ToolError> {
        let mut command = Command::new(self.name);
        let said = call(command.args(arguments).current_dir(folder));
        let said = said.map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => ToolError::Missing(*self),
            _ => FileError::at(self.name)(error).into(),
        })?;
        if said.succeeded() {
            return Ok(said.output);
        }
        let text = said.all();
        let lines: Vec<&str> = text.lines().collect();
        Err(ToolError::Refused {
            program: self.name,
            message: lines[lines.len().saturating_sub(KEPT_LINES)..].join("\n"),
        })
    }
}

/// Runs a script of Yosys in a folder; returns what it printed. Fails when Yosys is missing or refuses its input.
pub fn yosys(folder: &Path, script: &str, text: &str) -> Result<String, ToolError> {
    write(&folder.join(script), text)?;
    YOSYS.run(["-s", script], folder)
}
