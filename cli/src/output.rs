//! What a command puts out: one JSON document, or text for a person, on standard output; files; progress bars on
//! standard error when that is a terminal.

use crate::failure::Failure;
use crate::process;
use imogene_files::{Identity, Outputs, end_process};
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Stdout, Write};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{LazyLock, Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

/// Text that waits no longer than this while more comes: a person sees slow results one by one.
const LATEST: Duration = Duration::from_millis(100);

/// Standard output, written through one buffer.
struct Printer {
    out: BufWriter<Stdout>,
    flushed: Instant,
}

static PRINTER: LazyLock<Mutex<Printer>> = LazyLock::new(|| {
    Mutex::new(Printer {
        out: BufWriter::new(io::stdout()),
        flushed: Instant::now(),
    })
});
/// A report was printed.
static REPORTED: AtomicBool = AtomicBool::new(false);
/// Standard output takes a file, and reports go to standard error.
static TAKEN: AtomicBool = AtomicBool::new(false);
static INPUTS: OnceLock<Vec<Identity>> = OnceLock::new();

/// Prints a value as one JSON document.
pub fn json(value: &impl Serialize) {
    REPORTED.store(true, Ordering::Relaxed);
    text(json_text(value));
}

/// A value as a JSON document.
pub fn json_text(value: &impl Serialize) -> String {
    serde_json::to_string_pretty(value).expect("reports have no unserialisable keys")
}

/// Prints text, followed by a new line.
pub fn text(value: impl std::fmt::Display) {
    if TAKEN.load(Ordering::Relaxed) {
        return complain(value);
    }
    let mut printer = PRINTER.lock().unwrap_or_else(PoisonError::into_inner);
    if let Err(error) = printer.print(value) {
        let failure = lost(&error);
        complain(&failure);
        // A program that prints goes on for minutes; without a reader it is to end here.
        end_process(failure.exit_code().into());
    }
}

impl Printer {
    fn print(&mut self, value: impl std::fmt::Display) -> io::Result<()> {
        if process::was_standard_output_closed() {
            return Err(io::Error::other("it is closed"));
        }
        writeln!(self.out, "{value}")?;
        if self.flushed.elapsed() > LATEST || io::stdout().is_terminal() {
            self.out.flush()?;
            self.flushed = Instant::now();
        }
        Ok(())
    }
}

/// Writes what was printed to its end.
pub fn flush() -> Result<(), Failure> {
    let mut printer = PRINTER.lock().unwrap_or_else(PoisonError::into_inner);
    printer.out.flush().map_err(|error| lost(&error))
}

/// What is said of standard output that cannot be written.
pub fn lost(error: &io::Error) -> Failure {
    match error.kind() {
        ErrorKind::BrokenPipe => Failure::ClosedPipe,
        _ => Failure::Input(format!(
            "cannot write standard output: {error}; what was to be printed is lost"
        )),
    }
}

/// Says something on standard error, where nothing can be done if it fails.
pub fn complain(value: impl std::fmt::Display) {
    let text = value.to_string();
    if !text.is_empty() {
        let _ = writeln!(io::stderr(), "{text}");
    }
}

/// Whether a JSON document was printed.
pub fn is_reported() -> bool {
    REPORTED.load(Ordering::Relaxed)
}

/// Standard output is for a file from here on; reports go to standard error.
pub fn leave_standard_output() {
    TAKEN.store(true, Ordering::Relaxed);
}

/// Files that no output may replace.
pub fn spare(inputs: Vec<Identity>) {
    // There is one command line, and it is looked at once.
    let _ = INPUTS.set(inputs);
}

/// The files of a command, which appear together when the set is finished.
pub fn files() -> Outputs {
    Outputs::sparing(INPUTS.get().cloned().unwrap_or_default())
}

/// Writes the only file of a command.
pub fn write_text(path: &Path, text: &str) -> Result<(), Failure> {
    let mut files = files();
    files.add_text(path, text)?;
    files.finish()?;
    Ok(())
}

/// Prints a warning on standard error.
pub fn warning(value: impl std::fmt::Display) {
    complain(format_args!("warning: {value}"));
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
