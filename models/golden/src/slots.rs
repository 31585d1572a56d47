//! Slots of a fitted machine as text: the planes of each, with a `v` for those with half B, as in `3,0,2v`; those of
//! other kinds by their names, as in `patch2,sphere`.

use crate::format::Format;
use crate::object::quadric::{MAX_PLANES, QuadricWords};
use crate::object::slot::ProcessorWords;
use crate::unit::depth_interval::Class;
use imogene_contract::object::{KINDS, Kind, ProductSlots};
use imogene_contract::words::MOST_MEMBERS;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// One object slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct FittedSlot {
    /// Its processor.
    #[serde(default, skip_serializing_if = "is_quadric")]
    pub kind: Kind,
    /// Cut planes or sides, 0 to 12.
    pub planes: u32,
    /// With half B, for objects of class front.
    pub two_volumes: bool,
}

fn is_quadric(kind: &Kind) -> bool {
    *kind == Kind::Quadric
}

impl FittedSlot {
    /// A slot of quadrics without planes and half B.
    pub const NONE: FittedSlot = FittedSlot {
        kind: Kind::Quadric,
        planes: 0,
        two_volumes: false,
    };

    /// A slot for objects of every class.
    pub const fn full(planes: u32) -> FittedSlot {
        FittedSlot {
            kind: Kind::Quadric,
            planes,
            two_volumes: true,
        }
    }

    /// What words require of a processor of their own kind; nothing if there is none.
    pub fn of_words(words: &ProcessorWords) -> Option<FittedSlot> {
        let (kind, planes) = match words {
            ProcessorWords::Quadric(words) => return Some(FittedSlot::of(words)),
            ProcessorWords::Member(words) => return Some(FittedSlot::of(words.own())),
            ProcessorWords::Patch(words) => (Kind::Patch, words.planes.len()),
            ProcessorWords::FirstGeneration(_) => (Kind::FirstGeneration, 0),
            ProcessorWords::Polyhedron(words) => (Kind::Polyhedron, words.planes.len()),
            ProcessorWords::Facet(words) => (Kind::Facet, words.edges.len()),
            ProcessorWords::Sphere(_) => (Kind::Sphere, 0),
            ProcessorWords::Cylinder(_) => (Kind::Cylinder, 0),
            ProcessorWords::CurvedFacet(words) => (Kind::CurvedFacet, words.sides.len()),
            ProcessorWords::Quotient(_) => return None,
        };
        Some(FittedSlot {
            kind,
            planes: planes as u32,
            two_volumes: false,
        })
    }

    /// True if words are for processors of this kind too: surfaces of quadrics are for both of theirs.
    pub fn takes(&self, words: &ProcessorWords) -> bool {
        match words {
            ProcessorWords::Quadric(words) if words.class == Class::Patch => {
                matches!(self.kind, Kind::Quadric | Kind::Patch)
            }
            other => FittedSlot::of_words(other).is_some_and(|own| own.kind == self.kind),
        }
    }

    /// What an object requires.
    pub fn of(words: &QuadricWords) -> FittedSlot {
        FittedSlot {
            kind: Kind::Quadric,
            planes: words.planes.len() as u32,
            two_volumes: words.class == Class::Front,
        }
    }

    /// A slot for the objects of both, which are of one kind; of two, that of the other.
    pub fn or(&self, other: &FittedSlot) -> FittedSlot {
        if self.kind != other.kind {
            return *other;
        }
        FittedSlot {
            kind: self.kind,
            planes: self.planes.max(other.planes),
            two_volumes: self.two_volumes || other.two_volumes,
        }
    }

    /// Clocks from a slot's raster flags to its outputs.
    pub fn latency(&self, format: &Format, rows_per_stage: u32) -> u32 {
        let cuts = self.planes + u32::from(self.two_volumes);
        format.root_latency(rows_per_stage) + 2 * cuts + 9
    }
}

/// Text that names no slots.
#[derive(Debug, Error, PartialEq, Eq)]
#[error(
    "'{0}' is no slot; expected a list such as 3,0,2v: the planes of each slot, 0 to {MAX_PLANES}, with a v for a slot with half B; \
     in a machine description also patch3, polyhedron6, facet3, curved_facet2, sphere, cylinder, first_generation"
)]
pub struct SlotsError(String);

/// Reads slots of quadric processors.
pub fn parse(text: &str) -> Result<Vec<FittedSlot>, SlotsError> {
    text.split(',').map(quadrics).collect()
}

fn quadrics(part: &str) -> Result<FittedSlot, SlotsError> {
    let without_half = part.strip_suffix('v');
    let planes = without_half.unwrap_or(part).parse().ok();
    let planes = planes.filter(|&planes| planes as usize <= MAX_PLANES);
    Ok(FittedSlot {
        kind: Kind::Quadric,
        planes: planes.ok_or_else(|| SlotsError(part.to_owned()))?,
        two_volumes: without_half.is_some(),
    })
}

/// Reads slots of every kind.
fn parse_all(text: &str) -> Result<Vec<FittedSlot>, SlotsError> {
    text.split(',').map(any_kind).collect()
}

fn any_kind(part: &str) -> Result<FittedSlot, SlotsError> {
    let count = part.trim_start_matches(|letter: char| !letter.is_ascii_digit());
    let name = &part[..part.len() - count.len()];
    let Some(&(kind, _, [least, most])) = KINDS[1..].iter().find(|row| row.1 == name) else {
        return quadrics(part);
    };
    let planes = match most {
        0 if count.is_empty() => Some(0),
        0 => None,
        _ => count.parse().ok(),
    };
    let planes = planes.filter(|planes| (least..=most).contains(planes));
    Ok(FittedSlot {
        kind,
        planes: planes.ok_or_else(|| SlotsError(part.to_owned()))?,
        two_volumes: false,
    })
}

/// The text that [`parse`] reads back.
pub fn print(slots: &[FittedSlot]) -> String {
    let slot = |slot: &FittedSlot| {
        let half = if slot.two_volumes { "v" } else { "" };
        match (slot.kind, slot.kind.planes()) {
            (Kind::Quadric, _) => format!("{}{half}", slot.planes),
            (kind, [0, 0]) => kind.name().to_owned(),
            (kind, _) => format!("{}{}", kind.name(), slot.planes),
        }
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
        parse_all(&text).map(Slots)
    }
}

impl From<Slots> for String {
    fn from(slots: Slots) -> String {
        print(&slots.0)
    }
}

/// The slots of products, written as the objects that each intersects and those that it takes away: `2-1,1-3`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Products(pub Vec<ProductSlots>);

/// Text that names no products.
#[derive(Debug, Error, PartialEq, Eq)]
#[error(
    "'{0}' is no product; expected a list such as 2-1,1-3: objects intersected, 1 to {MOST_MEMBERS}, and objects taken away, \
     0 to {MOST_MEMBERS}"
)]
pub struct ProductsError(String);

fn product(part: &str) -> Result<ProductSlots, ProductsError> {
    let number = |text: &str, least: usize| {
        let number = text.parse().ok();
        number.filter(|number| (least..=MOST_MEMBERS as usize).contains(number))
    };
    let (intersected, subtracted) = part.split_once('-').unwrap_or_default();
    let slots = number(intersected, 1).zip(number(subtracted, 0));
    let (intersected, subtracted) = slots.ok_or_else(|| ProductsError(part.to_owned()))?;
    Ok(ProductSlots {
        intersected,
        subtracted,
    })
}

impl TryFrom<String> for Products {
    type Error = ProductsError;

    fn try_from(text: String) -> Result<Products, ProductsError> {
        text.split(',')
            .map(product)
            .collect::<Result<_, _>>()
            .map(Products)
    }
}

impl From<Products> for String {
    fn from(products: Products) -> String {
        let text =
            |product: &ProductSlots| format!("{}-{}", product.intersected, product.subtracted);
        products.0.iter().map(text).collect::<Vec<_>>().join(",")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_and_text_are_each_other() {
        let products = Products::try_from("2-1,1-16".to_owned()).unwrap();
        assert_eq!(
            (products.0[1].intersected, products.0[1].subtracted),
            (1, 16)
        );
        assert_eq!(String::from(products), "2-1,1-16");
        for text in ["", "2", "0-1", "1-17", "1-2-3", "a-1"] {
            let error = Products::try_from(text.to_owned()).unwrap_err();
            assert!(error.to_string().contains("2-1,1-3"), "{text}");
        }
    }

    #[test]
    fn text_and_slots_are_each_other() {
        let slots = parse("3,0,12v").unwrap();
        assert_eq!((slots[2].planes, slots[2].two_volumes), (12, true));
        assert_eq!((slots[0].planes, slots[0].two_volumes), (3, false));
        assert_eq!(print(&slots), "3,0,12v");
        let kinds = "3v,patch2,polyhedron6,facet3,curved_facet1,sphere,cylinder,first_generation";
        let slots: Slots = kinds.to_owned().try_into().unwrap();
        assert_eq!((slots.0[1].kind, slots.0[1].planes), (Kind::Patch, 2));
        assert_eq!(String::from(slots), kinds);
        for text in [
            "sphere1",
            "facet2",
            "patch",
            "patch13",
            "torus",
            "polyhedron0",
        ] {
            let error = Slots::try_from(text.to_owned()).unwrap_err();
            assert!(error.to_string().contains("curved_facet2"), "{text}");
        }
        for text in ["", "3,", "v", "13", "-1", "2w"] {
            assert!(parse(text).unwrap_err().to_string().contains("3,0,2v"));
        }
    }
}
