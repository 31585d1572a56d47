//! Entities by their names, and parameters by what they have to be.

use super::error::{Error, Result};
use super::parser::Exchange;
use super::text::{decoded, shortened, with_article};
use super::value::{Instance, Kind, Record, Value};
use std::fmt::Display;
use std::ops::Deref;

/// An entity of a file.
#[derive(Clone, Copy, Debug)]
pub struct Entity<'a> {
    file: &'a Exchange<'a>,
    own: &'a Instance<'a>,
}

impl<'a> Deref for Entity<'a> {
    type Target = Instance<'a>;

    fn deref(&self) -> &Instance<'a> {
        self.own
    }
}

impl<'a> Entity<'a> {
    /// An error at the entity.
    pub fn error(&self, problem: impl ToString, accepted: impl ToString) -> Error {
        Error::at(self.file.bytes, self.at, problem, accepted)
    }

    /// Its record that has one of these names.
    pub fn find(&self, names: &[&str]) -> Option<Args<'a>> {
        let mut records = self.own.records.iter();
        let record = records.find(|record| names.contains(&record.name))?;
        let entity = *self;
        Some(Args { entity, record })
    }

    /// The same, and an error if there is none.
    pub fn need(&self, names: &[&str]) -> Result<Args<'a>> {
        self.find(names).ok_or_else(|| {
            let problem = format!("`#{}` is {}", self.id, with_article(&self.name()));
            let needed = with_article(&names.join(" or "));
            self.error(problem, format!("{needed} is needed where it is named"))
        })
    }

    /// Its name for a message: of a complex one the names of its parts.
    pub fn name(&self) -> String {
        let names: Vec<&str> = self.own.records.iter().map(|record| record.name).collect();
        match names[..] {
            [] => "( )".into(),
            [name] => shortened(name),
            _ => format!("( {} )", shortened(&names.join(" "))),
        }
    }
}

impl Exchange<'_> {
    /// An entity by its number.
    pub fn get(&self, id: u64) -> Option<Entity<'_>> {
        let own = &self.instances[*self.index.get(&id)?];
        Some(Entity { file: self, own })
    }

    /// All entities in their order.
    pub fn entities(&self) -> impl Iterator<Item = Entity<'_>> {
        self.instances.iter().map(|own| Entity { file: self, own })
    }

    /// Those that have one of these records.
    pub fn all<'e>(&'e self, names: &'e [&str]) -> impl Iterator<Item = Args<'e>> {
        self.entities().filter_map(|entity| entity.find(names))
    }
}

/// A record of an entity, whose parameters are asked for by their number, from 0.
#[derive(Clone, Copy, Debug)]
pub struct Args<'a> {
    /// The entity.
    pub entity: Entity<'a>,
    /// The record.
    pub record: &'a Record<'a>,
}

impl<'a> Args<'a> {
    /// An error of the whole entity.
    pub fn error(&self, problem: impl Display, accepted: impl ToString) -> Error {
        self.error_at(self.entity.at, &format!(": {problem}"), accepted)
    }

    fn error_at(&self, at: usize, problem: &str, accepted: impl ToString) -> Error {
        let (id, name) = (self.entity.id, shortened(self.record.name));
        let problem = format!("`#{id}` {name}{problem}");
        Error::at(self.entity.file.bytes, at, problem, accepted)
    }

    fn wrong(&self, value: &Value, needed: &str) -> Error {
        let values = &self.record.values;
        let place = values.iter().position(|v| v.at >= value.at);
        let place = place.map_or(values.len(), |p| p + 1);
        let problem = format!(": parameter {place} is {}", value.kind.name());
        self.error_at(value.at, &problem, format!("{needed} is needed"))
    }

    /// The record that has the parameters of a supertype: its own in a complex entity, this one in a simple one.
    pub fn of(&self, supertype: &str) -> Result<Args<'a>> {
        match self.entity.complex {
            true => self.entity.need(&[supertype]),
            false => Ok(*self),
        }
    }

    /// The place of the first parameter behind the name, which only a simple entity has.
    pub fn first(&self) -> usize {
        usize::from(!self.entity.complex)
    }

    /// A parameter.
    pub fn value(&self, index: usize) -> Result<&'a Value<'a>> {
        self.record.values.get(index).ok_or_else(|| {
            let problem = format!("it has {} parameters", self.record.values.len());
            self.error(problem, format!("at least {} are needed", index + 1))
        })
    }

    fn as_number(&self, value: &Value) -> Result<f64> {
        let inner = match &value.kind {
            Kind::Typed(typed) if typed.values.len() == 1 => &typed.values[0],
            _ => value,
        };
        match inner.kind {
            Kind::Number(number, _) => Ok(number),
            _ => Err(self.wrong(value, "a number")),
        }
    }

    /// A number.
    pub fn number(&self, index: usize) -> Result<f64> {
        self.as_number(self.value(index)?)
    }

    /// A list of numbers.
    pub fn numbers(&self, index: usize) -> Result<Vec<f64>> {
        self.numbers_of(self.value(index)?)
    }

    /// The numbers of a list in a list.
    pub fn numbers_of(&self, value: &Value) -> Result<Vec<f64>> {
        let list = self.members(value)?.iter();
        list.map(|value| self.as_number(value)).collect()
    }

    fn as_whole(&self, value: &Value) -> Result<usize> {
        match value.kind {
            Kind::Number(number, true) if (0.0..=1e9).contains(&number) => Ok(number as usize),
            _ => Err(self.wrong(value, "a whole number from 0 to 1000000000")),
        }
    }

    /// A whole number that is not negative.
    pub fn whole(&self, index: usize) -> Result<usize> {
        self.as_whole(self.value(index)?)
    }

    /// A list of them.
    pub fn wholes(&self, index: usize) -> Result<Vec<usize>> {
        let list = self.list(index)?.iter();
        list.map(|value| self.as_whole(value)).collect()
    }

    /// `.T.` or `.F.`
    pub fn flag(&self, index: usize) -> Result<bool> {
        let value = self.value(index)?;
        match value.kind {
            Kind::Word("T") => Ok(true),
            Kind::Word("F") => Ok(false),
            _ => Err(self.wrong(value, "`.T.` or `.F.`")),
        }
    }

    /// An enumerated value; nothing for `$`.
    pub fn word(&self, index: usize) -> Result<Option<&'a str>> {
        let value = self.value(index)?;
        match value.kind {
            Kind::Word(word) => Ok(Some(word)),
            Kind::Omitted => Ok(None),
            _ => Err(self.wrong(value, "an enumerated value such as `.MILLI.`")),
        }
    }

    /// A string; empty if it is not given.
    pub fn text(&self, index: usize) -> String {
        match self.record.values.get(index).map(|value| &value.kind) {
            Some(Kind::Text(text)) => decoded(text).trim().to_owned(),
            _ => String::new(),
        }
    }

    /// A list.
    pub fn list(&self, index: usize) -> Result<&'a [Value<'a>]> {
        self.members(self.value(index)?)
    }

    fn members<'v>(&self, value: &'v Value<'a>) -> Result<&'v [Value<'a>]> {
        match &value.kind {
            Kind::List(values) => Ok(values),
            _ => Err(self.wrong(value, "a list")),
        }
    }

    /// The entity that a value names.
    pub fn as_entity(&self, value: &Value) -> Result<Entity<'a>> {
        let Kind::Reference(id) = value.kind else {
            return Err(self.wrong(value, "a reference such as `#12`"));
        };
        self.entity.file.get(id).ok_or_else(|| {
            let problem = format!(" names `#{id}`, which is not in the file");
            let accepted = "the number of an entity of this file is needed";
            self.error_at(value.at, &problem, accepted)
        })
    }

    /// The entity that is named.
    pub fn entity(&self, index: usize) -> Result<Entity<'a>> {
        self.as_entity(self.value(index)?)
    }

    /// The entity that is named; nothing for `$` and `*`.
    pub fn maybe(&self, index: usize) -> Result<Option<Entity<'a>>> {
        let value = self.value(index)?;
        match value.kind {
            Kind::Omitted | Kind::Derived => Ok(None),
            _ => self.as_entity(value).map(Some),
        }
    }

    /// A list of entities.
    pub fn entities(&self, index: usize) -> Result<Vec<Entity<'a>>> {
        self.entities_of(self.value(index)?)
    }

    /// The entities of a list in a list.
    pub fn entities_of(&self, value: &Value<'a>) -> Result<Vec<Entity<'a>>> {
        let list = self.members(value)?.iter();
        list.map(|value| self.as_entity(value)).collect()
    }

    /// The record that the entity named has, of these names.
    pub fn named(&self, index: usize, names: &[&str]) -> Result<Args<'a>> {
        self.entity(index)?.need(names)
    }
}
