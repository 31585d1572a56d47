//! Files compressed with gzip.

use crate::error::{Result, unusable};
use flate2::read::MultiGzDecoder;
use std::io::Read;

/// Whether bytes begin as gzip's do.
pub fn is_compressed(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1f, 0x8b])
}

/// What was compressed, if it takes at most so many bytes; several members are one file. `file` is the name that
/// messages give it.
pub fn unpack(bytes: &[u8], limit: u64, file: &str) -> Result<Vec<u8>> {
    let mut unpacked = vec![];
    let mut decoder = MultiGzDecoder::new(bytes).take(limit + 1);
    let count = decoder.read_to_end(&mut unpacked).map_err(|error| {
        let accepted = "a whole file compressed with gzip would be accepted";
        unusable(file, format!("it cannot be unpacked ({error})"), accepted)
    })?;
    if count as u64 > limit {
        let problem = format!("it unpacks to more than {limit} bytes");
        let accepted = format!("up to {limit} bytes would be accepted");
        return Err(unusable(file, problem, accepted));
    }
    Ok(unpacked)
}
