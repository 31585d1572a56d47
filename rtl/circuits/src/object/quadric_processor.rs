//! Quadric object processor, second generation.

use super::{
    Cut, Interval, Network, PlaneAt, Visible, Words, cut_plane, depth_interval, object_processor,
    roots, two_volume_merge, visible,
};
use crate::raster::Scan;
use crate::rows::numbered;
use imogene_contract::words::{FIRST_PLANE, PATCH};
use imogene_hdl::{Bits, Bundle, Value, net};

/// What an object processor is built for.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
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
/// `ceil(rows / rows_per_stage) + 2 planes + 11`, two less without half B. The words stay unchanged until that many
/// clocks after the last flags of a zone. Section 2.4.2.
pub fn quadric_processor(at: &str, scan: Scan, words: Words, shape: Shape) -> Visible {
    object_processor(KIND, at, (scan, words), |scan, words| {
        let (quadric, network) = (words.quadric, shape.root);
        let f = (quadric.f1, quadric.f2);
        let (roots, root, late) = roots(scan, quadric.screen_box, f, network);
        let start = depth_interval("interval", roots, words.object_class);
        net! { let surface = words.object_class.is(PATCH); }
        // A plane is there with the interval it cuts.
        let mut flags = late.delayed(1);
        let planes = numbered("planes", &words.planes).zip(FIRST_PLANE..);
        let planes_at = planes.map(|((at, plane), number)| {
            flags = flags.delayed(2);
            let PlaneAt { kind, zp } = plane.half_space.at(&at, flags, network.depth);
            Cut {
                kind,
                surface,
                number: Bits::new(number, 4),
                zp,
            }
        });
        let cuts: Vec<Cut> = planes_at.collect();
        let cut = |row: &str, interval: Interval| {
            let cuts = numbered(row, &cuts);
            cuts.fold(interval, |left, (at, cut)| cut_plane(&at, *cut, left))
        };
        let a = cut("cut_a", start.a);
        let seen = match shape.two_volumes {
            true => two_volume_merge("merge", a, cut("cut_b", start.b)),
            false => a,
        };
        let merge = 2 * u32::from(shape.two_volumes);
        let clocks = 2 * words.planes.len() as u32 + 3 + merge;
        let root = root.delayed_as("root_late", clocks);
        let words = (quadric, words.normals());
        visible(flags.delayed(4 + merge), seen.seen(), root, words)
    })
}
