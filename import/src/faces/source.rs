//! The text of a face list, and how errors in it are reported.

use super::vector::{Vector, length, unit};
use crate::{ImportError, Place, Result};
use toml::Spanned;

/// Largest coordinate and radius, scene units: beyond it double precision has no micrometres left in a metre.
pub const MAX_NUMBER: f64 = 1e9;

/// The text of a file.
#[derive(Clone, Copy)]
pub struct Source<'a> {
    pub file: &'a str,
    pub text: &'a str,
}

impl Source<'_> {
    /// An error at a byte of the text.
    pub fn error_at(
        &self,
        at: usize,
        problem: impl ToString,
        accepted: impl ToString,
    ) -> ImportError {
        let place = Place::of(self.text.as_bytes(), at, b'\n');
        ImportError::new(self.file, Some(place), problem, accepted)
    }

    /// An error at a value.
    pub fn error<T>(
        &self,
        value: &Spanned<T>,
        problem: impl ToString,
        accepted: impl ToString,
    ) -> ImportError {
        self.error_at(value.span().start, problem, accepted)
    }

    /// Numbers of a value, which have to be finite and not too large.
    pub fn checked<T>(&self, value: &Spanned<T>, numbers: &[f64]) -> Result<()> {
        let Some(wrong) = numbers.iter().find(|v| v.is_nan() || v.abs() > MAX_NUMBER) else {
            return Ok(());
        };
        let least = -MAX_NUMBER;
        let accepted = format!("finite numbers from {least:e} to {MAX_NUMBER:e} are possible");
        Err(self.error(value, format!("{wrong} is out of range"), accepted))
    }

    pub fn point(&self, value: &Spanned<Vector>) -> Result<Vector> {
        self.checked(value, value.as_ref())?;
        Ok(*value.as_ref())
    }

    /// A vector of length 1 along a written one.
    pub fn direction(&self, value: &Spanned<Vector>) -> Result<Vector> {
        let vector = self.point(value)?;
        if length(vector) < 1e-9 {
            let accepted = "a vector with at least one number other than 0 is needed";
            return Err(self.error(value, format!("{vector:?} has no direction"), accepted));
        }
        Ok(unit(vector))
    }

    /// Lengths above 0.
    pub fn lengths<T>(&self, value: &Spanned<T>, lengths: &[f64]) -> Result<()> {
        for length in lengths {
            self.checked(value, &[*length])?;
            if *length < 1e-9 {
                let problem = format!("{length} is not above 0");
                return Err(self.error(value, problem, "a length above 0 is needed"));
            }
        }
        Ok(())
    }
}
