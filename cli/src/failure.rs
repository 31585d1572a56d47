//! How a command fails: the message and the exit code.

use imogene_files::WriteError;
use std::error::Error;
use std::fmt;
use std::io::ErrorKind;
use std::path::Path;

/// Characters of a word, of a line and of a message that refuses an input: what a file or a path says is shortened.
const WORD: usize = 200;
const LINE: usize = 1200;
const MESSAGE: usize = 1_800;

/// A command that did not succeed.
#[derive(Debug)]
pub enum Failure {
    /// A check failed: exit code 1.
    Check(String),
    /// Bad input or usage: exit code 2.
    Input(String),
    /// Bad input with lines that are to be copied, which nothing shortens: exit code 2.
    Advice(String),
    /// What a library refused, or an output that cannot be written, with its causes: exit code 2.
    Error(Box<dyn Error>),
    /// Nobody reads the output any more. That is said by the exit code alone, as by a program that the signal ended.
    ClosedPipe,
}

/// What a command or a part of it gives.
pub type Result<T = (), E = Failure> = std::result::Result<T, E>;

impl Failure {
    /// Something is wrong with a file.
    pub fn at(path: &Path, problem: impl fmt::Display) -> Failure {
        Failure::Input(format!("{}: {problem}", path.display()))
    }

    /// The same of any error that says what is wrong.
    pub fn in_file<E: fmt::Display>(path: &Path) -> impl Fn(E) -> Failure {
        move |error| Failure::at(path, error)
    }

    /// A check that fails unless it holds.
    pub fn unless(holds: bool, problem: impl FnOnce() -> String) -> Result {
        match holds {
            true => Ok(()),
            false => Err(Failure::Check(problem())),
        }
    }

    /// The process exit code.
    pub fn exit_code(&self) -> u8 {
        match self {
            Failure::Check(_) => 1,
            Failure::Input(_) | Failure::Advice(_) | Failure::Error(_) => 2,
            Failure::ClosedPipe => 141,
        }
    }

    /// What is wrong, of a length that can be read; `None` if there is nothing to say.
    pub fn message(&self) -> Option<String> {
        match self {
            Failure::Check(message) => Some(lines(message)),
            Failure::Advice(message) => Some(message.clone()),
            Failure::Input(message) => Some(shortened(&lines(message), MESSAGE)),
            Failure::Error(error) => Some(shortened(&lines(&with_causes(error.as_ref())), MESSAGE)),
            Failure::ClosedPipe => None,
        }
    }
}

/// An output that nobody reads any more is no error.
impl<E: Error + 'static> From<E> for Failure {
    fn from(error: E) -> Failure {
        let write = (&error as &dyn Error).downcast_ref::<WriteError>();
        match write.map(|error| error.source.kind()) {
            Some(ErrorKind::BrokenPipe) => Failure::ClosedPipe,
            _ => Failure::Error(Box::new(error)),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let message = self.message().unwrap_or_default();
        match self {
            Failure::Check(_) => write!(f, "check failed: {message}"),
            Failure::ClosedPipe => Ok(()),
            _ => write!(f, "error: {message}"),
        }
    }
}

/// The error and each cause behind it that it does not say itself.
fn with_causes(error: &dyn Error) -> String {
    let causes = std::iter::successors(error.source(), |&cause| cause.source());
    causes.fold(error.to_string(), |text, cause| {
        let cause = cause.to_string();
        match text.contains(&cause) {
            true => text,
            false => format!("{text}: {cause}"),
        }
    })
}

/// The text with long words and lines shortened.
fn lines(text: &str) -> String {
    let line = |line: &str| {
        let words: Vec<String> = line.split(' ').map(|w| shortened(w, WORD)).collect();
        shortened(&words.join(" "), LINE)
    };
    text.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// The text, without its middle if it has more than so many characters.
fn shortened(text: &str, most: usize) -> String {
    let count = text.chars().count();
    if count <= most {
        return text.to_owned();
    }
    let place = |n: usize| text.char_indices().nth(n).map_or(text.len(), |(at, _)| at);
    let (head, tail) = (most * 2 / 3, most / 3);
    let (begin, end) = (&text[..place(head)], &text[place(count - tail)..]);
    let left_out = count - head - tail;
    format!("{begin}[.. {left_out} characters ..]{end}")
}
