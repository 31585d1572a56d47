//! The bytes of a STEP file, and how errors in it are reported.

use crate::{ImportError, Place};

/// A file.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// Its name.
    pub file: &'a str,
    /// Its bytes: ASCII, apart from what stands in strings and comments.
    pub bytes: &'a [u8],
}

impl Source<'_> {
    /// An error at a byte.
    pub fn error(
        &self,
        at: usize,
        problem: impl Into<String>,
        accepted: impl Into<String>,
    ) -> ImportError {
        let before = &self.bytes[..at.min(self.bytes.len())];
        let newline = before.iter().rposition(|byte| *byte == b'\n');
        let own_line = &before[newline.map_or(0, |place| place + 1)..];
        ImportError::Malformed {
            file: self.file.to_owned(),
            place: Place {
                line: before.iter().filter(|byte| **byte == b'\n').count() + 1,
                column: String::from_utf8_lossy(own_line).chars().count() + 1,
            },
            problem: problem.into(),
            accepted: accepted.into(),
        }
    }

    /// The file as a whole cannot be used.
    pub fn unusable(&self, problem: impl Into<String>, accepted: impl Into<String>) -> ImportError {
        ImportError::Unusable {
            file: self.file.to_owned(),
            problem: problem.into(),
            accepted: accepted.into(),
        }
    }
}
