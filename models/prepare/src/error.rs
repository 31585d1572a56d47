//! Why a scene cannot be prepared for a format.

use crate::rounding::signed_bits;
use imogene_algebra::rational::to_f64;
use imogene_contract::words::{MOST_MEMBERS, MOST_OBJECTS};
use imogene_golden::object::quadric::ScreenBox;
use num_rational::BigRational;
use thiserror::Error;

/// An expression that leaves its word on a screen box.
#[derive(Clone, Debug, PartialEq)]
pub struct Excess {
    /// Which expression.
    pub word: String,
    /// log2 of the largest magnitude.
    pub log2: f64,
    /// Bits that would hold it.
    pub needed: u32,
    /// Bits that the format has.
    pub available: u32,
    /// The box.
    pub window: ScreenBox,
    /// What would do, if anything is known: a clause of its own.
    pub remedy: Box<str>,
}

impl Excess {
    /// The same in words; `whose` box it is.
    fn on(&self, whose: &str) -> String {
        let Excess {
            word,
            log2,
            needed,
            available,
            window: ScreenBox { x0, x1, y0, y1 },
            remedy,
        } = self;
        format!(
            "too large for the format: {word} reaches 2^{log2:.1} on {whose} screen box (columns {x0}..{x1}, lines \
             {y0}..{y1}) and would need {needed} bits, the word has {available}{remedy}"
        )
    }
}

/// A plane too steep for the plane word, and not provably a perpendicular one.
#[derive(Clone, Debug, Error, PartialEq)]
#[error(
    "passes so nearly through the viewer that its depth needs {needed} bits (the plane word has {available}), and at \
     pixel ({x}, {y}) it is not perpendicular to the screen either"
)]
pub struct Steep {
    /// Bits that would hold its depth.
    pub needed: u32,
    /// Bits that the format has.
    pub available: u32,
    /// Column of a pixel where the two forms differ.
    pub x: i64,
    /// Line of that pixel.
    pub y: i64,
}

/// What does in the place of a volume that cannot be had.
const WITHOUT: &str = "`shadows = false` at the light, or `casts_shadow = false` at the object";

/// One clear refusal: which object, what is wrong, what would be accepted.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PrepareError {
    /// The factor of z^2 is zero: depth is no square root. The quotient processor draws it, unless the machine has
    /// none.
    #[error(
        "object '{0}': the viewer lies exactly on this quadric, whose depth is then a quotient and no square \
         root; this kind of machine has processors of square roots alone"
    )]
    ViewerOnSurface(String),
    /// Orthographic view along an asymptotic direction: depth is no square root. The quotient processor draws it,
    /// unless the machine has none.
    #[error(
        "object '{0}': the orthographic viewing direction is an asymptotic direction of this quadric (a line of \
         sight meets it once), so its depth is a quotient and no square root; this kind of machine has processors of \
         square roots alone"
    )]
    AsymptoticView(String),
    /// An accumulator would leave its width on the object's screen box.
    #[error("object '{}': {}", .0, .1.on("the object's"))]
    TooLarge(String, Excess),
    /// A fitted machine has quadric processors alone.
    #[error(
        "object '{0}': drawn by a processor whose widths all follow from the depth word; \
         give --format, or draw it by the processor \"quadric\" or \"patch\""
    )]
    NotFitted(String),
    /// The two-plane algorithm of the first generation does not apply.
    #[error(
        "object '{0}': not for the processor \"first_generation\": {1}; the processor \"quadric\" draws it"
    )]
    FirstGeneration(String, &'static str),
    /// A corner of a mesh that has no place on the screen.
    #[error(
        "object '{object}', faces[{face}]: vertex {vertex} {problem}; leave the face out, or move the mesh"
    )]
    Corner {
        /// Name of the object.
        object: String,
        /// Index of the face, from 0.
        face: usize,
        /// Index of the vertex, from 0.
        vertex: usize,
        /// What is in the way.
        problem: &'static str,
    },
    /// A plane of an object, by the index of the cut from 0, too steep for the plane word, and not provably a
    /// perpendicular one.
    #[error("object '{0}', cut {1}: the plane {2}; turn the plane by a degree")]
    SteepPlane(String, usize, Steep),
    /// A solid whose trees multiply out to too much.
    #[error(
        "solid '{0}': as a union of products it needs more than {MOST_OBJECTS} processors; fewer unions that are \
         intersected or taken away would do, or several solids"
    )]
    Products(String),
    /// A product of a solid with too many objects.
    #[error(
        "solid '{}': one of its products intersects {} objects and takes {} away; at most {MOST_MEMBERS} each are \
         possible; several solids beside each other, each with a part of the holes, would do", .0, .1[0], .1[1]
    )]
    Product(String, [usize; 2]),
    /// A solid, an object that cannot be a part of it as it is seen, and what is in the way.
    #[error("solid '{0}': object '{1}' {2}")]
    Member(String, String, String),
    /// An object that cannot be transparent, and what is in the way.
    #[error("object '{0}': {1}")]
    Transparent(String, String),
    /// Transparent objects that have no order.
    #[error(
        "the transparent objects {0}: each is farther than the next somewhere, and the last than the first, so \
         that they cannot be blended in one order; cut them, move them apart, or make one of them opaque"
    )]
    NoOrder(String),
    /// A scene with solids or transparent objects where each object is looked at by itself.
    #[error(
        "object '{0}' belongs to a solid or is transparent, and this command looks at each object by itself; \
         `imogene machine`, `imogene fit` and `imogene render` take the scene"
    )]
    Composed(String),
    /// A solid casts no shadow: an object in it, and the index of a light with shadows.
    #[error(
        "solid '{0}': lights[{2}] has shadows, and that of object '{1}' would not be the solid's; give the object \
         `casts_shadow = false`"
    )]
    SolidShadow(String, String, usize),
    /// A source with shadows, by its index, stands in a solid that casts one.
    #[error(
        "object '{0}': lights[{1}] is inside this solid (or the solid is endless towards it), which would leave all \
         else in the dark; move the light out of it, or give the object `casts_shadow = false`"
    )]
    SourceInside(String, usize),
    /// The depth of a volume's quadric is no square root.
    #[error(
        "{0}: the viewer lies exactly on its surface (or looks along an asymptotic direction of it), so its depth \
         is no square root; leave the volume out: {WITHOUT}"
    )]
    ViewerOnVolume(String),
    /// An accumulator of a volume would leave its width on the volume's screen box.
    #[error("{}: {}; the volume may be left out: {WITHOUT}", .0, .1.on("its"))]
    VolumeTooLarge(String, Excess),
    /// The same of a volume.
    #[error("{0}: its plane {1} {2}; leave the volume out: {WITHOUT}")]
    VolumeSteepPlane(String, usize, Steep),
}

impl PrepareError {
    /// The refusal of an object's words, said of a volume.
    pub(super) fn in_volume(self, volume: &str) -> PrepareError {
        match self {
            Self::TooLarge(_, excess) => Self::VolumeTooLarge(volume.to_owned(), excess),
            other => other,
        }
    }
}

pub(super) fn too_large(
    object: &str,
    word: &str,
    magnitude: &BigRational,
    available: u32,
    window: &ScreenBox,
) -> PrepareError {
    let excess = Excess {
        word: word.to_string(),
        log2: log2(magnitude),
        needed: signed_bits(magnitude),
        available,
        window: *window,
        remedy: Box::default(),
    };
    PrepareError::TooLarge(object.to_string(), excess)
}

fn log2(magnitude: &BigRational) -> f64 {
    let bits = magnitude.ceil().to_integer().bits();
    if bits < 1000 {
        to_f64(magnitude).log2()
    } else {
        bits as f64
    }
}

/// What is left out of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Missing {
    /// True if only a shadow or a cone is missing.
    pub is_volume: bool,
    /// Why.
    pub reason: PrepareError,
}
