//! The decider: which object is seen at a pixel (source: visibility tree; design decision: ties go to the smaller id).

use crate::object::quadric::ObjectPixel;
use serde::Serialize;

/// One input or output of the decider: what an object processor hands on, with the object's id.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Visible {
    /// Front depth; the format's `z_max` where nothing is seen.
    pub depth: i64,
    /// Index of the object.
    pub id: u8,
    /// Number of the visible face.
    pub number: u8,
    /// Normal of the visible face.
    pub normal: [i16; 3],
}

impl Visible {
    /// An object processor's output with the id of its slot.
    pub fn of(pixel: &ObjectPixel, id: u8) -> Visible {
        Visible {
            depth: pixel.zf,
            id,
            number: pixel.number,
            normal: pixel.normal,
        }
    }
}

/// The nearer input; the smaller id at equal depth, so that the order of the inputs never matters.
pub fn visibility_node(a: Visible, b: Visible) -> Visible {
    let is_first = (a.depth, a.id) <= (b.depth, b.id);
    if is_first { a } else { b }
}

/// Latency in clocks of a tree of `inputs` inputs.
pub fn latency(inputs: usize) -> u32 {
    inputs.next_power_of_two().trailing_zeros()
}

/// The visible one of all inputs (at least one).
pub fn decide(inputs: &[Visible]) -> Visible {
    let nearest = inputs.iter().copied().reduce(visibility_node);
    nearest.expect("a decider has at least one input")
}
