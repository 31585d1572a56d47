//! Outside programs: how they are run, and how it is said that one is missing or refuses its input.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
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
pub const VERILATOR: Program = Program {
    name: "verilator",
    package: "verilator",
};
/// The compiler of Icarus Verilog.
pub const ICARUS: Program = Program {
    name: "iverilog",
    package: "iverilog",
};
/// The run time of Icarus Verilog.
pub const VVP: Program = Program {
    name: "vvp",
    package: "iverilog",
};
/// The C++ compiler.
pub const COMPILER: Program = Program {
    name: "g++",
    package: "g++",
};
/// Yosys.
pub const YOSYS: Program = Program {
    name: "yosys",
    package: "yosys",
};

/// The logic synthesis and verification program that comes with Yosys.
pub const YOSYS_ABC: Program = Program {
    name: "yosys-abc",
    package: "yosys",
};

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
    #[error("{}: {source}", path.display())]
    File {
        /// File or folder.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
}

impl ToolError {
    /// Makes an error of the system into one that names the file.
    pub fn file(path: &Path) -> impl FnOnce(std::io::Error) -> ToolError + '_ {
        move |source| ToolError::File {
            path: path.to_path_buf(),
            source,
        }
    }
}

impl Program {
    /// Runs the program in a folder; returns what it printed.
    ///
    /// # Errors
    ///
    /// When the program is missing or ends with a failure.
    pub fn run<A: AsRef<OsStr>>(
        &self,
        arguments: impl IntoIterator<Item = A>,
        folder: &Path,
    ) -> Result<String, ToolError> {
        let output = Command::new(self.name)
            .args(arguments)
            .current_dir(folder)
            .output()
            .map_err(|error| self.not_started(error))?;
        if output.status.success() {
            return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
        }
        let said = [output.stdout, output.stderr].concat();
        let text = String::from_utf8_lossy(&said);
        let lines: Vec<&str> = text.lines().collect();
        Err(ToolError::Refused {
            program: self.name,
            message: lines[lines.len().saturating_sub(KEPT_LINES)..].join("\n"),
        })
    }

    /// Why the program did not start, from what the system says.
    pub fn not_started(&self, error: std::io::Error) -> ToolError {
        match error.kind() {
            std::io::ErrorKind::NotFound => ToolError::Missing(*self),
            _ => ToolError::file(Path::new(self.name))(error),
        }
    }
}

/// Writes a text file.
///
/// # Errors
///
/// When it cannot be written; the error names it.
pub fn write(path: &Path, text: &str) -> Result<(), ToolError> {
    std::fs::write(path, text).map_err(ToolError::file(path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_program_names_its_package() {
        let program = Program {
            name: "imogene-no-such-program",
            package: "some-package",
        };
        let outcome = program.run(["--version"], Path::new("."));
        let message = outcome.expect_err("there is no such program").to_string();
        assert!(message.contains("imogene-no-such-program"), "{message}");
        assert!(message.contains("package 'some-package'"), "{message}");
    }

    #[test]
    fn a_refusal_has_the_words_of_the_program() {
        let outcome = COMPILER.run(["no-such-file.cpp"], Path::new("."));
        let message = outcome.expect_err("there is no such file").to_string();
        assert!(message.contains("no-such-file.cpp"), "{message}");
    }
}
