//! Round surfaces by paraboloids, and the words that carry a second-degree depth (source: Chaillou, IV.2.4).
//!
//! `sqrt(1 - r^2)` is replaced by `a - b r^2` with a = 21 pi / 64 and b = 15 pi / 64, the least squares fit of the
//! profile on 0 <= r <= 1.

use crate::format::Format;
use crate::unit::depth_interval::{Class, Interval, halves};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use imogene_algebra::rational::round_half_up;
use imogene_algebra::whole::primitive;
pub use imogene_contract::words::NORMAL_LENGTH;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

/// The two factors a and b, pi to 30 digits.
pub fn bulge() -> (BigRational, BigRational) {
    let digits = BigInt::from(314_159_265_358_979_323_846_264_338_328_i128);
    let pi = BigRational::new(digits, BigInt::from(10).pow(29));
    let of = |n: i64| &pi * BigRational::new(BigInt::from(n), BigInt::from(64));
    (of(21), of(15))
}

/// Bits of a second-degree depth below the depth word: an F-bit pe2 leaves S bits above them.
pub const fn depth_guard(format: &Format) -> u32 {
    format.quadratic - format.sum
}

/// Bits of a second-degree normal component below its 16.
pub const fn normal_guard(format: &Format) -> u32 {
    format.quadratic - format.normal
}

/// Bits of a first-degree depth below the depth word: a P-bit pe1 leaves S bits above them.
pub const fn plane_guard(format: &Format) -> u32 {
    format.plane - format.sum
}

/// An expression of degree two with rational coefficients, in the order of [`Quadratic`].
pub type Exact = [BigRational; 6];

/// The word of a coefficient; the preparation proves that words fit their width.
fn word(value: &BigRational) -> i128 {
    let rounded = round_half_up(value).to_i128();
    rounded.expect("a coefficient word has fewer than 128 bits")
}

/// `exact` in units of `2^-guard`, rounded, half a unit of the result added: the shift at the end then rounds to
/// nearest.
pub fn second_degree(exact: &Exact, guard: u32) -> Quadratic {
    let one = BigRational::from_integer(BigInt::one() << guard);
    let [a, b, c, d, e, f] = exact.each_ref().map(|v| word(&(v * &one)));
    Quadratic::new([a, b, c, d, e, f + half(guard)])
}

/// The same for `a x + b y + c`.
pub fn first_degree(exact: &[BigRational; 3], guard: u32) -> Linear {
    let one = BigRational::from_integer(BigInt::one() << guard);
    let [a, b, c] = exact.each_ref().map(|v| word(&(v * &one)));
    Linear::new(a, b, c + half(guard))
}

const fn half(guard: u32) -> i128 {
    if guard == 0 { 0 } else { 1 << (guard - 1) }
}

/// `exact` times the positive factor that makes all its coefficients integers without a common divisor: its sign is
/// exact.
pub fn contour<const N: usize>(exact: &[BigRational; N]) -> [i128; N] {
    primitive(exact.clone()).map(|value| word(&value))
}

/// The interval of a surface with one depth, front and back at once; absent beyond the ends of the depth word.
pub fn one_face(z: i64, number: u8, there: bool, format: &Format) -> Interval {
    let (mut face, _) = halves(Class::Patch, z, z, !there, format);
    if face.is_present(format) {
        (face.nf, face.nb) = (number, number);
    }
    face
}
