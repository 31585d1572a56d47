//! The patch processor: a surface, cut by planes that decide in parallel (source: 2.4.3, 5.2.1).
//!
//! It hands on what the quadric processor hands on for an object of class patch, from less hardware and earlier: no
//! second half, no merge, no plane normals, and one selection of a depth in the place of a chain.

use super::quadric::{ObjectPixel, PlaneWords, QuadricWords};
use crate::format::Format;
use crate::unit::normal::select;
use crate::unit::patch_decider::{Faces, decide, kept, visible};
use crate::unit::quadric_pe::QuadricDepths;

/// Latency in clocks from the raster flags to the outputs; the same for any number of planes.
pub fn latency(format: &Format, rows_per_stage: u32) -> u32 {
    format.root_latency(rows_per_stage) + 9
}

/// What the processor hands on for pixel (x, y) of the zone. The class and the normals of the planes are not read.
pub fn at(words: &QuadricWords, x: i64, y: i64, format: &Format) -> ObjectPixel {
    let depths = QuadricDepths::at(&words.f1, &words.f2, x, y, format);
    let (f2, root, near, far) = (depths.f2, depths.root, depths.near, depths.far);
    let there = f2 >= 0 && words.screen_box.contains(x, y);
    let signals = |plane: &PlaneWords| kept(plane.kind, plane.depth_at(x, y, format), near, far);
    let left = words.planes.iter().map(signals);
    let left = left.fold(visible(near, far, there, format), Faces::and);
    let face = decide(near, far, left, format);
    let g = || words.normal.linear_at(x, y, format);
    let normal = || select(face.nf, true, g(), root, &words.normal, &[], format);
    ObjectPixel::of(face, normal, format)
}
