//! Words that switch off what a scene leaves unused: a plane that cuts nothing, and a processor that draws or shades
//! nothing.

use super::first_generation::ContourPlane;
use super::load::{KIND_WIDTH, LoadWord};
use super::load_volume::CONTROL_WIDTH;
use super::quadric::{PlaneWords, ScreenBox};
use super::volume::VolumePlane;
use crate::format::Format;
use crate::unit::cut_plane::PlaneKind;
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use imogene_contract::object::{self, Kind};
use imogene_contract::volume;
use serde::Serialize;

/// A plane or side that cuts nothing, in the words of its processor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum UnusedPlane {
    /// Of a chain or tree of cut planes; a patch reads no normal.
    Plane(PlaneWords),
    /// Of a volume.
    Volume(VolumePlane),
    /// Of the first generation: nowhere inside the quadric, whose middle is on the kept side.
    Contour(ContourPlane),
    /// Side of a flat facet: zero is inside.
    Side(Linear),
    /// Side of a facet that is not flat, likewise.
    CurvedSide(Quadratic),
}

/// What a processor of one kind is given where the scene has nothing for it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Unused {
    /// Kind of the processor, as objects name it; `volume` for shadows and lights.
    pub processor: &'static str,
    /// A plane or side that cuts nothing, of processors that have any.
    pub plane: Option<UnusedPlane>,
    /// Words of the load bus that make plane 0 cut nothing; its other words do not matter. Empty where planes have no
    /// kind.
    pub plane_load_words: Vec<LoadWord>,
    /// What is added to their addresses from plane to plane.
    pub plane_address_step: Option<u8>,
    /// The screen box of a processor without an object.
    pub screen_box: ScreenBox,
    /// Words of the load bus that make it absent; its other words do not matter.
    pub slot_load_words: Vec<LoadWord>,
}

/// The word that makes plane `index` of a quadric processor cut nothing: its kind.
pub fn object_plane(index: usize) -> LoadWord {
    no_kind(object::words(index))
}

/// The same of a volume processor.
pub fn volume_plane(index: usize) -> LoadWord {
    no_kind(volume::words(index))
}

fn no_kind(address: usize) -> LoadWord {
    LoadWord {
        address: address as u8,
        bits: PlaneKind::None as u64,
        width: KIND_WIDTH,
    }
}

/// The word that makes the processor of a slot draw nothing: the columns of an empty box.
pub fn empty_slot(kind: Kind) -> LoadWord {
    empty_columns(kind.box_columns())
}

/// The words with which a volume processor takes no light away: a shadow in an empty box. A light would take it away
/// outside of its box.
pub fn volume_slot() -> [LoadWord; 2] {
    let shadow = LoadWord {
        address: volume::CONTROL as u8,
        bits: 0,
        width: CONTROL_WIDTH,
    };
    [empty_columns(volume::BOX_COLUMNS), shadow]
}

fn empty_columns(address: u64) -> LoadWord {
    let ScreenBox { x0, x1, .. } = ScreenBox::EMPTY;
    LoadWord {
        address: address as u8,
        bits: x0 as u64 | (x1 as u64) << 12,
        width: Format::BOX_WORD,
    }
}

/// What every kind of processor is given where there is nothing for it.
pub fn every_kind() -> Vec<Unused> {
    let contour = ContourPlane {
        conic: Quadratic::new([0, 0, 0, 0, 0, -1]),
        ..ContourPlane::default()
    };
    let curved = UnusedPlane::CurvedSide(Quadratic::default());
    let of_volume = UnusedPlane::Volume(VolumePlane::default());
    let plane = UnusedPlane::Plane(PlaneWords::default());
    // A plane whose kind is none, all zeros, cuts nothing.
    let of_kind = |kind: Kind, plane: Option<UnusedPlane>| {
        let [first, second] = [0, 1].map(|planes| kind.words(planes));
        let has_kind = matches!(plane, Some(UnusedPlane::Plane(_)));
        Unused {
            processor: kind.name(),
            plane,
            plane_load_words: has_kind.then(|| no_kind(first)).into_iter().collect(),
            plane_address_step: has_kind.then_some((second - first) as u8),
            screen_box: ScreenBox::EMPTY,
            slot_load_words: vec![empty_slot(kind)],
        }
    };
    vec![
        of_kind(Kind::Quadric, Some(plane)),
        of_kind(Kind::Patch, Some(plane)),
        of_kind(Kind::Polyhedron, Some(plane)),
        of_kind(Kind::FirstGeneration, Some(UnusedPlane::Contour(contour))),
        of_kind(Kind::Facet, Some(UnusedPlane::Side(Linear::default()))),
        of_kind(Kind::CurvedFacet, Some(curved)),
        of_kind(Kind::Sphere, None),
        of_kind(Kind::Cylinder, None),
        of_kind(Kind::Quotient, Some(plane)),
        Unused {
            plane_load_words: vec![volume_plane(0)],
            plane_address_step: Some(volume::PLANE_WORDS as u8),
            slot_load_words: volume_slot().to_vec(),
            processor: "volume",
            ..of_kind(Kind::Quadric, Some(of_volume))
        },
    ]
}
