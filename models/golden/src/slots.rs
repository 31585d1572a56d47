//! Slots of a fitted machine as text: the planes of each, with a `v` for those with half B, as in `3,0,2v`.

use crate::format::Format;
use crate::object::quadric::{MAX_PLANES, QuadricWords};
use crate::unit::depth_interval::Class;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// One object slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct FittedSlot {
    /// Cut planes, 0 to 12.
    pub planes: u32,
    /// With half B, for objects of class front.
    pub two_volumes: bool,
}

impl FittedSlot {
    /// What an object requires.
    pub fn of(words: &QuadricWords) -> FittedSlot {
        FittedSlot {
            planes: words.planes.len() as u32,
            two_volumes: words.class == Class::Front,
        }
    }

    /// A slot for the objects of both.
    pub fn or(&self, other: &FittedSlot) -> FittedSlot {
        FittedSlot {
            planes: self.planes.max(other.planes),
            two_volumes: self.two_volumes || other.two_volumes,
        }
    }

    /// Clocks from a slot's raster flags to its outputs.
    pub fn latency(&self, format: &Format, rows_per_stage: u32) -> u32 {
        let merge = u32::from(self.two_volumes);
        format.root_rows().div_ceil(rows_per_stage) + self.planes + 6 + merge
    }
}

/// Text that names no slots.
#[derive(Debug, Error, PartialEq, Eq)]
#[error(
    "'{0}' is no slot; expected a list such as 3,0,2v: the planes of each slot, 0 to {MAX_PLANES}, with a v for a slot with half B"
)]
pub struct SlotsError(String);

/// Reads slots.
pub fn parse(text: &str) -> Result<Vec<FittedSlot>, SlotsError> {
    let slot = |part: &str| {
        let without_half = part.strip_suffix('v');
        let planes = without_half.unwrap_or(part).parse().ok();
        let planes = planes.filter(|&planes| planes as usize <= MAX_PLANES);
        Ok(FittedSlot {
            planes: planes.ok_or_else(|| SlotsError(part.to_owned()))?,
            two_volumes: without_half.is_some(),
        })
    };
    text.split(',').map(slot).collect()
}

/// The text that [`parse`] reads back.
pub fn print(slots: &[FittedSlot]) -> String {
    let slot = |slot: &FittedSlot| {
        let half = if slot.two_volumes { "v" } else { "" };
        format!("{}{half}", slot.planes)
    };
    slots.iter().map(slot).collect::<Vec<_>>().join(",")
}

/// Slots that are written as text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Slots(pub Vec<FittedSlot>);

impl TryFrom<String> for Slots {
    type Error = SlotsError;

    fn try_from(text: String) -> Result<Slots, SlotsError> {
        parse(&text).map(Slots)
    }
}

impl From<Slots> for String {
    fn from(slots: Slots) -> String {
        print(&slots.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_slots_are_each_other() {
        let slots = parse("3,0,12v").unwrap();
        assert_eq!((slots[2].planes, slots[2].two_volumes), (12, true));
        assert_eq!((slots[0].planes, slots[0].two_volumes), (3, false));
        assert_eq!(print(&slots), "3,0,12v");
        for text in ["", "3,", "v", "13", "-1", "2w"] {
            assert!(parse(text).unwrap_err().to_string().contains("3,0,2v"));
        }
    }
}
