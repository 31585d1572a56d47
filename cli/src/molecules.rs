//! Structure files: those that are imported, and those that scenes name.

use crate::failure::Failure;
use imogene_import::{is_compressed, unpack};
use std::path::Path;

/// Most bytes of a file, as it is and unpacked: ten million atoms in PDB's columns take eight hundred million.
const MAX_BYTES: u64 = 1 << 30;

/// The bytes of a file, unpacked if they are compressed.
pub fn load(path: &Path) -> Result<Vec<u8>, Failure> {
    let bytes = imogene_files::read(path, MAX_BYTES)
        .map_err(|e| Failure::Input(format!("cannot read '{}': {e}", path.display())))?;
    if !is_compressed(&bytes) {
        return Ok(bytes);
    }
    unpack(&bytes, MAX_BYTES, &path.display().to_string()).map_err(Failure::input)
}
