//! The words of a CIF text (S. R. Hall and others, "The crystallographic information file", version 1.1).

use crate::error::{Error, Place, Result};

/// A word, with its text where it has one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Token<'a> {
    /// `data_NAME`.
    Data(&'a [u8]),
    Loop,
    /// `save_NAME`, `save_`, `global_` or `stop_`: of dictionaries.
    Other,
    /// `_category.item`, with the underscore.
    Tag(&'a [u8]),
    /// A value, bare.
    Bare(&'a [u8]),
    /// A value in quotes or between semicolons.
    Quoted(&'a [u8]),
}

pub struct Tokens<'a> {
    pub bytes: &'a [u8],
    /// Where the next word is looked for.
    pub at: usize,
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r')
}

impl<'a> Tokens<'a> {
    /// The next word and where it begins, or nothing at the end.
    pub fn next(&mut self) -> Result<Option<(Token<'a>, usize)>> {
        self.skip();
        let start = self.at;
        let Some(&first) = self.bytes.get(self.at) else {
            return Ok(None);
        };
        let begins_line = start == 0 || matches!(self.bytes[start - 1], b'\n' | b'\r');
        let token = match first {
            b';' if begins_line => self.text_field()?,
            b'\'' | b'"' => self.quoted(first)?,
            _ => self.bare(),
        };
        Ok(Some((token, start)))
    }

    /// Blanks and comments.
    fn skip(&mut self) {
        while let Some(&byte) = self.bytes.get(self.at) {
            if byte == b'#' {
                self.at += line_length(&self.bytes[self.at..]);
            } else if is_blank(byte) {
                self.at += 1;
            } else {
                return;
            }
        }
    }

    fn bare(&mut self) -> Token<'a> {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|b| is_blank(*b)).unwrap_or(rest.len());
        let word = &rest[..length];
        self.at += length;
        if word[0] == b'_' {
            return Token::Tag(word);
        }
        // Few values begin as a keyword does.
        if !matches!(word[0] | 0x20, b'd' | b'l' | b's' | b'g') || !word.contains(&b'_') {
            return Token::Bare(word);
        }
        let is = |name: &[u8]| word.eq_ignore_ascii_case(name);
        let start = &word[..word.len().min(5)];
        let begins = |name: &[u8; 5]| start.eq_ignore_ascii_case(name);
        if begins(b"data_") {
            Token::Data(&word[5..])
        } else if is(b"loop_") {
            Token::Loop
        } else if begins(b"save_") || is(b"global_") || is(b"stop_") {
            Token::Other
        } else {
            Token::Bare(word)
        }
    }

    /// A quote ends where a blank stands behind it: `'5'-end'` is one word.
    fn quoted(&mut self, quote: u8) -> Result<Token<'a>> {
        let line = &self.bytes[self.at..];
        let line = &line[..line_length(line)];
        let ends = |k: &usize| line[*k] == quote && line.get(k + 1).is_none_or(|b| is_blank(*b));
        let Some(end) = (1..line.len()).find(ends) else {
            let accepted = "a value such as 'two words' would be accepted";
            return Err(self.malformed(self.at, "the quote is not closed on its line", accepted));
        };
        self.at += end + 1;
        Ok(Token::Quoted(&line[1..end]))
    }

    /// From a semicolon that begins a line to the next.
    fn text_field(&mut self) -> Result<Token<'a>> {
        let from = self.at + 1;
        let mut at = from;
        loop {
            at += line_length(&self.bytes[at..]);
            if at >= self.bytes.len() {
                let problem = "the text that begins here is not closed";
                let accepted = "a line that begins with a semicolon would close it";
                return Err(self.malformed(self.at, problem, accepted));
            }
            let end = at;
            at += 1;
            if self.bytes[end] == b'\r' && self.bytes.get(at) == Some(&b'\n') {
                at += 1;
            }
            if self.bytes.get(at) == Some(&b';') {
                self.at = at + 1;
                return Ok(Token::Quoted(&self.bytes[from..end]));
            }
        }
    }

    /// What is wrong at a byte, and what would be accepted there.
    pub fn malformed(&self, at: usize, problem: impl ToString, accepted: impl ToString) -> Error {
        // Old Macintosh files end their lines with a carriage return alone.
        let bytes = self.bytes;
        let end = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
        Error::whole(problem, accepted).placed(Place::of(bytes, at, end))
    }
}

/// Bytes before the end of the line.
fn line_length(bytes: &[u8]) -> usize {
    let end = bytes.iter().position(|b| matches!(b, b'\n' | b'\r'));
    end.unwrap_or(bytes.len())
}
