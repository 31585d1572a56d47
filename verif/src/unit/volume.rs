//! The shadow and light volumes.

use super::description::Description;
use super::likely::{Likely, held, planes_any_kind, words};
use super::words::Ports;
use super::zone::{WORDS, zone};
use crate::stimulus::depth;
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::object::screen_box::ScreenBox;
use imogene_golden::object::volume::{
    FROM_DEPTH, VolumeKind, VolumePlane, VolumeQuadric, VolumeWords, polyhedral_latency,
    quadric_latency,
};
use proptest::prelude::*;

/// The visible depth comes in before the words.
const DEPTH: usize = WORDS;

/// Whether the visible point is inside.
fn volume(format: Format, planes: usize, clocks: [u32; 2], has_quadric: bool) -> Description {
    // Shadow or light, and whose: the flags behind the processor are told, not the processor.
    let words = VolumeWords {
        kind: VolumeKind::Shadow,
        source: 0,
        screen_box: ScreenBox::EMPTY,
        margin: 0,
        quadric: has_quadric.then_some(VolumeQuadric::EVERYWHERE),
        planes: vec![VolumePlane::default(); planes],
    };
    let read = |ports: &mut Ports, words: &mut VolumeWords| {
        ports.number(&mut 0, |depth| depth);
        ports.volume(words);
    };
    let pixel = |words: &VolumeWords, [x, y]: [i64; 2], format: &Format, i: &[i64]| {
        [words.holds(x, y, i[DEPTH], format).into()]
    };
    zone(points, format, clocks, words, read, pixel)
}

pub(super) fn quadric_volume(format: Format, planes: usize, rows_per_stage: usize) -> Description {
    let latency = quadric_latency(&format, rows_per_stage as u32);
    volume(format, planes, [latency - FROM_DEPTH, latency], true)
}

pub(super) fn polyhedral_volume(format: Format, planes: usize) -> Description {
    volume(format, planes, [0, polyhedral_latency()], false)
}

/// Words held over a zone, and a visible depth that changes every clock: at the parts of the volume, at the ends, or
/// anything.
fn points(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let width = subject.inputs[DEPTH].width;
    let plan = [
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("plane_", Likely::Depth(0)),
        ("depth_shift", Likely::UpTo(8)),
        ("margin", Likely::UpTo((1 << (width - 1)) - 1)),
    ];
    let words = planes_any_kind(words(&subject.inputs, width, &plan), subject);
    let near = 12_000i64.min((1 << (width - 1)) - 1);
    let point = prop_oneof![3 => -near..near, 2 => -12i64..12, 1 => depth(width)];
    let surface = Surface::of(subject);
    (
        held(&subject.inputs, words, clocks),
        proptest::collection::vec(point, clocks),
        proptest::option::of((any::<bool>(), any::<i64>())),
    )
        .prop_map(move |(mut list, points, flat)| {
            for (inputs, point) in list.iter_mut().zip(points) {
                // The golden model takes no more than half the depth word.
                inputs[DEPTH + 1] &= (1 << (width - 1)) - 1;
                inputs[DEPTH] = point;
                if let (Some((is_far, at)), Some(surface)) = (flat, &surface) {
                    surface.flatten(inputs, is_far, at, width);
                }
            }
            list
        })
        .boxed()
}

/// Where the words of a quadric stand among the inputs.
struct Surface {
    /// The first word of the linear part, and the last one of the quadratic part, which follows it.
    linear: usize,
    constant: usize,
    shift: usize,
}

impl Surface {
    /// Nothing if the volume has none.
    fn of(subject: &Subject) -> Option<Surface> {
        let ports = &subject.inputs;
        let place = |name| ports.iter().position(|signal| signal.name == name);
        Some(Surface {
            linear: place("f1_a")?,
            constant: place("f2_f")?,
            shift: place("depth_shift")?,
        })
    }

    /// Makes both depths of the quadric constant, of any root, and puts one of them near the visible point: the lowest
    /// digit of the root decides.
    fn flatten(&self, inputs: &mut Inputs, is_far: bool, at: i64, width: u32) {
        let drawn = inputs[self.constant];
        let drawn = if drawn < 0 { !drawn } else { drawn };
        let root = drawn.isqrt();
        // Any, or the least and the greatest of a root.
        let radicand = match at & 3 {
            0 => root * root,
            // Of the longest words the greatest one has no place in a word.
            1 => (root * root).saturating_add(2 * root),
            _ => drawn,
        };
        let unit = inputs[self.shift];
        let end = 1i64 << (width - 1);
        let depth = ((at >> 2).rem_euclid(2 * end) - end) >> unit;
        inputs[self.linear..=self.constant].fill(0);
        inputs[self.constant] = radicand;
        inputs[self.linear + 2] = if is_far { depth - root } else { depth + root };
        let point = (depth << unit) + inputs[DEPTH].rem_euclid(5 << unit) - (2 << unit);
        inputs[DEPTH] = point.clamp(-end, end - 1);
    }
}
