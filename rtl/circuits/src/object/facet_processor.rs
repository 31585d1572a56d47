//! Facet processors.

use super::clamped::Clamped;
use super::{Normal, ScreenBox, Seen, Visible, absent, object_processor};
use crate::raster::{Flags, Linear, Pixel, Quadratic, pe1, pe2};
use imogene_contract::words::{FIRST_PLANE, NEAR_ROOT, NORMAL};
use imogene_hdl::{Bits, Bundle, Int, Value, net};

/// Words of a facet: polynomials of first or second degree, from which the elementary processors begin.
#[derive(Clone, Debug)]
pub struct Facet<P> {
    /// Screen box.
    pub screen_box: ScreenBox,
    /// Sides, not negative inside.
    pub sides: Vec<P>,
    /// Depth; the high bits count.
    pub depth: P,
    /// Components of the normal; the high bits count.
    pub normal: [P; 3],
}

impl<P> Facet<P> {
    /// Words from outside of the design: so many sides, and the widths of sides and depth and of the normal.
    pub fn input(sides: u32, words: fn(u32) -> P, width: u32, normal: u32) -> Facet<P> {
        Facet {
            screen_box: ScreenBox::input(),
            sides: (0..sides).map(|_| words(width)).collect(),
            depth: words(width),
            normal: [normal; 3].map(words),
        }
    }
}

/// For every pixel depth and normal of a flat facet of three or four sides, convex on the screen, its normals
/// interpolated (Phong). The depth is in units of `2^-10` depth words, the normal in units of `2^-8`.
///
/// Absent outside a side and beyond the ends of the depth word. Latency 2. Chaillou 1991, IV.2.2; section 4.1.2.
pub fn facet_processor(
    at: &str,
    flags: Flags,
    pixel: Pixel,
    facet: Facet<Linear>,
    depth: u32,
) -> Visible {
    let kind = Kind {
        name: "facet_processor",
        number: FIRST_PLANE,
        faces: "2; 0 where the facet is absent",
        depth: "depth in units of 2^-10 depth words",
        normal: [
            "normal x in units of 2^-8",
            "normal y in units of 2^-8",
            "normal z in units of 2^-8",
        ],
    };
    processor(kind, at, (flags, pixel), facet, depth, pe1)
}

/// For every pixel depth and normal of a facet with sides, depth and normal of second degree. The depth is in units of
/// `2^-(W-2)` depth words, the normal in units of `2^-(2 W - 16)`.
///
/// Absent outside a side and beyond the ends of the depth word. Latency 2. Chaillou 1991, IV.2.6.1.
pub fn curved_facet_processor(
    at: &str,
    flags: Flags,
    pixel: Pixel,
    facet: Facet<Quadratic>,
    depth: u32,
) -> Visible {
    let kind = Kind {
        name: "curved_facet_processor",
        number: NEAR_ROOT,
        faces: "0",
        depth: "depth in units of 2^-(W-2) depth words",
        normal: [
            "normal x in units of 2^-(2W-16)",
            "normal y in units of 2^-(2W-16)",
            "normal z in units of 2^-(2W-16)",
        ],
    };
    processor(kind, at, (flags, pixel), facet, depth, pe2)
}

/// A kind of facets: the number of their face, and what their ports carry.
struct Kind {
    name: &'static str,
    number: u64,
    faces: &'static str,
    depth: &'static str,
    normal: [&'static str; 3],
}

/// A facet of polynomials that a processor adds up.
fn processor<P: Bundle + Copy>(
    kind: Kind,
    at: &str,
    (flags, pixel): (Flags, Pixel),
    facet: Facet<P>,
    depth: u32,
    pe: fn(&str, Flags, P) -> Int,
) -> Visible {
    let [nx, ny, nz] = facet.normal;
    let sides = ("side", facet.sides, "not negative inside side #");
    let shape = (sides, ("depth", facet.depth, kind.depth));
    let [x, y, z] = kind.normal;
    let normal = (("nx", nx, x), ("ny", ny, y), ("nz", nz, z));
    let inputs = (flags, pixel, (facet.screen_box, shape, normal));
    let number = kind.number;
    object_processor(
        (kind.name, kind.faces),
        at,
        inputs,
        |flags, pixel, (screen_box, shape, normal)| {
            let ((_, sides, _), (_, z, _)) = shape;
            let ((_, nx, _), (_, ny, _), (_, nz, _)) = normal;
            let high = |value: Int, width: u32| {
                let whole = value.width();
                value.slice(whole - 1, whole - width).int()
            };
            let in_box = screen_box.contains(pixel).reg().named("in_box_late");
            let sides = sides.iter().enumerate();
            let is_there = sides.fold(in_box, |all, (index, side)| {
                all & !pe(&format!("sides_{index}"), flags, *side).is_negative()
            });
            let z = high(pe("depth", flags, z), depth + 2);
            net! {
                let is_present = is_there & Clamped::of("depth", z, number, depth).is_visible();
                let kept_depth = is_present.select(z.low(depth), absent(depth)).reg();
                let kept_number = is_present.select(Bits::new(number, 4), Bits::new(0, 4)).reg();
            }
            let seen = Seen {
                zf: kept_depth,
                zb: kept_depth,
                number: kept_number,
            };
            let component = |axis: &str, words: P| {
                let value = pe(&format!("normal_{axis}"), flags, words);
                high(value, NORMAL as u32)
            };
            let normal = Normal {
                nx: component("x", nx),
                ny: component("y", ny),
                nz: component("z", nz),
            };
            let no_normal = Normal::all(Int::new(0, NORMAL as u32));
            Visible {
                front: seen.front(flags.valid.delayed_as("valid_late", 2)),
                number: seen.number,
                normal: is_present.select(normal, no_normal).registered(),
            }
        },
    )
}
