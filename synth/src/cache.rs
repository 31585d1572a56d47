//! Results kept by what they depend on, so that a table is made again only where something changed.

use imogene_tools::{Kept, target_folder};

/// Digest of a Verilog text; comment lines do not count, for they change no cell.
pub fn digest(verilog: &str) -> String {
    let lines = verilog.lines();
    imogene_tools::digest(lines.filter(|line| !line.trim_start().starts_with("//")))
}

/// Whether kept results count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cache {
    /// A result of the same Verilog and tools is taken as it is.
    #[default]
    Use,
    /// Everything is synthesised, and then kept.
    Renew,
}

/// The place of a result that depends on these texts alone. Outside a checkout nothing is kept.
pub fn kept(parts: &[&str]) -> Kept {
    let folder = target_folder().map(|folder| folder.join("synth-cache"));
    Kept::new(folder, parts)
}
