//! Printing: one JSON document, or text for a person; progress bars on standard error when that is a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::io::{IsTerminal, Write};

/// Prints a value as one JSON document. A closed pipe is not an error of ours.
pub fn json(value: &impl Serialize) {
    let text = serde_json::to_string_pretty(value).expect("reports have no unserialisable keys");
    let _ = writeln!(std::io::stdout(), "{text}");
}

/// Prints text, followed by a new line.
pub fn text(value: impl std::fmt::Display) {
    let _ = writeln!(std::io::stdout(), "{value}");
}

/// Prints a warning on standard error.
pub fn warning(value: impl std::fmt::Display) {
    let _ = writeln!(std::io::stderr(), "warning: {value}");
}

/// A progress bar of `length` steps, hidden unless standard error is a terminal.
pub fn progress(length: u64, what: &'static str) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{msg:<28} {bar:40} {percent:>3} % {eta:>6}")
        .expect("a valid template");
    ProgressBar::new(length)
        .with_style(style)
        .with_message(what)
}
