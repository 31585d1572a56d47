//! Why a file was not read.

pub use step21::Place;
use thiserror::Error;

/// Why a file was not read.
#[derive(Debug, Error)]
#[error("{file}{}: {problem}; {accepted}", .place.map_or(String::new(), |p| format!(":{}:{}", p.line, p.column)))]
pub struct ImportError {
    /// Name of the file.
    pub file: String,
    /// Where its text is not what its format asks for; nothing if it cannot be used as a whole.
    pub place: Option<Place>,
    /// What is wrong.
    pub problem: String,
    /// What would be accepted.
    pub accepted: String,
}

impl ImportError {
    /// A refusal of a file as a whole, or at a place of it: what is wrong, and what would be accepted.
    pub(crate) fn new(
        file: &str,
        place: Option<Place>,
        problem: impl ToString,
        accepted: impl ToString,
    ) -> ImportError {
        ImportError {
            file: file.to_owned(),
            place,
            problem: problem.to_string(),
            accepted: accepted.to_string(),
        }
    }
}

/// What comes of reading a file.
pub type Result<T, E = ImportError> = std::result::Result<T, E>;

/// A file that is text.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub file: &'a str,
    pub text: &'a str,
}

impl<'a> Source<'a> {
    /// The text of a file, or where it stops being text.
    pub fn of(bytes: &'a [u8], file: &'a str, accepted: &str) -> Result<Source<'a>> {
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let place = Place::of(bytes, error.valid_up_to(), b'\n');
            ImportError::new(file, Some(place), "this byte is no UTF-8 text", accepted)
        })?;
        Ok(Source { file, text })
    }

    pub fn error_at(
        &self,
        at: usize,
        problem: impl ToString,
        accepted: impl ToString,
    ) -> ImportError {
        let place = Place::of(self.text.as_bytes(), at, b'\n');
        ImportError::new(self.file, Some(place), problem, accepted)
    }
}

/// A refusal of a file as a whole.
pub(crate) fn unusable(file: &str, problem: impl ToString, accepted: impl ToString) -> ImportError {
    ImportError::new(file, None, problem, accepted)
}
