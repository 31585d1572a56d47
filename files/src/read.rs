//! Reading with a limit: a device that never ends is refused instead of filling the memory.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// The bytes of a file of at most `limit` bytes.
///
/// # Errors
///
/// When it cannot be read, is a folder, or is larger.
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

/// The same of a text in UTF-8.
///
/// # Errors
///
/// As [`read`], and when it is no such text.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_up_to_the_limit_are_read_and_larger_ones_and_endless_ones_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file");
        std::fs::write(&path, "12345").unwrap();
        assert_eq!(read(&path, 5).unwrap(), b"12345");
        assert_eq!(read_text(&path, 5).unwrap(), "12345");
        for (path, limit, said) in [
            (path.as_path(), 4, "larger than 4 bytes"),
            (Path::new("/dev/zero"), 3 << 20, "larger than 3 MiB"),
            (folder.path(), 4, "a folder"),
        ] {
            let message = read(path, limit).unwrap_err().to_string();
            assert!(message.contains(said), "{message}");
        }
        std::fs::write(&path, b"ab\xff").unwrap();
        let message = read_text(&path, 5).unwrap_err().to_string();
        assert!(message.contains("byte 2"), "{message}");
    }
}
