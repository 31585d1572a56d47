//! How a machine chooses the nearest of its objects (source: IMOGENE, IV.3.2 and IV.3.6).

use crate::words::MOST_OBJECTS;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// A form of the decider: `tree`, `chain`, `cards4`.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
#[serde(try_from = "String", into = "String")]
pub enum DeciderForm {
    /// A binary tree behind all processors.
    #[default]
    Tree,
    /// A cell beside each processor, which comes a clock after the one before.
    Chain,
    /// Cards of so many processors with a chain on each, and a tree of what leaves them.
    Cards(u32),
}

/// Text that names no form of the decider.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error(
    "'{0}' is no form of the decider; accepted: tree, chain, and cards1 to cards{MOST_OBJECTS} by the processors of a card"
)]
pub struct DeciderFormError(String);

impl DeciderForm {
    /// True for the form that all machines have that name none.
    pub fn is_usual(&self) -> bool {
        *self == DeciderForm::Tree
    }
}

impl FromStr for DeciderForm {
    type Err = DeciderFormError;

    fn from_str(text: &str) -> Result<DeciderForm, DeciderFormError> {
        let cards = || {
            let count = text.strip_prefix("cards")?.parse().ok()?;
            let is_card = (1..=MOST_OBJECTS).contains(&count);
            is_card.then_some(DeciderForm::Cards(count))
        };
        match text {
            "tree" => Ok(DeciderForm::Tree),
            "chain" => Ok(DeciderForm::Chain),
            _ => cards().ok_or_else(|| DeciderFormError(text.to_owned())),
        }
    }
}

impl fmt::Display for DeciderForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DeciderForm::Tree => f.write_str("tree"),
            DeciderForm::Chain => f.write_str("chain"),
            DeciderForm::Cards(processors) => write!(f, "cards{processors}"),
        }
    }
}

impl TryFrom<String> for DeciderForm {
    type Error = DeciderFormError;

    fn try_from(text: String) -> Result<DeciderForm, DeciderFormError> {
        text.parse()
    }
}

impl From<DeciderForm> for String {
    fn from(form: DeciderForm) -> String {
        form.to_string()
    }
}
