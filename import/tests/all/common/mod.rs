//! What several tests use.

pub mod bar;
pub mod cases;
pub mod list;
pub mod points;
pub mod structure;
pub mod winding;

/// Asks a message for some words.
#[track_caller]
pub fn says(message: impl ToString, words: &str) {
    let message = message.to_string();
    assert!(message.contains(words), "{message}");
}
