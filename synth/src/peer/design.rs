//! A design of another project: what must hold of it before any tool runs.

use crate::error::PeerError;
use std::path::{Path, PathBuf};

/// A design of another project, from files of the user.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Peer {
    /// Verilog files in the order they are read, `.v`, or `.sv` for SystemVerilog.
    pub files: Vec<PathBuf>,
    /// Top module.
    pub top: String,
    /// Clock port; `clk` or `clock` if not given.
    pub clock: Option<String>,
    /// Folders of included files.
    pub include: Vec<PathBuf>,
    /// Parameters of the top module and their values.
    pub parameters: Vec<(String, String)>,
}

impl Peer {
    /// Checks everything that needs no tool. Fails when a file or folder is missing, or a name, a value or an ending
    /// is not legal.
    pub fn check(&self) -> Result<(), PeerError> {
        for file in &self.files {
            if !file.is_file() {
                return Err(missing(file, "file"));
            }
            is_system_verilog(file)?;
            // Without its folder it goes into a command of Yosys.
            let name = file.file_name().and_then(|name| name.to_str());
            check_word(name.unwrap_or_default(), "file name", is_value)?;
        }
        if let Some(folder) = self.include.iter().find(|folder| !folder.is_dir()) {
            return Err(missing(folder, "folder"));
        }
        check_word(&self.top, "module", is_name)?;
        for (name, value) in &self.parameters {
            check_word(name, "parameter", is_name)?;
            check_word(value, "value", is_value)?;
        }
        Ok(())
    }
}

fn missing(path: &Path, kind: &'static str) -> PeerError {
    PeerError::Missing(path.display().to_string(), kind)
}

pub(super) fn is_system_verilog(file: &Path) -> Result<bool, PeerError> {
    match file.extension().and_then(|ending| ending.to_str()) {
        Some("v") => Ok(false),
        Some("sv") => Ok(true),
        _ => Err(PeerError::Ending(file.display().to_string())),
    }
}

fn is_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_' || c == '$'
}

fn is_value(c: char) -> bool {
    is_name(c) || "'.+-".contains(c)
}

fn check_word(text: &str, what: &'static str, is_legal: fn(char) -> bool) -> Result<(), PeerError> {
    if !text.is_empty() && !text.starts_with('-') && text.chars().all(is_legal) {
        return Ok(());
    }
    let accepted = match is_legal('.') {
        true => "letters, digits, _ $ ' . + -, not - first",
        false => "letters, digits, _ $",
    };
    Err(PeerError::Word(text.to_owned(), what, accepted))
}
