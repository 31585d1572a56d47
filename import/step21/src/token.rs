//! Words of a STEP file (ISO 10303-21, clause 6).

use super::error::{Error, Result};
use super::text::shortened;
use super::value::Kind;

/// What a word is.
#[derive(Clone, Debug, PartialEq)]
pub enum Token<'a> {
    /// `( ) , ; =`
    Sign(u8),
    /// The name of an entity or of a section, and `ISO-10303-21`.
    Keyword(&'a str),
    /// Any other parameter.
    Value(Kind<'a>),
    /// The end of the file.
    End,
}

impl Token<'_> {
    /// For a message.
    pub fn name(&self) -> String {
        match self {
            Self::Sign(sign) => format!("`{}`", char::from(*sign)),
            Self::Keyword(word) => format!("`{}`", shortened(word)),
            Self::Value(Kind::Number(..)) => "a number".into(),
            Self::Value(kind) => kind.name(),
            Self::End => "the end of the file".into(),
        }
    }
}

/// Reads words one after the other.
pub struct Tokens<'a> {
    bytes: &'a [u8],
    next: usize,
    /// The word that was read last.
    pub token: Token<'a>,
    /// Where it begins.
    pub at: usize,
}

impl<'a> Tokens<'a> {
    /// From the start of a file.
    pub fn new(bytes: &'a [u8]) -> Self {
        let mark = bytes.starts_with(b"\xef\xbb\xbf");
        Self {
            bytes,
            next: if mark { 3 } else { 0 },
            token: Token::End,
            at: 0,
        }
    }

    fn rest(&self) -> &'a [u8] {
        &self.bytes[self.next..]
    }

    /// An error at the word that was read last.
    pub fn error(&self, problem: impl ToString, accepted: impl ToString) -> Error {
        Error::at(self.bytes, self.at, problem, accepted)
    }

    /// Reads the next word.
    pub fn step(&mut self) -> Result<()> {
        self.token = self.read()?;
        Ok(())
    }

    fn read(&mut self) -> Result<Token<'a>> {
        self.skip()?;
        self.at = self.next;
        let Some(first) = self.rest().first().copied() else {
            return Ok(Token::End);
        };
        match first {
            b'(' | b')' | b',' | b';' | b'=' | b'$' | b'*' => {
                self.next += 1;
                Ok(match first {
                    b'$' => Token::Value(Kind::Omitted),
                    b'*' => Token::Value(Kind::Derived),
                    _ => Token::Sign(first),
                })
            }
            b'#' => self.reference(),
            b'\'' => self.text(),
            b'"' => {
                self.quoted(b'"', "a binary value")?;
                Ok(Token::Value(Kind::Bits))
            }
            b'.' => self.word(),
            b'+' | b'-' | b'0'..=b'9' => self.number(),
            b'!' | b'_' | b'A'..=b'Z' | b'a'..=b'z' => {
                let is_part = |b: u8| b.is_ascii_alphanumeric() || b"!_-".contains(&b);
                Ok(Token::Keyword(self.take_while(0, is_part)))
            }
            other => Err(self.error(
                format!("`{}` begins no word", char::from(other).escape_default()),
                "the words of a STEP file are names, numbers, 'strings', #references, .WORDS. and ( ) , ; = $ *",
            )),
        }
    }

    /// White space, comments and the print directives `\N\` and `\F\`.
    fn skip(&mut self) -> Result<()> {
        loop {
            match self.rest() {
                [b' ' | b'\t' | b'\r' | b'\n' | 0x0b | 0x0c, ..] => self.next += 1,
                [b'/', b'*', inside @ ..] => {
                    let Some(end) = inside.windows(2).position(|pair| pair == b"*/") else {
                        self.at = self.next;
                        return Err(self.error("the comment has no end", "`*/` ends a comment"));
                    };
                    self.next += 2 + end + 2;
                }
                [b'\\', b'N' | b'F', b'\\', ..] => self.next += 3,
                _ => return Ok(()),
            }
        }
    }

    /// The bytes from `skipped` on that are part of the word, as text; `is_part` accepts ASCII alone.
    fn take_while(&mut self, skipped: usize, is_part: impl Fn(u8) -> bool) -> &'a str {
        let rest = &self.rest()[skipped..];
        let length = rest.iter().position(|byte| !is_part(*byte));
        let taken = &rest[..length.unwrap_or(rest.len())];
        self.next += skipped + taken.len();
        std::str::from_utf8(taken).unwrap_or("")
    }

    fn reference(&mut self) -> Result<Token<'a>> {
        let digits = self.take_while(1, |byte| byte.is_ascii_digit());
        let id = digits.parse().map_err(|_| {
            let problem = match digits {
                "" => "`#` without a number".to_owned(),
                _ => format!("the number of `#{}` is too large", shortened(digits)),
            };
            self.error(problem, format!("references are `#1` to `#{}`", u64::MAX))
        })?;
        Ok(Token::Value(Kind::Reference(id)))
    }

    fn number(&mut self) -> Result<Token<'a>> {
        let is_part = |byte: u8| byte.is_ascii_digit() || b"+-.Ee".contains(&byte);
        let digits = self.take_while(0, is_part);
        match digits.parse::<f64>() {
            Ok(value) if value.is_finite() => {
                let whole = !digits.contains(['.', 'e', 'E']);
                Ok(Token::Value(Kind::Number(value, whole)))
            }
            _ => Err(self.error(
                format!("`{}` is not a number of this program", shortened(digits)),
                "numbers such as 12, -0.5 and 1.E-3, of double precision, are needed",
            )),
        }
    }

    fn word(&mut self) -> Result<Token<'a>> {
        let word = self.take_while(1, |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_');
        if word.is_empty() || self.rest().first() != Some(&b'.') {
            return Err(self.error(
                "`.` begins no word",
                "enumerated values such as .T. and .MILLI. are needed, and numbers begin with a digit",
            ));
        }
        self.next += 1;
        Ok(Token::Value(Kind::Word(word)))
    }

    /// Up to the closing quote; two quotes are one.
    fn text(&mut self) -> Result<Token<'a>> {
        let start = self.next + 1;
        self.quoted(b'\'', "a string")?;
        while self.rest().first() == Some(&b'\'') {
            self.quoted(b'\'', "a string")?;
        }
        Ok(Token::Value(Kind::Text(&self.bytes[start..self.next - 1])))
    }

    fn quoted(&mut self, quote: u8, what: &str) -> Result<()> {
        let inside = &self.rest()[1..];
        let Some(end) = inside.iter().position(|byte| *byte == quote) else {
            let accepted = format!("`{}` ends {what}", char::from(quote));
            return Err(self.error(format!("{what} has no end"), accepted));
        };
        self.next += end + 2;
        Ok(())
    }
}
