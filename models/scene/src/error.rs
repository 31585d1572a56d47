//! What can be wrong with a scene, said so that its author sees at once what to change.

use std::fmt::Display;
use thiserror::Error;

/// A scene that is refused, or cannot be written. The message says what is wrong, where, and what would be accepted.
#[derive(Debug, Error)]
#[error("{0}")]
pub struct SceneError(pub(super) String);

impl SceneError {
    /// A value of the right type that cannot be used; its place is the part of the scene and its key, for instance
    /// ``object `lid`, cuts[0].normal``.
    pub(super) fn value(
        place: impl Display,
        problem: impl Display,
        accepted: impl Display,
    ) -> Self {
        Self(format!("{place}: {problem}; {accepted}"))
    }

    /// The TOML reader's error, placed on its line.
    pub(super) fn syntax(file: &str, text: &str, error: &toml::de::Error) -> Self {
        let start = error.span().map_or(0, |span| span.start);
        let (line, column) = line_and_column(text, start);
        let problem = in_plain_words(error.message());
        let text = around(text.lines().nth(line - 1).unwrap_or(""), column);
        Self(format!(
            "{file}:{line}:{column}: {problem}\n  {line} | {text}"
        ))
    }
}

/// Characters of a line that are shown.
pub const SHOWN: usize = 160;

/// The part of a line around a column, from 1; a short line is shown whole.
pub fn around(line: &str, column: usize) -> String {
    let count = line.chars().count();
    if count <= SHOWN {
        return line.to_owned();
    }
    let first = column.saturating_sub(SHOWN / 2).min(count - SHOWN);
    let shown: String = line.chars().skip(first).take(SHOWN).collect();
    let before = if first > 0 { ".. " } else { "" };
    let after = if first + SHOWN < count { " .." } else { "" };
    format!("{before}{shown}{after}")
}

const COUNT: &str = "expected a whole number that is not negative";

/// What stands in a message for names of Rust types, and what a scene may have in the place of `[camera]`.
const WORDS: [(&str, &str); 9] = [
    ("\n", ", "),
    ("expected usize", COUNT),
    ("expected f64", "expected a number"),
    (
        "expected u32",
        "expected a whole number that is not negative, at most 4294967295",
    ),
    ("expected u64", COUNT),
    (" as i128", ""),
    ("duplicate key", "duplicate key; a table has a key once"),
    ("expected a sequence", "expected an array of numbers [...]"),
    (
        "missing field `camera`",
        "missing field `camera`; a scene needs `[camera]`, or `[[cameras]]` with at least one",
    ),
];

/// The reader's message on one line, with its names of Rust types put into words.
pub fn in_plain_words(message: &str) -> String {
    let message = message.trim_end().to_owned();
    let words = WORDS.into_iter();
    words.fold(message, |said, (word, plain)| said.replace(word, plain))
}

/// Line and column, from 1, of the character at byte `offset` of `text`.
pub fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let mut end = offset.min(text.len());
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    let before = &text[..end];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = before.matches('\n').count() + 1;
    (line, before[line_start..].chars().count() + 1)
}
