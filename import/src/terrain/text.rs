//! Words of a text with their places.

use crate::{ImportError, Place, Result};

/// A word and where it begins.
#[derive(Clone, Copy, Debug)]
pub struct Word<'a> {
    /// The characters.
    pub text: &'a str,
    /// Of the first of them.
    pub place: Place,
}

/// The words of a line, from 1; what follows a `#` is left out.
pub fn words(line: &str, number: usize) -> impl Iterator<Item = Word<'_>> {
    let code = line.split('#').next().unwrap_or_default();
    let (mut rest, mut column) = (code, 1);
    std::iter::from_fn(move || {
        let start = rest.find(|c: char| !c.is_whitespace())?;
        column += rest[..start].chars().count();
        rest = &rest[start..];
        let length = rest.find(char::is_whitespace).unwrap_or(rest.len());
        let word = Word {
            text: &rest[..length],
            place: Place {
                line: number,
                column,
            },
        };
        column += word.text.chars().count();
        rest = &rest[length..];
        Some(word)
    })
}

/// The text of a file, or where it stops being text.
pub fn decoded<'a>(bytes: &'a [u8], file: &str) -> Result<&'a str> {
    std::str::from_utf8(bytes).map_err(|error| {
        let good = String::from_utf8_lossy(&bytes[..error.valid_up_to()]);
        let line = good.lines().count().max(1);
        let column = good.lines().last().map_or(0, |line| line.chars().count()) + 1;
        let place = Some(Place { line, column });
        ImportError::new(
            file,
            place,
            "this is not UTF-8 text",
            "a grid of heights is plain text",
        )
    })
}

/// A word for a message: at most a few characters of it.
pub fn shown(word: &str) -> String {
    match word.char_indices().nth(24) {
        Some((end, _)) => format!("`{}..`", &word[..end]),
        None => format!("`{word}`"),
    }
}
