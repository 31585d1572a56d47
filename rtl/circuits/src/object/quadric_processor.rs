//! Quadric object processor, second generation.

use super::{
    Cut, Face, Interval, Network, Normal, NormalWords, Roots, Words, absent, cut_plane,
    depth_interval, normal_unit, plane_depth, quadric_pe, two_volume_merge,
};
use crate::raster::{Flags, Pixel};
use imogene_contract::words::{FIRST_PLANE, PATCH};
use imogene_hdl::{Bits, Bundle, Value, bundle, bundles, module, net};

bundle! {
    /// The visible front of an object.
    Front(depth) {
        out_valid: Bits(1), "this clock carries a result";
        zf: Int(depth), "front depth, the far end where the object is absent";
        zb: Int(depth), "back depth";
        number: Bits(4), "face at the front";
    }
}

bundles! {
    /// A pixel of an object.
    Visible {
        front: Front as "", "depth and face";
        normal: Normal as "", "normal of the face";
    }
}

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
    module(
        "quadric_processor",
        at,
        (flags, pixel, words),
        |(flags, pixel, words)| {
            let Shape {
                depth,
                root,
                two_volumes,
            } = shape;
            let sums = root.latency() + 2;
            let planes = words.planes.len() as u32;
            let halves = u32::from(two_volumes);
            let not_before = |value: Bits, first: Bits| !value.less(first);
            let place = words.place;
            net! {
                let in_box = not_before(pixel.x, place.box_x0)
                    & not_before(place.box_x1, pixel.x)
                    & not_before(pixel.y, place.box_y0)
                    & not_before(place.box_y1, pixel.y);
                let surface = place.object_class.is(PATCH);
            }
            let (depths, late) =
                quadric_pe("quadric", flags, (words.f1, words.f2), depth + 2, root);
            let roots = Roots {
                near_sum: depths.near_sum,
                far_sum: depths.far_sum,
                is_inside: depths.is_inside,
                in_box: in_box.delayed_as("in_box_late", sums),
                object_class: place.object_class,
            };
            let start = depth_interval("interval", roots, depth);
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
            let late = flags.delayed(3 + halves);
            let face = Face {
                number: seen.nf,
                absent: seen.zf.equals(absent(depth)),
                root: depths.root.delayed_as("root_late", planes + 1 + halves),
                shift: place.shift,
            };
            // The normal takes three clocks.
            let front = Front {
                out_valid: late.valid,
                zf: seen.zf,
                zb: seen.zb,
                number: seen.nf,
            };
            Visible {
                front: front.delayed(3),
                normal: normal_unit("normal", late, face, NormalWords::of(&words)),
            }
        },
    )
}
