//! Why a file was not read.

use std::fmt;
use thiserror::Error;

/// Where in a text file, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Line.
    pub line: usize,
    /// Column, in characters.
    pub column: usize,
}

#[cfg(any(feature = "pdb", feature = "cad", feature = "terrain"))]
impl Place {
    /// Of a byte of a text whose lines end so.
    pub(crate) fn of(bytes: &[u8], at: usize, end: u8) -> Place {
        let before = &bytes[..at.min(bytes.len())];
        let start = before.iter().rposition(|b| *b == end).map_or(0, |k| k + 1);
        Place {
            line: before.iter().filter(|b| **b == end).count() + 1,
            column: String::from_utf8_lossy(&before[start..]).chars().count() + 1,
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

/// Why a file was not read.
#[derive(Debug, Error)]
pub enum ImportError {
    /// The text is not what its format asks for.
    #[error("{file}:{place}: {problem}; {accepted}")]
    Malformed {
        /// Name of the file.
        file: String,
        /// Where.
        place: Place,
        /// What is wrong.
        problem: String,
        /// What would be accepted.
        accepted: String,
    },
    /// The file as a whole cannot be used.
    #[error("{file}: {problem}; {accepted}")]
    Unusable {
        /// Name of the file.
        file: String,
        /// What is wrong.
        problem: String,
        /// What would be accepted.
        accepted: String,
    },
}

impl ImportError {
    /// A refusal of a file as a whole, or at a place of it: what is wrong, and what would be accepted.
    pub(crate) fn new(
        file: &str,
        place: Option<Place>,
        problem: impl ToString,
        accepted: impl ToString,
    ) -> ImportError {
        let (file, problem, accepted) =
            (file.to_owned(), problem.to_string(), accepted.to_string());
        match place {
            Some(place) => Self::Malformed {
                file,
                place,
                problem,
                accepted,
            },
            None => Self::Unusable {
                file,
                problem,
                accepted,
            },
        }
    }
}

/// What comes of reading a file.
pub type Result<T, E = ImportError> = std::result::Result<T, E>;

/// The text of a file, or where it stops being text.
#[cfg(any(feature = "cad", feature = "terrain"))]
pub(crate) fn decoded<'a>(bytes: &'a [u8], file: &str, accepted: &str) -> Result<&'a str> {
    std::str::from_utf8(bytes).map_err(|error| {
        let place = Place::of(bytes, error.valid_up_to(), b'\n');
        ImportError::new(file, Some(place), "this byte is no UTF-8 text", accepted)
    })
}

/// A refusal of a file as a whole.
pub(crate) fn unusable(file: &str, problem: impl ToString, accepted: impl ToString) -> ImportError {
    ImportError::new(file, None, problem, accepted)
}

#[cfg(all(test, feature = "terrain"))]
mod tests {
    use super::*;

    #[test]
    fn a_byte_that_is_no_text_has_its_place() {
        let cases: [(&[u8], &str); 4] = [
            (b"\xff", "1:1"),
            (b"1 2\n3 \xff", "2:3"),
            (b"1 2\n\xff", "2:1"),
            (b"\xc3\xa9\n\xc3\xa9\xff", "2:2"),
        ];
        for (bytes, place) in cases {
            let error = decoded(bytes, "grid", "a text").expect_err("no text");
            let wanted = format!("grid:{place}: this byte is no UTF-8 text; a text");
            assert_eq!(error.to_string(), wanted);
        }
    }
}
