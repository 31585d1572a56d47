//! Reading with a limit: a device that never ends is refused instead of filling the memory.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// The bytes of a file of at most `limit` bytes. Fails when it cannot be read, is a folder, or is larger.
pub fn read(path: &Path, limit: u64) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    let facts = file.metadata()?;
    if facts.is_dir() {
        return Err(io::Error::other("it is a folder; a file is wanted"));
    }
    if facts.len() > limit {
        return Err(too_large(limit));
    }
    let mut bytes = Vec::with_capacity(facts.len() as usize);
    file.take(limit + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limit {
        return Err(too_large(limit));
    }
    Ok(bytes)
}

/// The same of a text in UTF-8. Fails as [`read`] does, and when it is no such text.
pub fn read_text(path: &Path, limit: u64) -> io::Result<String> {
    let text = String::from_utf8(read(path, limit)?);
    text.map_err(|error| {
        let offset = error.utf8_error().valid_up_to();
        io::Error::other(format!("byte {offset} is not UTF-8 text"))
    })
}

fn too_large(limit: u64) -> io::Error {
    let size = match (limit >> 30, limit >> 20) {
        (0, 0) => format!("{limit} bytes"),
        (0, mib) => format!("{mib} MiB"),
        (gib, _) => format!("{gib} GiB"),
    };
    io::Error::other(format!("it is larger than {size}, the most that is read"))
}
