//! How far the direction of a computed normal can be from the true gradient.
//!
//! For components of n = 16 bits: in units of the last bit of the 24-bit linear part the true component is `N = g -+ K
//! r / 2^(shift + 6)`, with real g, K and root r; for other n the 24 is n + 8 and the 6 is n - 10. The unit computes
//! `((g' -+ floor(K' rs / 64)) >> 8)` with `rs = floor(r' / 2^shift)`. With `|g' - g| <= eg`, `|K' - K| <= 1/2` and
//! `|r' - r| <= er` (the root error of the depth bound):
//!
//! * `|rs - r / 2^shift| <= t` with `t = 1 - 2^-shift + er / 2^shift`, which costs `|K'| t / 64`;
//! * rounding K costs `r / 2^shift / 128 <= (rs + t) / 128`;
//! * the floor of the product takes at most 1, the last 8 bits at most 255, both downwards: together 256.
//!
//! The sum bounds each component; E is the length of the three bounds. A vector of length L whose error is E < L points
//! at most `asin(E / L)` away from the true one. Where E >= L the direction is not determined.

use super::depth::root_error;
use imogene_algebra::vector::length;
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END};
use imogene_golden::unit::normal::NormalWords;
use imogene_prepare::{PreparedQuadric, RoundingBounds};

/// Last bits of the linear part that the result drops.
const DROPPED: f64 = 256.0;
/// Relative allowance for the arithmetic in `f64`.
const FLOAT_MARGIN: f64 = 32.0 * f64::EPSILON;

/// Greatest angle, in degrees, between the golden normal of face `number` and the true gradient, at a pixel of the
/// object's screen box where the f2 processor hands on `f2`; 180 where the words do not determine the direction.
pub fn normal_bound(object: &PreparedQuadric, number: u8, f2: i64, normal: [i16; 3]) -> f64 {
    match number {
        FACE_NEAR_END => 0.0,
        FACE_NEAR | FACE_FAR => {
            let words = &object.words.normal;
            degrees(quadric_sine(words, &object.bounds, f2, normal))
        }
        _ => constant_normal_bound(normal),
    }
}

/// The same for a plane, whose normal is rounded to the nearest word.
pub fn constant_normal_bound(normal: [i16; 3]) -> f64 {
    degrees(0.75f64.sqrt() / length(normal.map(f64::from)))
}

/// Greatest sine of the angle between golden normal and true gradient; not below 1 if nothing is determined.
pub fn quadric_sine(
    words: &NormalWords,
    bounds: &RoundingBounds,
    f2: i64,
    normal: [i16; 3],
) -> f64 {
    let unit = f64::from(1u32 << words.shift);
    let root = bounds.root_of(f2);
    let shifted = (root >> words.shift) as f64;
    let truncated = 1.0 - 1.0 / unit + root_error(f2, bounds) / unit;
    let product = f64::from(1u32 << bounds.product_fraction);
    let component = |k: i16| {
        bounds.normal
            + f64::from(k).abs() * truncated / product
            + (shifted + truncated) / (2.0 * product)
            + DROPPED
    };
    let error = length(words.k.map(component));
    error / (length(normal.map(f64::from)) * DROPPED) * (1.0 + FLOAT_MARGIN)
}

fn degrees(sine: f64) -> f64 {
    if sine < 1.0 {
        sine.asin().to_degrees()
    } else {
        180.0
    }
}
