//! Parameters of entities by what they have to be.

use super::exchange::{Entity, Exchange, Kind, Record, Value};
use super::text::decoded;
use super::token::shortened;
use crate::ImportError;
use crate::faces::words::with_article;

/// A record of an entity, whose parameters are asked for by their number, from 0.
#[derive(Clone, Copy, Debug)]
pub struct Args<'e, 'a> {
    file: &'e Exchange<'a>,
    /// The entity.
    pub entity: &'e Entity<'a>,
    /// The record.
    pub record: &'e Record<'a>,
}

impl<'a> Exchange<'a> {
    /// The record of an entity that has one of these names; all but the first are also tried.
    pub fn find<'e>(&'e self, entity: &'e Entity<'a>, names: &[&str]) -> Option<Args<'e, 'a>> {
        let found = |record: &&Record| names.contains(&record.name);
        let record = entity.records.iter().find(found)?;
        Some(Args {
            file: self,
            entity,
            record,
        })
    }

    /// The same, and an error if there is none.
    pub fn need<'e>(
        &'e self,
        entity: &'e Entity<'a>,
        names: &[&str],
    ) -> Result<Args<'e, 'a>, ImportError> {
        self.find(entity, names).ok_or_else(|| {
            self.source.error(
                entity.at,
                format!("`#{}` is {}", entity.id, with_article(&entity.name())),
                format!("{} is needed where it is named", one_of(names)),
            )
        })
    }

    /// The entities that have one of these records.
    pub fn all<'e>(&'e self, names: &'e [&str]) -> impl Iterator<Item = Args<'e, 'a>> {
        self.entities
            .iter()
            .filter_map(move |entity| self.find(entity, names))
    }
}

impl Entity<'_> {
    /// Its name for a message: of a complex one the names of its parts.
    pub fn name(&self) -> String {
        let names: Vec<&str> = self.records.iter().map(|record| record.name).collect();
        match names[..] {
            [] => "( )".into(),
            [name] => shortened(name),
            _ => format!("( {} )", shortened(&names.join(" "))),
        }
    }
}

fn one_of(names: &[&str]) -> String {
    match names {
        [one] => with_article(one),
        [first, others @ ..] => format!("{} or {}", with_article(first), others.join(" or ")),
        [] => "nothing".into(),
    }
}

impl<'e, 'a> Args<'e, 'a> {
    /// An error of the whole entity.
    pub fn error(&self, problem: impl std::fmt::Display, accepted: &str) -> ImportError {
        self.file.source.error(
            self.entity.at,
            format!("`#{}` {}: {problem}", self.entity.id, self.name()),
            accepted,
        )
    }

    /// The name of the record, for a message.
    pub fn name(&self) -> String {
        shortened(self.record.name)
    }

    fn wrong(&self, value: &Value, needed: &str) -> ImportError {
        let place = self.record.values.iter().position(|v| v.at >= value.at);
        self.file.source.error(
            value.at,
            format!(
                "`#{}` {}: parameter {} is {}",
                self.entity.id,
                self.name(),
                place.map_or(self.record.values.len(), |p| p + 1),
                value.name()
            ),
            format!("{needed} is needed"),
        )
    }

    /// A parameter.
    pub fn value(&self, index: usize) -> Result<&'e Value<'a>, ImportError> {
        self.record.values.get(index).ok_or_else(|| {
            self.error(
                format!("it has {} parameters", self.record.values.len()),
                &format!("at least {} are needed", index + 1),
            )
        })
    }

    fn as_number(&self, value: &Value) -> Result<f64, ImportError> {
        match &value.kind {
            Kind::Number(number, _) => Ok(*number),
            Kind::Typed(_, values) => match values[..] {
                [
                    Value {
                        kind: Kind::Number(number, _),
                        ..
                    },
                ] => Ok(number),
                _ => Err(self.wrong(value, "a number")),
            },
            _ => Err(self.wrong(value, "a number")),
        }
    }

    /// A number.
    pub fn number(&self, index: usize) -> Result<f64, ImportError> {
        self.as_number(self.value(index)?)
    }

    /// A list of numbers.
    pub fn numbers(&self, index: usize) -> Result<Vec<f64>, ImportError> {
        self.numbers_of(self.value(index)?)
    }

    /// The numbers of a list in a list.
    pub fn numbers_of(&self, value: &Value) -> Result<Vec<f64>, ImportError> {
        let list = self.members(value)?.iter();
        list.map(|value| self.as_number(value)).collect()
    }

    /// A whole number that is not negative.
    fn as_whole(&self, value: &Value) -> Result<usize, ImportError> {
        match value.kind {
            Kind::Number(number, true) if (0.0..=1e9).contains(&number) => Ok(number as usize),
            _ => Err(self.wrong(value, "a whole number from 0 to 1000000000")),
        }
    }

    /// A whole number that is not negative.
    pub fn whole(&self, index: usize) -> Result<usize, ImportError> {
        self.as_whole(self.value(index)?)
    }

    /// A list of them.
    pub fn wholes(&self, index: usize) -> Result<Vec<usize>, ImportError> {
        let list = self.list(index)?;
        list.iter().map(|value| self.as_whole(value)).collect()
    }

    /// `.T.` or `.F.`
    pub fn flag(&self, index: usize) -> Result<bool, ImportError> {
        let value = self.value(index)?;
        match value.kind {
            Kind::Word("T") => Ok(true),
            Kind::Word("F") => Ok(false),
            _ => Err(self.wrong(value, "`.T.` or `.F.`")),
        }
    }

    /// An enumerated value; nothing for `$`.
    pub fn word(&self, index: usize) -> Result<Option<&'a str>, ImportError> {
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
    pub fn list(&self, index: usize) -> Result<&'e [Value<'a>], ImportError> {
        self.members(self.value(index)?)
    }

    fn members<'v>(&self, value: &'v Value<'a>) -> Result<&'v [Value<'a>], ImportError> {
        match &value.kind {
            Kind::List(values) => Ok(values),
            _ => Err(self.wrong(value, "a list")),
        }
    }

    /// The entity that a value names.
    pub fn as_entity(&self, value: &Value) -> Result<&'e Entity<'a>, ImportError> {
        let Kind::Reference(id) = value.kind else {
            return Err(self.wrong(value, "a reference such as `#12`"));
        };
        self.file.get(id).ok_or_else(|| {
            self.file.source.error(
                value.at,
                format!(
                    "`#{}` {} names `#{id}`, which is not in the file",
                    self.entity.id,
                    self.name()
                ),
                "the number of an entity of this file is needed",
            )
        })
    }

    /// The entity that is named.
    pub fn entity(&self, index: usize) -> Result<&'e Entity<'a>, ImportError> {
        self.as_entity(self.value(index)?)
    }

    /// The entity that is named; nothing for `$` and `*`.
    pub fn maybe(&self, index: usize) -> Result<Option<&'e Entity<'a>>, ImportError> {
        let value = self.value(index)?;
        match value.kind {
            Kind::Omitted | Kind::Derived => Ok(None),
            _ => self.as_entity(value).map(Some),
        }
    }

    /// A list of entities.
    pub fn entities(&self, index: usize) -> Result<Vec<&'e Entity<'a>>, ImportError> {
        self.entities_of(self.value(index)?)
    }

    /// The entities of a list in a list.
    pub fn entities_of(&self, value: &Value<'a>) -> Result<Vec<&'e Entity<'a>>, ImportError> {
        let list = self.members(value)?.iter();
        list.map(|value| self.as_entity(value)).collect()
    }

    /// The record that the entity named has, of these names.
    pub fn named(&self, index: usize, names: &[&str]) -> Result<Args<'e, 'a>, ImportError> {
        self.file.need(self.entity(index)?, names)
    }
}
