//! Why a scene cannot be prepared for a format.

use thiserror::Error;

/// One clear refusal: which object, what is wrong, what would be accepted.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PrepareError {
    /// The factor of z^2 is zero: depth is no square root. The quotient processor draws it, unless the machine has none.
    #[error(
        "object '{object}': the viewer lies exactly on this quadric, whose depth is then a quotient and no square root; \
         this kind of machine has processors of square roots alone"
    )]
    ViewerOnSurface {
        /// Name of the object.
        object: String,
    },
    /// Orthographic view along an asymptotic direction: depth is no square root. The quotient processor draws it, unless the machine has none.
    #[error(
        "object '{object}': the orthographic viewing direction is an asymptotic direction of this quadric \
         (a line of sight meets it once), so its depth is a quotient and no square root; this kind of machine has processors of square roots alone"
    )]
    AsymptoticView {
        /// Name of the object.
        object: String,
    },
    /// An accumulator would leave its width on the object's screen box.
    #[error(
        "object '{object}': too large for the format: {word} reaches 2^{log2:.1} on the object's screen box \
         (columns {x0}..{x1}, lines {y0}..{y1}) and would need {needed} bits, the word has {available}{remedy}"
    )]
    TooLarge {
        /// Name of the object.
        object: String,
        /// Which expression.
        word: String,
        /// log2 of the largest magnitude.
        log2: f64,
        /// Bits that would hold it.
        needed: u32,
        /// Bits that the format has.
        available: u32,
        /// First column of the box.
        x0: i64,
        /// Last column of the box.
        x1: i64,
        /// First line of the box.
        y0: i64,
        /// Last line of the box.
        y1: i64,
        /// What would do, if anything is known: a clause of its own.
        remedy: Box<str>,
    },
    /// A fitted machine has quadric processors alone.
    #[error(
        "object '{object}': drawn by a processor whose widths all follow from the depth word; \
         give --format, or draw it by the processor \"quadric\" or \"patch\""
    )]
    NotFitted {
        /// Name of the object.
        object: String,
    },
    /// The two-plane algorithm of the first generation does not apply.
    #[error(
        "object '{object}': not for the processor \"first_generation\": {problem}; \
         the processor \"quadric\" draws it"
    )]
    FirstGeneration {
        /// Name of the object.
        object: String,
        /// What is in the way.
        problem: &'static str,
    },
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
    /// A plane too steep for the plane word, and not provably a perpendicular one.
    #[error(
        "object '{object}', cut {plane}: the plane passes so nearly through the viewer that its depth needs {needed} bits \
         (the plane word has {available}), and at pixel ({x}, {y}) it is not perpendicular to the screen either; \
         turn the plane by a degree"
    )]
    SteepPlane {
        /// Name of the object.
        object: String,
        /// Index of the cut, from 0.
        plane: usize,
        /// Bits that would hold its depth.
        needed: u32,
        /// Bits that the format has.
        available: u32,
        /// Column of a pixel where the two forms differ.
        x: i64,
        /// Line of that pixel.
        y: i64,
    },
    /// A source with shadows stands in a solid that casts one.
    #[error(
        "object '{object}': lights[{source_index}] is inside this solid (or the solid is endless towards it), which would leave all else in the dark; \
         move the light out of it, or give the object `casts_shadow = false`"
    )]
    SourceInside {
        /// Name of the object.
        object: String,
        /// Index of the light.
        source_index: usize,
    },
    /// The depth of a volume's quadric is no square root.
    #[error(
        "{volume}: the viewer lies exactly on its surface (or looks along an asymptotic direction of it), so its depth is no square root; \
         leave the volume out: `shadows = false` at the light, or `casts_shadow = false` at the object"
    )]
    ViewerOnVolume {
        /// The volume.
        volume: String,
    },
    /// An accumulator of a volume would leave its width on the volume's screen box.
    #[error(
        "{volume}: too large for the format: {word} reaches 2^{log2:.1} on its screen box (columns {x0}..{x1}, lines {y0}..{y1}) \
         and would need {needed} bits, the word has {available}{remedy}; \
         the volume may be left out: `shadows = false` at the light, or `casts_shadow = false` at the object"
    )]
    VolumeTooLarge {
        /// The volume.
        volume: String,
        /// Which expression.
        word: String,
        /// log2 of the largest magnitude.
        log2: f64,
        /// Bits that would hold it.
        needed: u32,
        /// Bits that the format has.
        available: u32,
        /// First column of the box.
        x0: i64,
        /// Last column of the box.
        x1: i64,
        /// First line of the box.
        y0: i64,
        /// Last line of the box.
        y1: i64,
        /// What would do, if anything is known: a clause of its own.
        remedy: Box<str>,
    },
    /// A plane of a volume too steep for the plane word, and not provably a perpendicular one.
    #[error(
        "{volume}: its plane {plane} passes so nearly through the viewer that its depth needs {needed} bits (the plane word has {available}), \
         and at pixel ({x}, {y}) it is not perpendicular to the screen either; \
         leave the volume out: `shadows = false` at the light, or `casts_shadow = false` at the object"
    )]
    VolumeSteepPlane {
        /// The volume.
        volume: String,
        /// Index of the plane, from 0.
        plane: usize,
        /// Bits that would hold its depth.
        needed: u32,
        /// Bits that the format has.
        available: u32,
        /// Column of a pixel where the two forms differ.
        x: i64,
        /// Line of that pixel.
        y: i64,
    },
}
