//! What can be wrong with a scene, said so that its author sees at once what to change.

use std::fmt::Display;
use thiserror::Error;

/// A scene that is refused. Every message says what is wrong, where, and what would be accepted.
#[derive(Debug, Error)]
pub enum SceneError {
    /// The file, by its path as given, cannot be opened or read, for the system's reason.
    #[error(
        "{0}: the scene file cannot be read ({1}); give the path of a readable TOML scene file"
    )]
    Unreadable(String, #[source] std::io::Error),
    /// The file, by its path, is not text: the line of the first bad byte, from 1, and its place in the file, from 0.
    #[error("{0}:{1}: byte {2} is not UTF-8 text; a scene file is a TOML text in UTF-8")]
    NotText(String, usize, usize),
    /// The text is not TOML, or a key or a value is not one of the format.
    #[error("{file}:{line}:{column}: {problem}\n  {line} | {text}")]
    Syntax {
        /// Path as given by the caller.
        file: String,
        /// Line of the first character concerned, from 1.
        line: usize,
        /// Column of that character, from 1.
        column: usize,
        /// What is wrong and what would be accepted.
        problem: String,
        /// The line itself.
        text: String,
    },
    /// A value is of the right type and cannot be used.
    #[error("{place}: {problem}; {accepted}")]
    Value {
        /// The part of the scene and its key, for instance ``object `lid`, cuts[0].normal``.
        place: String,
        /// What is wrong, with the value.
        problem: String,
        /// What would be accepted.
        accepted: String,
    },
    /// An error inside a file, by its path as given.
    #[error("{0}: {1}")]
    InFile(String, Box<SceneError>),
    /// The scene cannot be written as TOML, for the writer's reason.
    #[error("the scene cannot be written as TOML ({0})")]
    Unwritable(#[source] toml::ser::Error),
}

impl SceneError {
    pub(super) fn value(
        place: impl Display,
        problem: impl Display,
        accepted: impl Display,
    ) -> Self {
        Self::Value {
            place: place.to_string(),
            problem: problem.to_string(),
            accepted: accepted.to_string(),
        }
    }

    /// The same error with the name of the file it was found in.
    pub(super) fn in_file(self, file: &str) -> Self {
        match self {
            Self::Value { .. } => Self::InFile(file.to_owned(), Box::new(self)),
            located => located,
        }
    }

    /// The TOML reader's error, placed on its line.
    pub(super) fn syntax(file: &str, text: &str, error: &toml::de::Error) -> Self {
        let start = error.span().map_or(0, |span| span.start);
        let (line, column) = line_and_column(text, start);
        Self::Syntax {
            file: file.to_owned(),
            line,
            column,
            problem: in_plain_words(error.message()),
            text: around(text.lines().nth(line - 1).unwrap_or(""), column),
        }
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
    let plain = |said: String, (word, plain)| said.replace(word, plain);
    WORDS.into_iter().fold(message.trim_end().to_owned(), plain)
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
