//! Why a file was not read.

pub(crate) use step21::Result;
pub use step21::{Error, Place};

/// Why a file was not read.
#[derive(Debug, thiserror::Error)]
#[error("{file}:{}{error}", if error.place.is_some() { "" } else { " " })]
pub struct ImportError {
    /// Name of the file.
    pub file: String,
    /// What is wrong with it, and where; nowhere if it cannot be used as a whole.
    pub error: Error,
}

impl ImportError {
    /// Makes the refusal of a file of what is wrong with it.
    pub(crate) fn of(file: &str) -> impl Fn(Error) -> ImportError {
        move |error| {
            let file = file.to_owned();
            ImportError { file, error }
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
