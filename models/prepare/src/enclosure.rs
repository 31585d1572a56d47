//! A closed quadric around a cut one: proven, without a search.
//!
//! What two planes keep has `p <= 0` and `s <= 0`, so that their product is not negative there, and with `q <= 0` also
//! `q - l p s <= 0` for every factor `l >= 0`. Between two planes across its axis a cylinder, a cone or a paraboloid
//! lies so in an ellipsoid through both of its rims, the box of which [`Extent`] knows exactly.
//!
//! The coefficients are those of floating point, each off by a unit in its last place: within [`REACH`] the quadric is
//! then off by little, and its constant is lowered by more than that. The pair of planes and the factor are chosen in
//! floating point, where a bad choice only makes the box larger.

use super::cell::Cell;
use super::extent::Extent;
use imogene_algebra::matrix::SYMMETRIC;
use num_bigint::BigInt;
use num_traits::FromPrimitive;
use std::array::from_fn;
use std::ops::{Add, Mul, Range};

/// Greatest coordinates for which a cell holds what it says.
pub(super) const REACH: [f64; 3] = [16384.0, 16384.0, 1048576.0];
/// The factors that are tried, as powers of two.
const POWERS: Range<i32> = -24..25;
/// Error of the quadric and of the product of two planes, as a part of the sum of the magnitudes of their terms: the
/// rounding of coefficients is an eighth of it.
const ERROR: f64 = 1.0 / (1u64 << 49) as f64;
/// Bits behind the point of the coefficients of planes; those of quadrics have twice as many.
const BITS: i32 = 90;

/// A cell around the part within [`REACH`] of the inside of a quadric that all planes keep, if it is closed or two of
/// the planes close it. The greatest coefficient of each is about 1.
pub(super) fn around(quadric: &[f64; 10], planes: &[[f64; 4]]) -> Option<Cell> {
    let pairs = (0..planes.len()).flat_map(|j| (0..j).map(move |i| [i, j]));
    let cut = pairs.flat_map(|pair| POWERS.map(move |power| (Some(pair), power)));
    let uncut = planes.is_empty().then_some((None, 0));
    let choices = uncut.into_iter().chain(cut).filter_map(|(pair, power)| {
        let pair = pair.map(|pair| pair.map(|k| &planes[k]));
        Some((size(&closed_about(quadric, pair, power))?, pair, power))
    });
    let (_, pair, power) = choices.min_by(|(a, ..), (b, ..)| a.total_cmp(b))?;
    Extent::of_whole(closed(quadric, pair, power)?)?.cell()
}

/// `q - 2^power p s` in floating point.
fn closed_about(quadric: &[f64; 10], pair: Option<[&[f64; 4]; 2]>, power: i32) -> [f64; 10] {
    let factor = 0.5 * f64::from(power).exp2();
    let product = pair.map_or([0.0; 10], doubled_product);
    from_fn(|k| quadric[k] - factor * product[k])
}

/// The same in fixed point, with the constant lowered by more than what the coefficients are off by.
fn closed(quadric: &[f64; 10], pair: Option<[&[f64; 4]; 2]>, power: i32) -> Option<[BigInt; 10]> {
    let reach = |k: usize| REACH.get(k).copied().unwrap_or(1.0);
    let plane_size = |plane: &[f64; 4]| -> f64 { (0..4).map(|k| plane[k].abs() * reach(k)).sum() };
    let terms = quadric.iter().zip(SYMMETRIC);
    let own: f64 = terms
        .map(|(v, [i, j])| 2.0 * v.abs() * reach(i) * reach(j))
        .sum();
    let product_size = pair.map_or(0.0, |pair| pair.map(plane_size).iter().product());
    let spare = ERROR * (own + f64::from(power).exp2() * product_size);
    // Twice as many bits, so that the doubled product needs no half; bits below its last are not lost, either.
    let shift = power - POWERS.start;
    let fixed = |value: f64, bits: i32| BigInt::from_f64((value * f64::from(bits).exp2()).trunc());
    let whole = quadric.iter().map(|v| fixed(*v, 2 * BITS));
    let mut whole: Vec<BigInt> = whole.collect::<Option<_>>()?;
    whole[9] -= fixed(spare, 2 * BITS)?;
    if let Some(pair) = pair {
        let [p, s] = pair.map(|plane| plane.map(|v| fixed(v, BITS).unwrap_or_default()));
        let product = doubled_product([&p, &s]);
        for (own, product) in whole.iter_mut().zip(product) {
            *own = (&*own << (1 - POWERS.start)) - (product << shift);
        }
    }
    whole.try_into().ok()
}

/// Twice the ten coefficients of the product of two planes, those of mixed terms halved as in a quadric.
fn doubled_product<T>([p, s]: [&[T; 4]; 2]) -> [T; 10]
where
    for<'a> &'a T: Mul<&'a T, Output = T>,
    T: Add<Output = T>,
{
    SYMMETRIC.map(|[i, j]| &p[i] * &s[j] + &p[j] * &s[i])
}

/// The sum of the squares of the sides of an ellipsoid's box, but for a constant; nothing for any other quadric, as far
/// as floating point tells. The least volume can belong to a needle.
fn size(&[a, b, c, d, e, f, g, h, i, j]: &[f64; 10]) -> Option<f64> {
    let [xx, yy, zz] = [b * c - f * f, a * c - e * e, a * b - d * d];
    let [xy, xz, yz] = [e * f - d * c, d * f - b * e, d * e - a * f];
    let determinant = a * xx + d * xy + e * xz;
    let squares = g * g * xx + h * h * yy + i * i * zz;
    let products = g * h * xy + g * i * xz + h * i * yz;
    // Less the value at the centre.
    let depth = (squares + 2.0 * products) / determinant - j;
    let is_ellipsoid = a > 0.0 && zz > 0.0 && determinant > 0.0 && depth > 0.0;
    is_ellipsoid.then(|| depth * (xx + yy + zz) / determinant)
}
