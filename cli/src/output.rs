//! What a command puts out: one JSON document, or text for a person, on standard output; files; progress on standard
//! error, as a bar if that is a terminal and else as a line now and then.

use crate::failure::{Failure, Result};
use crate::process;
use imogene::progress::line;
use imogene_files::{Identity, Outputs, WriteError, end_process};
use imogene_studies::picture;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle, WeakProgressBar};
use serde::Serialize;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Stdout, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{LazyLock, Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

/// Text that waits no longer than this while more comes: a person sees slow results one by one.
const LATEST: Duration = Duration::from_millis(100);

/// Time between two lines of progress where there is no bar.
const PERIOD: Duration = Duration::from_secs(10);

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
static REPORTED: AtomicBool = AtomicBool::new(false);
/// Standard output takes a file, and reports go to standard error.
static TAKEN: AtomicBool = AtomicBool::new(false);
static INPUTS: OnceLock<Vec<Identity>> = OnceLock::new();

/// Prints a value as one JSON document.
pub fn json(value: &impl Serialize) {
    REPORTED.store(true, Ordering::Relaxed);
    text(json_text(value));
}

/// Prints a report: as one JSON document, or as `tell` does for a person.
pub fn report<T: Serialize>(json: bool, report: &T, tell: impl FnOnce(&T)) {
    match json {
        true => self::json(report),
        false => tell(report),
    }
}

/// The same, of which a template tells a person.
pub fn told(json: bool, report: &impl Serialize, template: &str) -> Result {
    match json {
        true => self::json(report),
        false => text(page(template, report)?),
    }
    Ok(())
}

/// A report with the files that were written of it.
#[derive(Serialize)]
pub struct Written<T> {
    #[serde(flatten)]
    pub report: T,
    pub files: Vec<PathBuf>,
}

/// The same, with the files that were written.
pub fn written(json: bool, report: impl Serialize, files: Vec<PathBuf>, template: &str) -> Result {
    let page = match json {
        true => String::new(),
        false => page(template, &report)?,
    };
    paged(json, report, files, &page);
    Ok(())
}

/// The same with the page that a person is told.
pub fn paged(json: bool, report: impl Serialize, files: Vec<PathBuf>, page: &str) {
    self::report(json, &Written { report, files }, |written| {
        text(page);
        wrote(&written.files);
    });
}

/// What a template makes of values, without the end of its last line.
pub fn page(template: &str, values: impl Serialize) -> Result<String> {
    let mut page = imogene_studies::kit::page::text("the report cannot be told", template, values)?;
    page.truncate(page.strip_suffix('\n').map_or(page.len(), str::len));
    Ok(page)
}

/// Says which files were written.
pub fn wrote(files: &[PathBuf]) {
    for file in files {
        text(format!("wrote {}", file.display()));
    }
}

/// A value as a JSON document.
pub fn json_text(value: &impl Serialize) -> String {
    serde_json::to_string_pretty(value).expect("reports have no unserialisable keys")
}

/// The texts of a list with a mark between them.
pub fn joined<T: ToString>(list: impl IntoIterator<Item = T>, mark: &str) -> String {
    let texts: Vec<String> = list.into_iter().map(|one| one.to_string()).collect();
    texts.join(mark)
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
pub fn flush() -> Result {
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

/// Adds an 8-bit RGB picture.
pub fn add_picture(
    files: &mut Outputs,
    path: &Path,
    [width, height]: [usize; 2],
    rgb: &[u8],
) -> Result<(), WriteError> {
    files.add(path, |out| picture::png(out, width, height, rgb))
}

/// Writes the only file of a command.
pub fn write_text(path: &Path, text: &str) -> Result {
    let mut files = files();
    files.add_text(path, text)?;
    files.finish()?;
    Ok(())
}

/// Prints a warning on standard error.
pub fn warning(value: impl std::fmt::Display) {
    complain(format_args!("warning: {value}"));
}

/// Progress of `length` steps, nothing if they are not known: a bar on a terminal, and else a line every ten seconds.
pub fn progress(length: u64, what: &'static str) -> ProgressBar {
    if !io::stderr().is_terminal() {
        let bar = ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::hidden());
        tell_now_and_then(bar.downgrade(), what);
        return bar;
    }
    let style = ProgressStyle::with_template("{msg:<28} {bar:40} {percent:>3} % {eta:>6}")
        .expect("a valid template");
    ProgressBar::new(length)
        .with_style(style)
        .with_message(what)
}

/// What a work gives that shows its progress of `length` steps.
pub fn during<T>(length: u64, what: &'static str, work: impl FnOnce(&ProgressBar) -> T) -> T {
    let bar = progress(length, what);
    let result = work(&bar);
    bar.finish_and_clear();
    result
}

/// Says how far it is until the work has ended.
fn tell_now_and_then(bar: WeakProgressBar, what: &'static str) {
    let started = Instant::now();
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(PERIOD);
            match bar.upgrade().filter(|bar| !bar.is_finished()) {
                Some(bar) => {
                    let length = bar.length().unwrap_or(0);
                    complain(line(what, bar.position(), length, started.elapsed()));
                }
                None => return,
            }
        }
    });
}
