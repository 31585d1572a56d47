//! Exact expressions of the trial: integers over one denominator, in coordinates centred on the anchor, so that 128
//! bits hold everything.
//!
//! Denominators are at most 2^20, values at most 2^63 and coordinates at most 2^10, so numerators stay below 2^84.
//!
//! Drawn are ellipses, hyperbolas, double lines, thin discs and dense polynomials at every scale, contours through a
//! pixel, and factors whose rounding is the worst possible.

use super::random::Random;

use imogene_algebra::rational::from_f64_exact;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use num_rational::BigRational;

/// Factors of an expression, numerators over a denominator.
#[derive(Clone, Copy, Debug)]
pub struct Exact<const N: usize> {
    /// In the order of the terms.
    pub factors: [i128; N],
    /// Common denominator, positive.
    pub denominator: i128,
}

/// `a u + b v + c`.
pub type ExactLinear = Exact<3>;
/// `a u^2 + b v^2 + c u v + d u + e v + f`.
pub type ExactQuadratic = Exact<6>;

/// floor(n / d + 1/2), for d > 0.
pub(super) fn rounded(numerator: i128, denominator: i128) -> i128 {
    (2 * numerator + denominator).div_euclid(2 * denominator)
}

impl<const N: usize> Exact<N> {
    /// Each factor rounded as the preparation does.
    pub fn rounded(&self) -> [i128; N] {
        self.factors.map(|n| rounded(n, self.denominator))
    }

    /// The expression as the preparation has it.
    pub fn form(&self) -> [BigRational; N] {
        let over = |n: i128| BigRational::new_raw(n.into(), self.denominator.into());
        self.factors.map(over)
    }
}

impl ExactLinear {
    /// The words that it is rounded to.
    pub fn words(&self) -> Linear {
        let [a, b, c] = self.rounded();
        Linear::new(a, b, c)
    }

    /// Numerator of the value at a point.
    pub fn at(&self, u: i64, v: i64) -> i128 {
        let [a, b, c] = self.factors;
        Linear::new(a, b, c).from_zone(u, v).c
    }
}

impl ExactQuadratic {
    /// The words that it is rounded to.
    pub fn words(&self) -> Quadratic {
        Quadratic::new(self.rounded())
    }

    /// Numerator of the value at a point.
    pub fn at(&self, u: i64, v: i64) -> i128 {
        Quadratic::new(self.factors).from_zone(u, v).f
    }
}

/// `numerator / denominator <= bound`, exactly, for numerators from 0 to 2^127 and positive denominators and bounds.
pub fn at_most(numerator: i128, denominator: i128, bound: f64) -> bool {
    // bound = mantissa / 2^shift
    let bits = bound.to_bits();
    let shift = 1075 - (bits >> 52) as i64;
    let mantissa = i128::from(bits & ((1 << 52) - 1) | 1 << 52);
    let room = i64::from(numerator.leading_zeros()) - 1;
    let product = mantissa.checked_mul(denominator);
    match product {
        Some(product) if bound.is_normal() && (0..=room).contains(&shift) => {
            numerator << shift <= product
        }
        _ => {
            let ratio = BigRational::new(numerator.into(), denominator.into());
            ratio <= from_f64_exact(bound)
        }
    }
}

/// An exact f1 within the depth sum on the box.
pub(super) fn draw_linear(format: &Format, reach: &ScreenBox, random: &mut Random) -> ExactLinear {
    let denominator = draw_denominator(random);
    // Half of the sum word for f1; the root takes less than the other half.
    let most = f64::exp2(f64::from(format.depth + format.guard_linear)) * 0.9;
    let (u, v) = sides(reach);
    let mut part = |distance: f64| {
        let size = random.magnitude(most / 3.0, format.depth) / distance.max(1.0);
        precise(random.signed() * size, denominator, random)
    };
    let mut factors = [part(u), part(v), part(1.0)];
    if random.one_in(4) {
        worst_rounding(&mut factors, denominator, random);
    }
    ExactLinear {
        factors,
        denominator,
    }
}

/// An exact f2 within the quadratic word, and the pixel to which its rounded contour was moved, if any.
pub(super) fn draw_quadratic(
    format: &Format,
    reach: &ScreenBox,
    random: &mut Random,
) -> (ExactQuadratic, Option<(i64, i64)>) {
    let denominator = draw_denominator(random);
    let most = f64::exp2(f64::from(format.quadratic - 1 + format.guard_quadratic)) * 0.4;
    let mut real = draw_shape(reach, random);
    let size: f64 = terms(&real, reach).iter().sum();
    let scale = random.magnitude(most, format.quadratic - 4) / size.max(f64::MIN_POSITIVE);
    real.iter_mut().for_each(|v| *v *= scale);
    let mut factors = real.map(|v| precise(v, denominator, random));
    if random.one_in(4) {
        worst_rounding(&mut factors, denominator, random);
    }
    let mut on_silhouette = None;
    if random.one_in(2) {
        let place = random.place(reach);
        let words = Quadratic::new(factors.map(|n| rounded(n, denominator)));
        factors[5] -= words.from_zone(place.0, place.1).f * denominator;
        on_silhouette = Some(place);
    }
    let exact = ExactQuadratic {
        factors,
        denominator,
    };
    (exact, on_silhouette)
}

/// Greatest numerator that the terms can add up to on the box.
pub(super) fn reach_of(f2: &ExactQuadratic, reach: &ScreenBox) -> i128 {
    let u = i128::from(reach.x1.max(-reach.x0));
    let v = i128::from(reach.y1.max(-reach.y0));
    let [a, b, c, d, e, f] = f2.factors.map(i128::abs);
    a * u * u + b * v * v + c * u * v + d * u + e * v + f
}

fn sides(reach: &ScreenBox) -> (f64, f64) {
    let half = |low: i64, high: i64| high.max(-low) as f64;
    (half(reach.x0, reach.x1), half(reach.y0, reach.y1))
}

/// Magnitudes of the terms in the corner of the box.
fn terms(factors: &[f64; 6], reach: &ScreenBox) -> [f64; 6] {
    let (u, v) = sides(reach);
    let [a, b, c, d, e, f] = factors.map(f64::abs);
    [a * u * u, b * v * v, c * u * v, d * u, e * v, f]
}

fn draw_shape(reach: &ScreenBox, random: &mut Random) -> [f64; 6] {
    let (u, v) = sides(reach);
    let (u, v) = (u.max(1.0), v.max(1.0));
    let sign = if random.one_in(2) { 1.0 } else { -1.0 };
    match random.below(4) {
        0 => {
            // Dense: terms of all magnitudes.
            let distances = [u * u, v * v, u * v, u, v, 1.0];
            distances.map(|distance| random.magnitude(1.0, 20) * random.signed() / distance)
        }
        1 => {
            // A double line, nearly: the contour is tangent to it everywhere.
            let (p, q, s) = (random.signed() / u, random.signed() / v, random.signed());
            let rest = random.magnitude(1.0, 60) * random.signed();
            let (d, e) = (2.0 * p * s, 2.0 * q * s);
            [p * p, q * q, 2.0 * p * q, d, e, s * s + rest].map(|x| sign * x)
        }
        kind => {
            // An ellipse, or a hyperbola, about a point of the box or beside it.
            let (x, y) = (1.5 * u * random.signed(), 1.5 * v * random.signed());
            let a = (random.magnitude(4.0 * u, 6)).powi(-2);
            let b = (random.magnitude(4.0 * v, 6)).powi(-2) * if kind == 2 { 1.0 } else { -1.0 };
            let c = 1.9 * random.signed() * (a * b.abs()).sqrt();
            let level = match random.one_in(8) {
                true => random.magnitude(1.0, 60),
                false => 1.0,
            };
            let (d, e) = (-2.0 * a * x - c * y, -2.0 * b * y - c * x);
            let f = a * x * x + b * y * y + c * x * y - level;
            [a, b, c, d, e, f].map(|x| sign * x)
        }
    }
}

/// All kinds of denominators up to 2^20: small ones, of two, and any.
fn draw_denominator(random: &mut Random) -> i128 {
    match random.below(4) {
        0 => 1 + i128::from(random.below(8)),
        1 => 1 << random.below(21),
        _ => 1 + i128::from(random.below(1 << 20)),
    }
}

/// The numerator of about `value`, with the low bits that `f64` does not have drawn too.
fn precise(value: f64, denominator: i128, random: &mut Random) -> i128 {
    value.round() as i128 * denominator + i128::from(random.below(denominator as u64))
}

/// Replaces what is rounded off by the greatest possible, with random signs or all the same.
fn worst_rounding<const N: usize>(factors: &mut [i128; N], denominator: i128, random: &mut Random) {
    let alike = random.one_in(2);
    let all_up = random.one_in(2);
    for factor in factors {
        let up = if alike { all_up } else { random.one_in(2) };
        let whole = factor.div_euclid(denominator) * denominator;
        // Exactly half is rounded up; the next less than half is rounded down.
        *factor = whole + (denominator + if up { 1 } else { -1 }) / 2;
    }
}
