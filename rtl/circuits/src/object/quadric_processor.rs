//! Quadric object processor, second generation.

use super::{
    Cut, Interval, Network, NormalWords, Visible, Words, cut_plane, depth_interval,
    object_processor, plane_depth, roots, two_volume_merge, visible,
};
use crate::raster::{Flags, Pixel};
use imogene_contract::words::{FIRST_PLANE, PATCH};
use imogene_hdl::{Bits, Bundle, Value, net};

/// What an object processor is built for.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Bits of a depth word.
    pub depth: u32,
    /// The root.
    pub root: Network,
    /// It has half B, which objects of the class front need.
    pub two_volumes: bool,
}

/// Name of the module, and what numbers of faces it gives.
const KIND: (&str, &str) = (
    "quadric_processor",
    "visible face: 0 near root, 1 far root, 2 + i plane i, 15 near end",
);

/// For every pixel the visible front of one quadric object cut by planes: depth, face and normal.
///
/// A quadric PE, the intervals of both halves, a chain of cuts for each, the nearer half, and its normal. Latency
/// `ceil(rows / rows_per_stage) + planes + 7`, one less without half B. The words stay unchanged until that many
/// clocks after the last flags of a zone. Section 2.4.2.
pub fn quadric_processor(
    at: &str,
    flags: Flags,
    pixel: Pixel,
    words: Words,
    shape: Shape,
) -> Visible {
    let inputs = (flags, pixel, words);
    object_processor(KIND, at, inputs, |flags, pixel, words| {
        let Shape {
            depth,
            root: network,
            two_volumes,
        } = shape;
        let quadric = words.quadric;
        let halves = u32::from(two_volumes);
        let f = (quadric.f1, quadric.f2);
        let (roots, root, late) = roots(flags, pixel, quadric.screen_box, f, network);
        let start = depth_interval("interval", roots, words.object_class, depth);
        net! { let surface = words.object_class.is(PATCH); }
        let mut flags = late;
        let planes_at = words.planes.iter().enumerate().map(|(index, plane)| {
            flags = flags.delayed(1);
            Cut {
                kind: plane.kind,
                surface,
                number: Bits::new(FIRST_PLANE + index as u64, 4),
                zp: plane_depth(&format!("planes_{index}"), flags, plane.linear, depth),
            }
        });
        let cuts: Vec<Cut> = planes_at.collect();
        let cut = |half: &str, interval: Interval| {
            let cuts = cuts.iter().enumerate();
            cuts.fold(interval, |interval, (index, cut)| {
                cut_plane(&format!("cut_{half}_{index}"), *cut, interval)
            })
        };
        let a = cut("a", start.a);
        let seen: Interval = match two_volumes {
            true => two_volume_merge("merge", a, cut("b", start.b)),
            false => a,
        };
        let clocks = words.planes.len() as u32 + 1 + halves;
        let root = (root.delayed_as("root_late", clocks), quadric.shift);
        let normals = NormalWords::of(&words);
        visible(flags.delayed(3 + halves), seen.seen(), root, normals)
    })
}
