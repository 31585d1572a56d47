//! Lines of fixed columns.

use crate::error::{Error, Place, Result};
use crate::kit::decimal;
use std::borrow::Cow;

/// One line of a file: a character in each column, where anything that is not ASCII counts as one.
pub struct Columns<'a> {
    number: usize,
    text: Cow<'a, [u8]>,
}

fn plain(c: u8) -> u8 {
    if c.is_ascii_control() { b'?' } else { c }
}

impl<'a> Columns<'a> {
    /// The line of a number, counted from 1, without its end.
    pub fn new(number: usize, line: &'a [u8]) -> Columns<'a> {
        let text = if line.is_ascii() {
            Cow::Borrowed(line)
        } else {
            let plain = |c: char| if c.is_ascii() { c as u8 } else { b'?' };
            Cow::Owned(String::from_utf8_lossy(line).chars().map(plain).collect())
        };
        Columns { number, text }
    }

    /// What is wrong at a column, or where the line ends if it ends before.
    pub fn error(&self, column: usize, problem: String, accepted: String) -> Error {
        let (line, column) = (self.number, column.min(self.text.len() + 1));
        Error::whole(problem, accepted).placed(Place { line, column })
    }

    /// The characters of the columns `first` to `last`, counted from 1; fewer if the line is shorter.
    pub fn bytes(&self, first: usize, last: usize) -> &[u8] {
        let end = last.min(self.text.len());
        &self.text[(first - 1).min(end)..end]
    }

    /// The name of the record in capitals: the first six columns.
    pub fn record(&self) -> [u8; 6] {
        std::array::from_fn(|k| self.character(k + 1).to_ascii_uppercase())
    }

    /// The same as text, without the spaces around it; control characters are written as `?`.
    pub fn field(&self, first: usize, last: usize) -> String {
        let bytes = self.bytes(first, last).trim_ascii().iter();
        bytes.map(|c| char::from(plain(*c))).collect()
    }

    /// The character of a column; a space behind the end of the line.
    pub fn character(&self, column: usize) -> u8 {
        self.text.get(column - 1).map_or(b' ', |c| plain(*c))
    }

    /// A number in decimal notation, if that is all there is in the columns.
    pub fn number(&self, first: usize, last: usize) -> Option<f64> {
        decimal(self.bytes(first, last).trim_ascii(), b"+-.")
    }

    /// One coordinate of an atom. What is left of a number where a line has been cut off is not to be trusted.
    pub fn coordinate(&self, axis: char, first: usize, last: usize) -> Result<f64> {
        let whole = self.text.len() >= last;
        let number = self.number(first, last).filter(|_| whole);
        number.ok_or_else(|| {
            let text = self.field(first, last);
            let problem = if self.text.len() < first {
                format!("the line ends before the {axis} coordinate of its atom")
            } else if !whole {
                format!("the line ends within the {axis} coordinate of its atom")
            } else if text.is_empty() {
                format!("the atom has no {axis} coordinate")
            } else {
                format!("the {axis} coordinate `{text}` is not a number")
            };
            let bytes = self.bytes(first, last);
            let blanks = bytes.iter().take_while(|c| c.is_ascii_whitespace()).count();
            let at = if text.is_empty() { 0 } else { blanks };
            let accepted = format!(
                "a decimal number such as -12.345 in columns {first} to {last} would be accepted"
            );
            self.error(first + at, problem, accepted)
        })
    }
}
