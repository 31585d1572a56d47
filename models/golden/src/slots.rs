//! Which slots the words of an object stand in.

use crate::format::Format;
use crate::object::quadric::{self, QuadricWords};
use crate::object::slot::ProcessorWords;
use crate::unit::depth_interval::Class;
use crate::unit::root::Method;
use imogene_contract::object::Kind;
use imogene_contract::slots::FittedSlot;

/// What words require of a processor of their own kind; `None` if there is none.
pub fn required(words: &ProcessorWords) -> Option<FittedSlot> {
    let (kind, planes) = match words {
        ProcessorWords::Quadric(words) => return Some(required_of_quadric(words)),
        ProcessorWords::Member(words) => return Some(required_of_quadric(words.own())),
        ProcessorWords::Patch(words) => (Kind::Patch, words.planes.len()),
        ProcessorWords::FirstGeneration(_) => (Kind::FirstGeneration, 0),
        ProcessorWords::Polyhedron(words) => (Kind::Polyhedron, words.planes.len()),
        ProcessorWords::Facet(words) => (Kind::Facet, words.edges.len()),
        ProcessorWords::Sphere(_) => (Kind::Sphere, 0),
        ProcessorWords::Cylinder(_) => (Kind::Cylinder, 0),
        ProcessorWords::CurvedFacet(words) => (Kind::CurvedFacet, words.sides.len()),
        ProcessorWords::Quotient(words) if words.root.is_some() => return None,
        ProcessorWords::Quotient(words) => (Kind::Quotient, words.planes.len()),
    };
    Some(FittedSlot::of(kind, planes as u32))
}

/// What an object requires of a quadric processor.
pub fn required_of_quadric(words: &QuadricWords) -> FittedSlot {
    FittedSlot::quadric(words.planes.len() as u32)
}

/// The words for the processor of their own kind: those of a surface of a quadric for that of patches.
pub fn own_kind(words: ProcessorWords) -> ProcessorWords {
    match words {
        ProcessorWords::Quadric(words) if words.class == Class::Patch => {
            ProcessorWords::Patch(words)
        }
        other => other,
    }
}

/// True if words are for processors of this kind too: surfaces of quadrics are for both of theirs.
pub fn takes(slot: &FittedSlot, words: &ProcessorWords) -> bool {
    match words {
        ProcessorWords::Quadric(words) if words.class == Class::Patch => {
            matches!(slot.kind, Kind::Quadric | Kind::Patch)
        }
        other => required(other).is_some_and(|own| own.kind == slot.kind),
    }
}

/// Clocks from a slot's raster flags to its outputs.
pub fn latency(slot: &FittedSlot, format: &Format, rows_per_stage: u32) -> u32 {
    let rows = slot.root.unwrap_or(format.root) - format.dropped_rows;
    let root = Method::of(format.root_form).latency(rows, rows_per_stage);
    root + quadric::after_root(slot.planes as usize)
}
