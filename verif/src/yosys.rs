//! Yosys: its scripts, and netlists whose registers are cut.

pub(crate) mod cut;

use crate::tool::{ToolError, YOSYS, write};
use std::path::Path;

/// Runs a script of Yosys in a folder; returns what it printed.
pub(crate) fn yosys(folder: &Path, script: &str, text: &str) -> Result<String, ToolError> {
    write(&folder.join(script), text)?;
    YOSYS.run(["-s", script], folder)
}
