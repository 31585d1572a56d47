//! Facet processors.

use super::clamped::Clamped;
use super::{NORMAL, Normal, ScreenBox, Seen, Visible, absent, object_processor};
use crate::raster::{Flags, Linear, Quadratic, Scan, pe1, pe2};
use crate::rows::numbered;
use imogene_contract::words::{FIRST_PLANE, NEAR_ROOT};
use imogene_hdl::{Bits, Bundle, Int, Plain, Value, net};

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
/// Absent outside a side and beyond the ends of the depth word. Latency 3. Chaillou 1991, IV.2.2; section 4.1.2.
pub fn facet_processor(at: &str, scan: Scan, facet: Facet<Linear>, depth: u32) -> Visible {
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
    processor(kind, at, scan, facet, depth, pe1)
}

/// For every pixel depth and normal of a facet with sides, depth and normal of second degree. The depth is in units of
/// `2^-(W-2)` depth words, the normal in units of `2^-(2 W - 16)`.
///
/// Absent outside a side and beyond the ends of the depth word. Latency 3. Chaillou 1991, IV.2.6.1.
pub fn curved_facet_processor(
    at: &str,
    scan: Scan,
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
    processor(kind, at, scan, facet, depth, pe2)
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
fn processor<P: Plain + Copy>(
    kind: Kind,
    at: &str,
    scan: Scan,
    facet: Facet<P>,
    depth: u32,
    pe: fn(&str, Flags, P) -> Int,
) -> Visible {
    let ([nx, ny, nz], [x, y, z]) = (facet.normal, kind.normal);
    let normal = (("nx", nx, x), ("ny", ny, y), ("nz", nz, z));
    let sides = ("side", facet.sides, "not negative inside side #");
    let z = ("depth", facet.depth, kind.depth);
    let (number, kind) = (kind.number, (kind.name, kind.faces));
    let inputs = (scan, (facet.screen_box, sides, z, normal));
    object_processor(kind, at, inputs, |scan, (screen_box, sides, z, normal)| {
        let flags = scan.flags;
        let in_box = screen_box.contains(scan.pixel).reg().named("in_box_late");
        let is_there = numbered("sides", sides).fold(in_box, |all, (at, side)| {
            all & !pe(&at, flags, side).is_negative()
        });
        let z = pe("depth", flags, z).high(depth + 2);
        net! {
            let is_present = (is_there & Clamped::of("depth", z, number).is_visible()).reg();
            let late_depth = z.low(depth).reg();
            let kept_depth = is_present.select(late_depth, absent(depth)).reg();
            let kept_number = is_present.select(Bits::new(number, 4), Bits::new(0, 4)).reg();
        }
        let seen = Seen::face(kept_depth, kept_number);
        // A clock after sides and depth, when it is known whether they are seen: fewer loads on one register of flags.
        let late_flags = flags.delayed(1);
        let component = |at: &str, words: P| pe(at, late_flags, words).high(NORMAL);
        let (nx, ny, nz) = normal;
        let normal = Normal::of([
            component("normal_x", nx),
            component("normal_y", ny),
            component("normal_z", nz),
        ]);
        let out_valid = late_flags.valid.delayed_as("valid_late", 2);
        let no_normal = Normal::of([Int::new(0, NORMAL); 3]);
        seen.with(out_valid, is_present.select(normal, no_normal).registered())
    })
}
