//! Words that switch off what a scene leaves unused: a plane that cuts nothing, and a processor that draws or shades
//! nothing.

use super::first_generation::ContourPlane;
use super::load::{self, LoadWord};
use super::load_volume;
use super::quadric::{PlaneWords, ScreenBox};
use super::volume::VolumePlane;
use crate::format::Format;
use crate::unit::cut_plane::PlaneKind;
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
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
    /// Words of the load bus that make plane 0 cut nothing; its other words do not matter. Empty where there is no
    /// load bus.
    pub plane_load_words: Vec<LoadWord>,
    /// What is added to their addresses from plane to plane.
    pub plane_address_step: Option<u8>,
    /// The screen box of a processor without an object.
    pub screen_box: ScreenBox,
    /// Words of the load bus that make it absent; its other words do not matter. Empty where there is no load bus.
    pub slot_load_words: Vec<LoadWord>,
}

/// The word that makes plane `index` of a quadric processor cut nothing: its kind.
pub fn object_plane(index: usize) -> LoadWord {
    no_kind(load::FIRST_PLANE, load::PLANE_WORDS, index)
}

/// The same of a volume processor.
pub fn volume_plane(index: usize) -> LoadWord {
    no_kind(load_volume::FIRST_PLANE, load_volume::PLANE_WORDS, index)
}

fn no_kind(first: u8, words: u8, index: usize) -> LoadWord {
    LoadWord {
        address: first + words * index as u8,
        bits: PlaneKind::None as u64,
        width: load::KIND_WIDTH,
    }
}

/// The word that makes a quadric processor draw nothing: the columns of an empty box.
pub fn object_slot() -> LoadWord {
    empty_columns(load::BOX_COLUMNS)
}

/// The words with which a volume processor takes no light away: a shadow in an empty box. A light would take it away
/// outside of its box.
pub fn volume_slot() -> [LoadWord; 2] {
    let shadow = LoadWord {
        address: load_volume::CONTROL,
        bits: 0,
        width: load_volume::CONTROL_WIDTH,
    };
    [empty_columns(load_volume::BOX_COLUMNS), shadow]
}

fn empty_columns(address: u8) -> LoadWord {
    let ScreenBox { x0, x1, .. } = ScreenBox::EMPTY;
    LoadWord {
        address,
        bits: x0 as u64 | (x1 as u64) << 12,
        width: Format::BOX_WORD,
    }
}

/// What every kind of processor is given where there is nothing for it.
pub fn every_kind() -> Vec<Unused> {
    let outside = Quadratic {
        f: -1,
        ..Quadratic::default()
    };
    let contour = ContourPlane {
        conic: outside,
        ..ContourPlane::default()
    };
    let plane = UnusedPlane::Plane(PlaneWords::default());
    let ports_only = |processor, plane| Unused {
        processor,
        plane,
        plane_load_words: vec![],
        plane_address_step: None,
        screen_box: ScreenBox::EMPTY,
        slot_load_words: vec![],
    };
    vec![
        Unused {
            plane_load_words: vec![object_plane(0)],
            plane_address_step: Some(load::PLANE_WORDS),
            slot_load_words: vec![object_slot()],
            ..ports_only("quadric", Some(plane))
        },
        ports_only("patch", Some(plane)),
        ports_only("polyhedron", Some(plane)),
        ports_only("first_generation", Some(UnusedPlane::Contour(contour))),
        ports_only("facet", Some(UnusedPlane::Side(Linear::default()))),
        ports_only(
            "curved_facet",
            Some(UnusedPlane::CurvedSide(Quadratic::default())),
        ),
        ports_only("sphere", None),
        ports_only("cylinder", None),
        Unused {
            plane_load_words: vec![volume_plane(0)],
            plane_address_step: Some(load_volume::PLANE_WORDS),
            slot_load_words: volume_slot().to_vec(),
            ..ports_only("volume", Some(UnusedPlane::Volume(VolumePlane::default())))
        },
    ]
}
