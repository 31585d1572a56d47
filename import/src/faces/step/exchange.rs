//! The exchange structure: sections, entities and their parameters (ISO 10303-21, clauses 5 to 10).

use super::source::Source;
use super::token::{Token, Tokens, shortened};
use crate::ImportError;
use crate::faces::words::with_article;
use std::collections::HashMap;

/// Most lists inside each other; no entity of this reader has more than two.
pub const DEEPEST: usize = 32;

/// A parameter.
#[derive(Clone, Debug)]
pub struct Value<'a> {
    /// Where it begins.
    pub at: usize,
    /// What it is.
    pub kind: Kind<'a>,
}

/// Kinds of parameters.
#[derive(Clone, Debug)]
pub enum Kind<'a> {
    /// `$`: not given.
    Omitted,
    /// `*`: follows from others.
    Derived,
    /// A number, and whether it is written as a whole one.
    Number(f64, bool),
    /// What stands between the quotes of a string.
    Text(&'a [u8]),
    /// An enumerated value, without its points.
    Word(&'a str),
    /// Bits.
    Bits,
    /// An entity by its number.
    Reference(u64),
    /// A list.
    List(Vec<Value<'a>>),
    /// A value with the name of its type, as `LENGTH_MEASURE(1.)`.
    Typed(&'a str, Vec<Value<'a>>),
}

impl Value<'_> {
    /// For a message.
    pub fn name(&self) -> String {
        match &self.kind {
            Kind::Omitted => "`$`".into(),
            Kind::Derived => "`*`".into(),
            Kind::Number(value, _) => format!("the number {value}"),
            Kind::Text(_) => "a string".into(),
            Kind::Word(word) => format!("`.{}.`", shortened(word)),
            Kind::Bits => "a binary value".into(),
            Kind::Reference(id) => format!("`#{id}`"),
            Kind::List(values) => format!("a list of {}", values.len()),
            Kind::Typed(name, _) => with_article(&shortened(name)),
        }
    }
}

/// A name with its parameters.
#[derive(Clone, Debug)]
pub struct Record<'a> {
    /// Name of the entity or, of a complex one, of a part of it.
    pub name: &'a str,
    /// Its parameters.
    pub values: Vec<Value<'a>>,
}

/// An entity.
#[derive(Clone, Debug)]
pub struct Entity<'a> {
    /// Its number.
    pub id: u64,
    /// Where it begins.
    pub at: usize,
    /// One record, or those of `( A() B() )`.
    pub records: Vec<Record<'a>>,
    /// It is written as `( A() B() )`.
    pub complex: bool,
}

/// A file that has been taken apart.
#[derive(Debug)]
pub struct Exchange<'a> {
    /// Its bytes.
    pub source: Source<'a>,
    /// Records of the header.
    pub header: Vec<Record<'a>>,
    /// Entities in their order.
    pub entities: Vec<Entity<'a>>,
    /// The last digit of its coordinates, in its unit of length: 0.000001 if none has more than six decimals; 0 if all
    /// have so few that they may be exact.
    pub last_digit: f64,
    /// The greatest difference of two coordinates along an axis, in its unit of length.
    pub extent: f64,
    index: HashMap<u64, usize>,
}

/// Coordinates with fewer decimals than this are taken for exact: a round number says nothing of how numbers are
/// rounded.
const FEWEST_DECIMALS: usize = 5;

/// The most decimals in a text of coordinates; those of numbers with an exponent say nothing.
fn decimals(text: &[u8]) -> usize {
    let mut most = 0;
    for (dot, _) in text.iter().enumerate().filter(|(_, byte)| **byte == b'.') {
        let after = &text[dot + 1..];
        let digits = after.iter().take_while(|b| b.is_ascii_digit()).count();
        if !matches!(after.get(digits), Some(b'E' | b'e')) {
            most = most.max(digits);
        }
    }
    most
}

impl<'a> Exchange<'a> {
    /// Takes a file apart.
    pub fn parse(source: Source<'a>) -> Result<Self, ImportError> {
        let mut parser = Parser {
            source,
            tokens: Tokens::new(source),
            token: Token::End,
        };
        let not_step = |_| {
            source.error(
                0,
                "this is no STEP file",
                "a file that begins with `ISO-10303-21;` is needed",
            )
        };
        parser.step().map_err(not_step)?;
        parser.keyword("ISO-10303-21").map_err(not_step)?;
        parser.sign(b';')?;
        let mut exchange = Exchange {
            source,
            header: vec![],
            entities: vec![],
            last_digit: 0.0,
            extent: 0.0,
            index: HashMap::new(),
        };
        parser.keyword("HEADER")?;
        parser.sign(b';')?;
        while parser.token != Token::Keyword("ENDSEC") {
            exchange.header.push(parser.record(0)?);
            parser.sign(b';')?;
        }
        parser.step()?;
        parser.sign(b';')?;
        while parser.token != Token::Keyword("END-ISO-10303-21") {
            exchange.section(&mut parser)?;
        }
        if exchange.entities.is_empty() {
            return Err(source.unusable(
                "the file has no entities",
                "a data section with a solid is needed",
            ));
        }
        exchange.measure();
        Ok(exchange)
    }

    /// What all its points say of its digits and its extent.
    fn measure(&mut self) {
        let source = self.source;
        let points = self.entities.iter().filter(|entity| {
            let names = entity.records.iter().map(|record| record.name);
            names.eq(["CARTESIAN_POINT"])
        });
        let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for point in points.clone() {
            let Some(Kind::List(values)) = point.records[0].values.get(1).map(|v| &v.kind) else {
                continue;
            };
            for (axis, value) in values.iter().take(3).enumerate() {
                if let Kind::Number(value, _) = value.kind {
                    bounds[0][axis] = bounds[0][axis].min(value);
                    bounds[1][axis] = bounds[1][axis].max(value);
                }
            }
        }
        self.extent = (0..3)
            .map(|axis| bounds[1][axis] - bounds[0][axis])
            .fold(0.0, f64::max);
        let most = points
            .map(|point| {
                let text = &source.bytes[point.at..];
                let end = text.iter().position(|b| *b == b';').unwrap_or(text.len());
                decimals(&text[..end])
            })
            .max();
        self.last_digit = most
            .filter(|most| *most >= FEWEST_DECIMALS)
            .map_or(0.0, |most| 10_f64.powi(-(most as i32)));
    }

    /// An entity by its number.
    pub fn get(&self, id: u64) -> Option<&Entity<'a>> {
        self.index.get(&id).map(|index| &self.entities[*index])
    }

    fn section(&mut self, parser: &mut Parser<'a>) -> Result<(), ImportError> {
        let is_data = match parser.token {
            Token::Keyword("DATA") => true,
            Token::Keyword("ANCHOR" | "REFERENCE" | "SIGNATURE") => false,
            _ => {
                return Err(parser.unexpected(
                    "a section, `DATA;`, or the end of the file, `END-ISO-10303-21;`,",
                ));
            }
        };
        parser.step()?;
        if is_data && parser.token == Token::Sign(b'(') {
            parser.list(0)?;
        }
        parser.sign(b';')?;
        while parser.token != Token::Keyword("ENDSEC") {
            if is_data {
                let entity = parser.entity()?;
                let place = self.entities.len();
                if self.index.insert(entity.id, place).is_some() {
                    return Err(self.source.error(
                        entity.at,
                        format!("`#{}` is there already", entity.id),
                        "every entity needs a number of its own",
                    ));
                }
                self.entities.push(entity);
            } else if parser.token == Token::End {
                return Err(parser.unexpected("`ENDSEC;`"));
            } else {
                parser.step()?;
            }
        }
        parser.step()?;
        parser.sign(b';')
    }
}

struct Parser<'a> {
    source: Source<'a>,
    tokens: Tokens<'a>,
    /// The word that is next.
    token: Token<'a>,
}

impl<'a> Parser<'a> {
    fn step(&mut self) -> Result<(), ImportError> {
        self.token = self.tokens.read()?;
        Ok(())
    }

    fn unexpected(&self, needed: &str) -> ImportError {
        self.source.error(
            self.tokens.at,
            format!("{} is not expected here", self.token.name()),
            format!("{needed} is needed"),
        )
    }

    fn sign(&mut self, sign: u8) -> Result<(), ImportError> {
        if self.token != Token::Sign(sign) {
            return Err(self.unexpected(&format!("`{}`", char::from(sign))));
        }
        self.step()
    }

    fn keyword(&mut self, word: &str) -> Result<(), ImportError> {
        if self.token != Token::Keyword(word) {
            return Err(self.unexpected(&format!("`{word};`")));
        }
        self.step()
    }

    /// `#12 = NAME(...);` or `#12 = ( A(...) B(...) );`
    fn entity(&mut self) -> Result<Entity<'a>, ImportError> {
        let Token::Reference(id) = self.token else {
            return Err(self.unexpected("an entity such as `#1 = NAME(...);` or `ENDSEC;`"));
        };
        let at = self.tokens.at;
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
        Ok(Entity {
            id,
            at,
            records,
            complex,
        })
    }

    fn record(&mut self, depth: usize) -> Result<Record<'a>, ImportError> {
        let Token::Keyword(name) = self.token else {
            return Err(self.unexpected("the name of an entity"));
        };
        self.step()?;
        let values = self.list(depth)?;
        Ok(Record { name, values })
    }

    /// `(` parameters `)`
    fn list(&mut self, depth: usize) -> Result<Vec<Value<'a>>, ImportError> {
        if depth > DEEPEST {
            return Err(self.source.error(
                self.tokens.at,
                "a list inside too many others",
                format!("at most {DEEPEST} lists inside each other are possible"),
            ));
        }
        self.sign(b'(')?;
        let mut values = vec![];
        if self.token == Token::Sign(b')') {
            self.step()?;
            return Ok(values);
        }
        loop {
            values.push(self.value(depth)?);
            match self.token {
                Token::Sign(b',') => self.step()?,
                Token::Sign(b')') => {
                    self.step()?;
                    return Ok(values);
                }
                _ => return Err(self.unexpected("`,` or `)`")),
            }
        }
    }

    fn value(&mut self, depth: usize) -> Result<Value<'a>, ImportError> {
        let at = self.tokens.at;
        let kind = match self.token {
            Token::Sign(b'(') => Kind::List(self.list(depth + 1)?),
            Token::Keyword(_) => {
                let typed = self.record(depth + 1)?;
                Kind::Typed(typed.name, typed.values)
            }
            simple => {
                let kind = match simple {
                    Token::Sign(b'$') => Kind::Omitted,
                    Token::Sign(b'*') => Kind::Derived,
                    Token::Number(value, whole) => Kind::Number(value, whole),
                    Token::Text(text) => Kind::Text(text),
                    Token::Word(word) => Kind::Word(word),
                    Token::Bits => Kind::Bits,
                    Token::Reference(id) => Kind::Reference(id),
                    _ => return Err(self.unexpected("a parameter")),
                };
                self.step()?;
                kind
            }
        };
        Ok(Value { at, kind })
    }
}
