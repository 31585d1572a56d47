//! Words of a text with their places.

use crate::Place;

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

/// A word for a message: at most a few characters of it.
pub fn shown(word: &str) -> String {
    match word.char_indices().nth(24) {
        Some((end, _)) => format!("`{}..`", &word[..end]),
        None => format!("`{word}`"),
    }
}
