//! Entities and their parameters as they are written.

use super::text::{shortened, with_article};

/// A parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Value<'a> {
    /// Where it begins.
    pub at: usize,
    /// What it is.
    pub kind: Kind<'a>,
}

/// Kinds of parameters.
#[derive(Clone, Debug, PartialEq)]
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
    Typed(Record<'a>),
}

impl Kind<'_> {
    /// For a message.
    pub fn name(&self) -> String {
        match self {
            Self::Omitted => "`$`".into(),
            Self::Derived => "`*`".into(),
            Self::Number(value, _) => format!("the number {value}"),
            Self::Text(_) => "a string".into(),
            Self::Word(word) => format!("`.{}.`", shortened(word)),
            Self::Bits => "a binary value".into(),
            Self::Reference(id) => format!("`#{id}`"),
            Self::List(values) => format!("a list of {}", values.len()),
            Self::Typed(typed) => with_article(&shortened(typed.name)),
        }
    }
}

/// A name with its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Record<'a> {
    /// Name of the entity or, of a complex one, of a part of it.
    pub name: &'a str,
    /// Its parameters.
    pub values: Vec<Value<'a>>,
}

/// An entity as it is written.
#[derive(Clone, Debug)]
pub struct Instance<'a> {
    /// Its number.
    pub id: u64,
    /// Where it begins.
    pub at: usize,
    /// One record, or those of `( A() B() )`.
    pub records: Vec<Record<'a>>,
    /// It is written as `( A() B() )`.
    pub complex: bool,
}
