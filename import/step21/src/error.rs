//! What is wrong with a file.

use thiserror::Error;

/// Where in a text file, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Line.
    pub line: usize,
    /// Column, in characters.
    pub column: usize,
}

impl Place {
    /// Of a byte of a text whose lines end so.
    pub fn of(bytes: &[u8], at: usize, end: u8) -> Place {
        let before = &bytes[..at.min(bytes.len())];
        let start = before.iter().rposition(|b| *b == end).map_or(0, |k| k + 1);
        let line = before.iter().filter(|b| **b == end).count() + 1;
        let column = String::from_utf8_lossy(&before[start..]).chars().count() + 1;
        Place { line, column }
    }
}

/// What is wrong, where, and what would be accepted.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{}{problem}; {accepted}", .place.map_or(String::new(), |p| format!("{}:{}: ", p.line, p.column)))]
pub struct Error {
    /// Nothing of the file as a whole.
    pub place: Option<Place>,
    /// What is wrong.
    pub problem: String,
    /// What would be accepted.
    pub accepted: String,
}

/// What comes of reading a file.
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// Of the file as a whole.
    pub fn whole(problem: impl ToString, accepted: impl ToString) -> Error {
        Error {
            place: None,
            problem: problem.to_string(),
            accepted: accepted.to_string(),
        }
    }

    /// At a byte of a file.
    pub fn at(bytes: &[u8], at: usize, problem: impl ToString, accepted: impl ToString) -> Error {
        Error::whole(problem, accepted).placed(Place::of(bytes, at, b'\n'))
    }

    /// The same at a place.
    pub fn placed(self, place: Place) -> Error {
        let place = Some(place);
        Error { place, ..self }
    }
}

impl From<Error> for String {
    fn from(error: Error) -> String {
        error.to_string()
    }
}
