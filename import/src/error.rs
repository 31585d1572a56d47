//! Why a file was not read.

pub use step21::Place;
pub(crate) use step21::{Error, Result};

/// Why a file was not read.
#[derive(Debug, thiserror::Error)]
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
    /// Makes the refusal of a file of what is wrong with it.
    pub(crate) fn of(file: &str) -> impl Fn(Error) -> ImportError {
        move |error| ImportError {
            file: file.to_owned(),
            place: error.place,
            problem: error.problem,
            accepted: error.accepted,
        }
    }
}

/// The text of a file, or where it stops being text.
pub(crate) fn text<'a>(bytes: &'a [u8], accepted: &str) -> Result<&'a str> {
    std::str::from_utf8(bytes).map_err(|error| {
        let problem = "this byte is no UTF-8 text";
        Error::at(bytes, error.valid_up_to(), problem, accepted)
    })
}
