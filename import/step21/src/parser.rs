//! From the words of a file to its records (ISO 10303-21, clauses 5 to 10).

use super::error::{Error, Result};
use super::token::{Token, Tokens};
use super::value::{Instance, Kind, Record, Value};
use std::collections::HashMap;

/// Most lists inside each other.
const DEEPEST: usize = 32;

/// A file that has been taken apart.
#[derive(Debug, Default)]
pub struct Exchange<'a> {
    /// Its bytes: ASCII, apart from what stands in strings and comments.
    pub bytes: &'a [u8],
    /// Records of the header.
    pub header: Vec<Record<'a>>,
    /// Entities in their order.
    pub instances: Vec<Instance<'a>>,
    /// Their places by their numbers.
    pub(crate) index: HashMap<u64, usize>,
}

impl<'a> Exchange<'a> {
    /// Takes a file apart.
    pub fn parse(bytes: &'a [u8]) -> Result<Self> {
        let mut parser = Tokens::new(bytes);
        let mut file = Exchange {
            bytes,
            ..Exchange::default()
        };
        let not_step = |_| {
            let accepted = "a file that begins with `ISO-10303-21;` is needed";
            Error::at(bytes, 0, "this is no STEP file", accepted)
        };
        parser.step().map_err(not_step)?;
        parser.keyword("ISO-10303-21").map_err(not_step)?;
        parser.sign(b';')?;
        parser.keyword("HEADER")?;
        parser.sign(b';')?;
        while parser.token != Token::Keyword("ENDSEC") {
            file.header.push(parser.record(0)?);
            parser.sign(b';')?;
        }
        parser.step()?;
        parser.sign(b';')?;
        while parser.token != Token::Keyword("END-ISO-10303-21") {
            parser.section(&mut file)?;
        }
        if file.instances.is_empty() {
            let accepted = "a data section with a solid is needed";
            return Err(Error::whole("the file has no entities", accepted));
        }
        Ok(file)
    }
}

impl<'a> Tokens<'a> {
    fn section(&mut self, file: &mut Exchange<'a>) -> Result<()> {
        let is_data = match self.token {
            Token::Keyword("DATA") => true,
            Token::Keyword("ANCHOR" | "REFERENCE" | "SIGNATURE") => false,
            _ => {
                let needed = "a section, `DATA;`, or the end of the file, `END-ISO-10303-21;`,";
                return Err(self.unexpected(needed));
            }
        };
        self.step()?;
        if is_data && self.token == Token::Sign(b'(') {
            self.list(0)?;
        }
        self.sign(b';')?;
        while self.token != Token::Keyword("ENDSEC") {
            if is_data {
                let entity = self.entity()?;
                if file.index.insert(entity.id, file.instances.len()).is_some() {
                    let problem = format!("`#{}` is there already", entity.id);
                    let accepted = "every entity needs a number of its own";
                    return Err(Error::at(file.bytes, entity.at, problem, accepted));
                }
                file.instances.push(entity);
            } else if self.token == Token::End {
                return Err(self.unexpected("`ENDSEC;`"));
            } else {
                self.step()?;
            }
        }
        self.step()?;
        self.sign(b';')
    }

    fn unexpected(&self, needed: &str) -> Error {
        let problem = format!("{} is not expected here", self.token.name());
        self.error(problem, format!("{needed} is needed"))
    }

    fn sign(&mut self, sign: u8) -> Result<()> {
        if self.token != Token::Sign(sign) {
            return Err(self.unexpected(&format!("`{}`", char::from(sign))));
        }
        self.step()
    }

    fn keyword(&mut self, word: &str) -> Result<()> {
        if self.token != Token::Keyword(word) {
            return Err(self.unexpected(&format!("`{word};`")));
        }
        self.step()
    }

    /// `#12 = NAME(...);` or `#12 = ( A(...) B(...) );`
    fn entity(&mut self) -> Result<Instance<'a>> {
        let Token::Value(Kind::Reference(id)) = self.token else {
            return Err(self.unexpected("an entity such as `#1 = NAME(...);` or `ENDSEC;`"));
        };
        let at = self.at;
        self.step()?;
        self.sign(b'=')?;
        let mut records = vec![];
        let complex = self.token == Token::Sign(b'(');
        if complex {
            self.step()?;
            while self.token != Token::Sign(b')') {
                records.push(self.record(0)?);
            }
            self.step()?;
        } else {
            records.push(self.record(0)?);
        }
        self.sign(b';')?;
        Ok(Instance {
            id,
            at,
            records,
            complex,
        })
    }

    fn record(&mut self, depth: usize) -> Result<Record<'a>> {
        let Token::Keyword(name) = self.token else {
            return Err(self.unexpected("the name of an entity"));
        };
        self.step()?;
        let values = self.list(depth)?;
        Ok(Record { name, values })
    }

    /// `(` parameters `)`
    fn list(&mut self, depth: usize) -> Result<Vec<Value<'a>>> {
        if depth > DEEPEST {
            let accepted = format!("at most {DEEPEST} lists inside each other are possible");
            return Err(self.error("a list inside too many others", accepted));
        }
        self.sign(b'(')?;
        let mut values = vec![];
        if self.token != Token::Sign(b')') {
            values.push(self.value(depth)?);
            while self.token == Token::Sign(b',') {
                self.step()?;
                values.push(self.value(depth)?);
            }
        }
        if self.token != Token::Sign(b')') {
            return Err(self.unexpected("`,` or `)`"));
        }
        self.step()?;
        Ok(values)
    }

    fn value(&mut self, depth: usize) -> Result<Value<'a>> {
        let at = self.at;
        let kind = match &self.token {
            Token::Sign(b'(') => Kind::List(self.list(depth + 1)?),
            Token::Keyword(_) => Kind::Typed(self.record(depth + 1)?),
            Token::Value(kind) => {
                let kind = kind.clone();
                self.step()?;
                kind
            }
            _ => return Err(self.unexpected("a parameter")),
        };
        Ok(Value { at, kind })
    }
}
