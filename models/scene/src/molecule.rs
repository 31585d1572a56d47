//! Molecules of a scene that stand in a structure file of their own.

use super::keys::{is_yes, yes};
use serde::{Deserialize, Deserializer, Serialize};

/// A structure file, and what of it is drawn and how; crate `imogene-import` reads it and knows what each key takes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Molecule {
    /// Path of the structure file, from the folder of the scene.
    pub file: String,
    /// Stands in front of the names of its objects.
    pub name: Option<String>,
    /// Name of the group that its objects belong to.
    pub group: Option<String>,
    /// How it is drawn.
    #[serde(default = "space_filling")]
    pub style: String,
    /// What gives the colours.
    #[serde(default = "element")]
    pub colour: String,
    /// Which models.
    #[serde(default = "first", deserialize_with = "word_or_number")]
    pub model: String,
    /// Which alternate locations.
    #[serde(default = "best")]
    pub alternates: String,
    /// Whether hydrogens are drawn.
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    pub hydrogens: bool,
    /// Whether water is drawn.
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    pub water: bool,
    /// Chains by name; all if there are none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub chains: Vec<String>,
    /// Residues by number, range or name; all if there are none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub residues: Vec<String>,
    /// The assembly whose copies are drawn; the coordinates as they stand without one.
    pub assembly: Option<String>,
}

impl Default for Molecule {
    /// As it is without any other key than `file`.
    fn default() -> Self {
        toml::from_str("file = \"\"").expect("all other keys may be left out")
    }
}

fn space_filling() -> String {
    "space-filling".to_owned()
}

fn element() -> String {
    "element".to_owned()
}

fn first() -> String {
    "first".to_owned()
}

fn best() -> String {
    "best".to_owned()
}

/// A word, or a number that stands without quotes.
fn word_or_number<'de, D: Deserializer<'de>>(input: D) -> Result<String, D::Error> {
    #[derive(Deserialize)]
    #[serde(
        untagged,
        expecting = "a number, \"first\" or \"all\" would be accepted"
    )]
    enum Either {
        Number(i64),
        Word(String),
    }
    Ok(match Either::deserialize(input)? {
        Either::Number(number) => number.to_string(),
        Either::Word(word) => word,
    })
}
