//! Bits that the accumulators of one object need on this very screen box: the exact least and greatest value of the
//! words as they are loaded.
//!
//! Only the values that the rest of the machine sees must fit. Increments, and the sums on the way from pixel to pixel,
//! may wrap: a register that wraps modulo its width still holds the right value modulo its width, so a value that fits
//! comes out right whatever happened before. Their bits are told all the same, of a scan of the whole picture, because
//! a processor that saturates or stops at overflow would need them.

use imogene_golden::format::Format;
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::object::range::{Range, bits};
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use imogene_prepare::PreparedQuadric;
use rayon::prelude::*;
use serde::Serialize;

/// Two's complement bits that hold each value at every pixel of the object's screen box, guard bits not counted.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Accumulators {
    /// f1.
    pub f1: u32,
    /// f2.
    pub f2: u32,
    /// f1 - r where f2 is not negative; nothing where no depth is a root.
    pub f1_minus_r: Option<u32>,
    /// f1 + r likewise.
    pub f1_plus_r: Option<u32>,
    /// Root bits K: all roots are below `2^(K - 1/2)`.
    pub root: Option<u32>,
    /// Each plane, before saturation.
    pub planes: Vec<u32>,
    /// Linear part of each normal component.
    pub normal_linear: Option<[u32; 3]>,
    /// The same with `K_k r` of either face.
    pub normal_sum: Option<[u32; 3]>,
    /// Bits that would hold what the processors add, without ever wrapping; no word needs them.
    pub increments: Increments,
}

/// Bits, guard bits counted, of the registers of the two processors over a scan of the whole picture. They may wrap.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Increments {
    /// Of f1.
    pub f1: LinearIncrements,
    /// Of f2.
    pub f2: QuadraticIncrements,
}

/// Registers of pe1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct LinearIncrements {
    /// Increment from pixel to pixel.
    pub a: u32,
    /// Increment from line to line.
    pub b: u32,
    /// Value at the first pixel of a line.
    pub line_value: u32,
}

/// Registers of pe2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct QuadraticIncrements {
    /// Second difference along a line.
    pub a2: u32,
    /// Second difference from line to line.
    pub b2: u32,
    /// Mixed difference.
    pub c: u32,
    /// Pixel increment J.
    pub j: u32,
    /// First pixel increment P of a line.
    pub p: u32,
    /// Line increment I.
    pub i: u32,
    /// Value Q at the first pixel of a line.
    pub line_value: u32,
}

/// Bits of the accumulators of an object in a picture of this size; `None` if its screen box is empty.
pub fn accumulators(
    object: &PreparedQuadric,
    (width, height): (u32, u32),
    format: &Format,
) -> Option<Accumulators> {
    let words = &object.words;
    let window = &words.screen_box;
    if window.is_empty() {
        return None;
    }
    let screen = ScreenBox::of_screen(width, height);
    let f1 = Range::of_linear(&words.f1, window).dropped(format.guard_linear);
    let f2 = Range::of_quadratic(&words.f2, window).dropped(format.guard_quadratic);
    // The depth of a prism is no root, and it has no normal.
    let has_depth = words.class != Class::Prism;
    let depths = (has_depth && f2.high >= 0).then(|| depths(object, format));
    let linear = || words.normal.g.map(|g| Range::of_linear(&g, window).bits());
    Some(Accumulators {
        f1: f1.bits(),
        f2: f2.bits(),
        f1_minus_r: depths.map(|d| d[0].bits()),
        f1_plus_r: depths.map(|d| d[1].bits()),
        root: depths.map(|_| root_bits(f2.high)),
        planes: plane_bits(words),
        normal_linear: has_depth.then(linear),
        normal_sum: depths.map(|[_, _, normal @ ..]| normal.map(|range| range.bits())),
        increments: Increments {
            f1: linear_increments(&words.f1, &screen),
            f2: quadratic_increments(&words.f2, &screen),
        },
    })
}

/// Bits of each plane on the screen box, before saturation.
pub(super) fn plane_bits(words: &QuadricWords) -> Vec<u32> {
    let window = &words.screen_box;
    let planes = words.planes.iter().filter(|_| !window.is_empty());
    let ranges = planes.map(|p| Range::of_linear(&p.depth, window));
    ranges.map(|range| range.bits()).collect()
}

/// Root bits of the greatest f2: the least K with `f2 < 2^(2 K - 1)`.
pub fn root_bits(greatest: i128) -> u32 {
    bits(greatest).div_ceil(2)
}

/// f1 - r, f1 + r, and each component of the normal on either face, at the pixels of the box that have a root.
fn depths(object: &PreparedQuadric, format: &Format) -> [Range; 5] {
    let words = &object.words;
    let window = words.screen_box;
    let with_pixel = |found: [Range; 5], (x, y): (i64, i64)| {
        let f2 = words.f2_at(x, y, format);
        if f2 < 0 {
            return found;
        }
        let f1 = i128::from(words.f1_at(x, y, format));
        let root = format.root_of(f2);
        let shifted = (root >> words.normal.shift) & i64::from(format.greatest_normal());
        let [near, far, normal @ ..] = found;
        let [u, v, w] = std::array::from_fn(|k| {
            // As loaded, not as the register holds it: what is asked is how long that would have to be.
            let linear = words.normal.g[k].from_zone(x, y).c;
            let product = i64::from(words.normal.k[k]) * shifted;
            let sum = |product: i64| linear + i128::from(product >> format.product_fraction());
            normal[k].with(sum(-product)).with(sum(product))
        });
        let root = i128::from(root);
        [near.with(f1 - root), far.with(f1 + root), u, v, w]
    };
    let line = |y| {
        let pixels = (window.x0..=window.x1).map(|x| (x, y));
        pixels.fold([Range::NONE; 5], with_pixel)
    };
    let merged =
        |one: [Range; 5], other: [Range; 5]| std::array::from_fn(|k| one[k].merged(other[k]));
    let lines = (window.y0..window.y1 + 1).into_par_iter().map(line);
    lines.reduce(|| [Range::NONE; 5], merged)
}

/// Bits of the registers of pe1 over a scan of a screen.
pub fn linear_increments(q: &Linear, screen: &ScreenBox) -> LinearIncrements {
    LinearIncrements {
        a: bits(q.a),
        b: bits(q.b),
        line_value: Range::of_parabola([0, q.b, q.c], screen.y0, screen.y1).bits(),
    }
}

/// Bits of the registers of pe2 over a scan of a screen.
pub fn quadratic_increments(q: &Quadratic, screen: &ScreenBox) -> QuadraticIncrements {
    let lines = |factors| Range::of_parabola(factors, screen.y0, screen.y1).bits();
    let increment = Linear::new(2 * q.a, q.c, q.d + q.a);
    QuadraticIncrements {
        a2: bits(2 * q.a),
        b2: bits(2 * q.b),
        c: bits(q.c),
        j: Range::of_linear(&increment, screen).bits(),
        p: lines([0, q.c, q.d + q.a]),
        i: lines([0, 2 * q.b, q.e + q.b]),
        line_value: lines([q.b, q.e, q.f]),
    }
}
