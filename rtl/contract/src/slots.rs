//! Slots of a fitted machine, and as text: the planes of each, as in `3,0,2`; those of other kinds by their names, as
//! in `patch2,sphere`; before one how many there are of it, as in `64xfacet3`; behind it the words that are shorter
//! than those of the machine, as in `2:r14:p20`.

use crate::machine_words::MachineWords;
use crate::object::{KINDS, Kind, ProductSlots};
use crate::words::{MOST_MEMBERS, MOST_OBJECTS, MOST_PLANES, WordRange};
use serde::{Deserialize, Serialize};
use std::fmt;
use thiserror::Error;

/// One object slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct FittedSlot {
    /// Its processor.
    #[serde(default, skip_serializing_if = "is_quadric")]
    pub kind: Kind,
    /// Cut planes or sides, 0 to 12.
    pub planes: u32,
    /// Bits of its root, if they are fewer than those of the machine: of quadrics and patches alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<u32>,
    /// Bits of the words of its planes, likewise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plane: Option<u32>,
}

fn is_quadric(kind: &Kind) -> bool {
    *kind == Kind::Quadric
}

impl FittedSlot {
    /// A slot of quadrics without planes.
    pub const NONE: FittedSlot = FittedSlot::of(Kind::Quadric, 0);

    /// A slot of a kind in the words of its machine.
    pub const fn of(kind: Kind, planes: u32) -> FittedSlot {
        FittedSlot {
            kind,
            planes,
            root: None,
            plane: None,
        }
    }

    /// A slot for quadrics.
    pub const fn quadric(planes: u32) -> FittedSlot {
        FittedSlot::of(Kind::Quadric, planes)
    }

    /// A slot for the objects of both, which are of one kind; of two, that of the other.
    pub fn or(&self, other: &FittedSlot) -> FittedSlot {
        if self.kind != other.kind {
            return *other;
        }
        FittedSlot {
            kind: self.kind,
            planes: self.planes.max(other.planes),
            root: longer(self.root, other.root),
            plane: longer(self.plane, other.plane),
        }
    }

    /// Is it for what needs the other: of its kind, with as many planes and bits?
    pub fn holds(&self, needed: &FittedSlot) -> bool {
        let is_long = |own: Option<u32>, needed: Option<u32>| {
            own.is_none_or(|own| needed.is_some_and(|needed| needed <= own))
        };
        self.kind == needed.kind
            && self.planes >= needed.planes
            && is_long(self.root, needed.root)
            && is_long(self.plane, needed.plane)
    }

    /// Bits of its root and of the words of its planes; those of the machine are more than any other.
    pub fn bits(&self) -> [u32; 2] {
        [self.root, self.plane].map(|own| own.unwrap_or(u32::MAX))
    }

    /// The same slot in the words of its machine.
    pub const fn in_all_bits(&self) -> FittedSlot {
        FittedSlot::of(self.kind, self.planes)
    }

    /// Its words in a machine of these.
    pub fn words(&self, machine: &MachineWords) -> MachineWords {
        MachineWords {
            root: self.root.unwrap_or(machine.root),
            plane: self.plane.unwrap_or(machine.plane),
            ..*machine
        }
    }

    /// The same slot in as few bits of root and planes as these words have, which are no longer than the machine's.
    pub fn in_words(&self, own: &MachineWords, machine: &MachineWords) -> FittedSlot {
        let shorter = |own: u32, machine: u32| (own < machine).then_some(own);
        FittedSlot {
            root: shorter(own.root, machine.root),
            plane: shorter(own.plane, machine.plane),
            ..*self
        }
    }

    /// The first of its words that is out of its range in a machine of these: what it is, its bits, the least and the
    /// most.
    pub fn refused(&self, machine: &MachineWords) -> Option<WordRange> {
        if !matches!(self.kind, Kind::Quadric | Kind::Patch) {
            return self.refused_of_other_kind(machine);
        }
        let least = machine.least_root();
        let words = [
            ("root of a slot", self.root, least, machine.root),
            (
                "plane word of a slot",
                self.plane,
                machine.depth,
                machine.plane,
            ),
        ];
        words.into_iter().find_map(|(word, bits, least, most)| {
            let bits = bits.filter(|bits| !(least..=most).contains(bits))?;
            Some((word, bits, least, most))
        })
    }

    /// The same of other kinds than quadrics and patches: their words are those that follow from the depth word.
    fn refused_of_other_kind(&self, machine: &MachineWords) -> Option<WordRange> {
        let usual = MachineWords::of(machine.depth);
        if let Some(own) = self.root.or(self.plane) {
            return Some(("own words of another kind of slot", own, 0, 0));
        }
        let words = [
            ("root beside another kind of slot", machine.root, usual.root),
            (
                "plane word beside another kind of slot",
                machine.plane,
                usual.plane,
            ),
            (
                "normal beside another kind of slot",
                machine.normal,
                usual.normal,
            ),
            (
                "dropped digits beside another kind of slot",
                machine.dropped_rows,
                0,
            ),
        ];
        let other = words.into_iter().find(|(_, bits, usual)| bits != usual);
        other.map(|(word, bits, usual)| (word, bits, usual, usual))
    }
}

/// One slot of each kind of these, in their order, that is for the objects of all of its kind.
pub fn one_of_each(slots: impl IntoIterator<Item = FittedSlot>) -> Vec<FittedSlot> {
    let mut kinds: Vec<FittedSlot> = vec![];
    for slot in slots {
        match kinds.iter_mut().find(|kind| kind.kind == slot.kind) {
            Some(kind) => *kind = kind.or(&slot),
            None => kinds.push(slot),
        }
    }
    kinds
}

/// The longer of two words, of which that of the machine is the longest.
fn longer(one: Option<u32>, other: Option<u32>) -> Option<u32> {
    one.zip(other).map(|(one, other)| one.max(other))
}

/// Slots that are counted rather than written one by one.
const LEAST_COUNTED: usize = 4;

/// Text that names no slots.
#[derive(Debug, Error, PartialEq, Eq)]
#[error(
    "'{0}' is no slot; expected a list such as 3,0,2: the planes of each slot, 0 to {MOST_PLANES}, \
     patch3, polyhedron6, facet3, curved_facet2, sphere, cylinder, first_generation or quotient2, \
     before one how many there are of it, as in 64xfacet3, and behind one the bits of a shorter root and of shorter plane words, as in 2:r14:p20"
)]
pub struct SlotsError(String);

/// Reads slots.
pub fn parse(text: &str) -> Result<Vec<FittedSlot>, SlotsError> {
    let slots = |text: &str| alike(text).ok_or_else(|| SlotsError(text.to_owned()));
    let slots: Result<Vec<_>, _> = text.split(',').map(slots).collect();
    slots.map(|slots| slots.concat())
}

/// One slot, or several: `64xfacet3`.
fn alike(text: &str) -> Option<Vec<FittedSlot>> {
    let (count, shape) = text.split_once('x').unwrap_or(("1", text));
    let count = count.parse().ok();
    let count = count.filter(|count| (1..=MOST_OBJECTS).contains(count))?;
    Some(vec![slot(shape)?; count as usize])
}

fn slot(text: &str) -> Option<FittedSlot> {
    let mut pieces = text.split(':');
    let shape = pieces.next().and_then(any_kind)?;
    pieces.try_fold(shape, |slot, piece| {
        let bits = |letter: char| piece.strip_prefix(letter)?.parse().ok();
        match (bits('r'), bits('p')) {
            (root @ Some(_), _) if slot.root.is_none() => Some(FittedSlot { root, ..slot }),
            (_, plane @ Some(_)) if slot.plane.is_none() => Some(FittedSlot { plane, ..slot }),
            _ => None,
        }
    })
}

/// A `v` behind the planes is read over: it stood for objects of class front, which need nothing of their own.
fn quadric(shape: &str) -> Option<FittedSlot> {
    let planes = shape.strip_suffix('v').unwrap_or(shape).parse().ok();
    let planes = planes.filter(|&planes| planes <= MOST_PLANES)?;
    Some(FittedSlot::quadric(planes))
}

fn any_kind(shape: &str) -> Option<FittedSlot> {
    let count = shape.trim_start_matches(|letter: char| !letter.is_ascii_digit());
    let name = &shape[..shape.len() - count.len()];
    let Some(&(kind, _, [least, most])) = KINDS[1..].iter().find(|row| row.1 == name) else {
        return quadric(shape);
    };
    let planes = match most {
        0 if count.is_empty() => Some(0),
        0 => None,
        _ => count.parse().ok(),
    };
    let planes = planes.filter(|planes| (least..=most).contains(planes));
    Some(FittedSlot::of(kind, planes?))
}

/// The text that [`parse`] reads back.
pub fn print(slots: &[FittedSlot]) -> String {
    let runs = slots.chunk_by(|one, next| one == next);
    let runs = runs.map(|run| match run.len() {
        count if count < LEAST_COUNTED => vec![run[0].to_string(); count].join(","),
        count => format!("{count}x{}", run[0]),
    });
    runs.collect::<Vec<String>>().join(",")
}

impl fmt::Display for FittedSlot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.kind != Kind::Quadric {
            f.write_str(self.kind.name())?;
        }
        if self.kind.planes() != [0, 0] {
            write!(f, "{}", self.planes)?;
        }
        self.root.map_or(Ok(()), |root| write!(f, ":r{root}"))?;
        self.plane.map_or(Ok(()), |plane| write!(f, ":p{plane}"))
    }
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
        let products = text.split(',').map(product);
        products.collect::<Result<_, _>>().map(Products)
    }
}

impl From<Products> for String {
    fn from(products: Products) -> String {
        let text =
            |product: &ProductSlots| format!("{}-{}", product.intersected, product.subtracted);
        products.0.iter().map(text).collect::<Vec<_>>().join(",")
    }
}
