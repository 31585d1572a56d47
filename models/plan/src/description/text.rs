//! Descriptions as text.

use super::error::DescriptionError;
use super::keys::{Places, key};
use super::machine::{MachineDescription, most_planes};
use imogene_contract::slots::Slots;
use imogene_scene::{in_plain_words, line_and_column};
use serde::Deserialize;
use std::path::Path;
use toml::de::DeTable;

fn missing(name: &str, file: &str) -> Option<DescriptionError> {
    let (key, accepted) = key(name)?;
    Some(DescriptionError::Value {
        place: file.into(),
        key,
        value: "missing".into(),
        accepted,
    })
}

/// What the reader says of a text, with the key that it speaks of and what that accepts where its value is of another
/// type.
fn unread(
    error: &toml::de::Error,
    text: &str,
    file: &str,
    places: Option<&Places>,
) -> DescriptionError {
    let start = error.span().map_or(0, |span| span.start);
    let (line, column) = line_and_column(text, start);
    let said =
        in_plain_words(error.message()).replace("wanted string or table", "expected a string");
    let around = || key(places?.around(start)?);
    let named = said.strip_prefix("missing field `");
    let named = named.and_then(|rest| rest.strip_suffix('`'));
    let of_file = named.filter(|_| start == 0);
    if let Some(missing) = of_file.and_then(|name| missing(name, file)) {
        return missing;
    }
    let mut of_types = ["invalid", "missing", "expected"].into_iter();
    let is_of_type = of_types.any(|word| said.starts_with(word));
    DescriptionError::Syntax {
        file: file.into(),
        line,
        column,
        problem: match around() {
            Some((key, accepted)) if is_of_type => format!("{key}: {said}; accepted: {accepted}"),
            Some((key, _)) => format!("{key}: {said}"),
            None => said,
        },
    }
}

/// Most bytes of a description, which has a dozen lines.
const MAX_BYTES: u64 = 1 << 20;

impl MachineDescription {
    /// Reads and checks a description.
    /// Fails when the file cannot be read, is no description, or a value is out of its range.
    pub fn read(path: &Path) -> Result<MachineDescription, DescriptionError> {
        let file = path.display().to_string();
        match imogene_files::read_text(path, MAX_BYTES) {
            Ok(text) => Self::parse(&text, &file),
            Err(source) => Err(DescriptionError::Unreadable(file, source)),
        }
    }

    /// The same of a text; `file` is the name that messages give it.
    pub fn parse(text: &str, file: &str) -> Result<MachineDescription, DescriptionError> {
        let table = DeTable::parse(text).map_err(|error| unread(&error, text, file, None))?;
        let places = Places::of(table.get_ref());
        let mut description = Self::deserialize(toml::Deserializer::from(table))
            .map_err(|error| unread(&error, text, file, Some(&places)))?;
        if places.value("objects").is_none() && description.slots.is_none() {
            return Err(missing("objects", file).expect("a key"));
        }
        description.count_slots();
        description.check_at(&|key| match places.value(key) {
            Some(start) => {
                let (line, column) = line_and_column(text, start);
                format!("{file}:{line}:{column}")
            }
            None => file.to_owned(),
        })?;
        Ok(description)
    }

    /// The text of the description.
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("a description is a table of plain values")
    }

    /// Counts objects and planes where they are not given.
    fn count_slots(&mut self) {
        let Some(Slots(slots)) = &self.slots else {
            return;
        };
        if self.objects == 0 {
            self.objects = slots.len();
        }
        if self.planes == 0 {
            self.planes = most_planes(slots);
        }
    }
}
