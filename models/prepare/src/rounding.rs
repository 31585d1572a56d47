//! Rounding to coefficient words: once, about the middle of the screen box, where it does least harm; of what several
//! objects share, about the middle of all their boxes, where it does the same to each.
//!
//! Factors are rounded in coordinates centred on an anchor pixel and then moved to the screen origin as exact integers.
//! The error at a pixel therefore grows with its distance from the anchor, not from the screen's corner.
//!
//! Two bounds hold for that error on a box. [`Anchor::linear_bound`] and [`Anchor::quadratic_bound`] are known before
//! any coefficient is: half a bit for each factor, times what it is multiplied with. [`linear_error`] and
//! [`quadratic_error`] are the exact greatest error of given words: the residual, rounded minus exact factor, is itself
//! an expression of the same degree, and its range on the box is known exactly.

use super::forms::{Form, LinearForm, QuadraticForm};
use imogene_algebra::rational::{integer, power_of_two};
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// The pixel about which coefficients are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Anchor {
    /// Column.
    pub x: i64,
    /// Line.
    pub y: i64,
}

impl Anchor {
    /// The screen's first pixel: the source's convention.
    pub const ORIGIN: Anchor = Anchor { x: 0, y: 0 };

    /// The middle of a box.
    pub fn middle_of(window: &ScreenBox) -> Anchor {
        Anchor {
            x: (window.x0 + window.x1).div_euclid(2),
            y: (window.y0 + window.y1).div_euclid(2),
        }
    }

    /// Greatest distance (columns, lines) of a pixel of the box.
    fn reach(&self, window: &ScreenBox) -> (f64, f64) {
        let far = |low: i64, high: i64, at: i64| (at - low).abs().max((high - at).abs()) as f64;
        (
            far(window.x0, window.x1, self.x),
            far(window.y0, window.y1, self.y),
        )
    }

    /// Greatest rounding error of any first-degree expression on the box, in units of its last bit: half a bit for each
    /// factor, times the distance it is multiplied with. If the box reaches N columns and N lines from the anchor this
    /// is the source's (2N + 1) / 2.
    pub fn linear_bound(&self, window: &ScreenBox) -> f64 {
        let (u, v) = self.reach(window);
        0.5 * (u + v + 1.0)
    }

    /// Greatest rounding error of any second-degree expression on the box, in units of its last bit. If the box reaches
    /// N columns and N lines from the anchor this is the source's (3 N^2 + 2N + 1) / 2.
    pub fn quadratic_bound(&self, window: &ScreenBox) -> f64 {
        let (u, v) = self.reach(window);
        0.5 * (u * u + v * v + u * v + u + v + 1.0)
    }
}

/// The words of the coefficients about a pixel; one that is beyond 95 bits itself: no word can hold it, and room is
/// left so that moving the expression to another origin cannot overflow.
fn words<const N: usize>(centred: &Form<N>) -> Result<[i128; N], BigRational> {
    let mut words = [0; N];
    for (k, (word, rounded)) in words.iter_mut().zip(centred.rounded()).enumerate() {
        let held = rounded.to_i128().filter(|v| v.unsigned_abs() < 1 << 95);
        *word = held.ok_or_else(|| centred.factors()[k].clone())?;
    }
    Ok(words)
}

/// Rounds about the anchor and moves to the screen origin; the error is a coefficient that no word can hold.
pub fn round_linear(form: &LinearForm, anchor: Anchor) -> Result<Linear, BigRational> {
    let centred = form.about(&integer(anchor.x), &integer(anchor.y));
    let [a, b, c] = words(&centred)?;
    Ok(Linear::new(a, b, c).from_zone(-anchor.x, -anchor.y))
}

/// The same for an expression of second degree.
pub fn round_quadratic(form: &QuadraticForm, anchor: Anchor) -> Result<Quadratic, BigRational> {
    let centred = form.about(&integer(anchor.x), &integer(anchor.y));
    Ok(Quadratic::new(words(&centred)?).from_zone(-anchor.x, -anchor.y))
}

/// Rounds an expression of which the sign alone counts: that of the other side has exactly opposite words, also where a
/// factor lies between two words.
pub fn round_half_plane(form: &LinearForm, anchor: Anchor) -> Result<Linear, BigRational> {
    if !form.leads_downwards() {
        return round_linear(form, anchor);
    }
    let Linear { a, b, c } = round_linear(&form.scaled(&integer(-1)), anchor)?;
    Ok(Linear::new(-a, -b, -c))
}

/// The same for an expression of second degree.
pub fn round_contour(form: &QuadraticForm, anchor: Anchor) -> Result<Quadratic, BigRational> {
    if !form.leads_downwards() {
        return round_quadratic(form, anchor);
    }
    let Quadratic { a, b, c, d, e, f } = round_quadratic(&form.scaled(&integer(-1)), anchor)?;
    Ok(Quadratic::new([a, b, c, d, e, f].map(|v| -v)))
}

/// Greatest distance on the box, exactly, of the expression in words of `guards` guard bits from the one they were
/// rounded from.
pub fn linear_error(
    words: &Linear,
    exact: &LinearForm,
    guards: u32,
    window: &ScreenBox,
) -> BigRational {
    let unit = power_of_two(guards).recip();
    let residual = LinearForm::of_words(words).scaled(&unit).minus(exact);
    residual.max_abs_on(window)
}

/// The same for an expression of second degree.
pub fn quadratic_error(
    words: &Quadratic,
    exact: &QuadraticForm,
    guards: u32,
    window: &ScreenBox,
) -> BigRational {
    let unit = power_of_two(guards).recip();
    let residual = QuadraticForm::of_words(words).scaled(&unit).minus(exact);
    residual.max_abs_on(window)
}

/// Two's complement bits that hold every integer up to this magnitude, after rounding.
pub(super) fn signed_bits(magnitude: &BigRational) -> u32 {
    magnitude.ceil().to_integer().bits() as u32 + 1
}
