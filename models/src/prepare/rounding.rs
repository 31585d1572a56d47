//! Rounding to coefficient words: once, about the middle of the screen box, where it does least harm.
//!
//! Factors are rounded in coordinates centred on an anchor pixel and then moved to the screen origin as exact integers. The error at a
//! pixel therefore grows with its distance from the anchor, not from the screen's corner.

use super::forms::{LinearForm, QuadraticForm};
use crate::object::quadric::ScreenBox;
use crate::rational::{integer, round_half_up};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
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

    /// Greatest rounding error of a first-degree expression on the box, in units of its last bit: half a bit for each factor,
    /// times the distance it is multiplied with.
    pub fn linear_bound(&self, window: &ScreenBox) -> f64 {
        let (u, v) = self.reach(window);
        0.5 * (u + v + 1.0)
    }

    /// Greatest rounding error of a second-degree expression on the box, in units of its last bit.
    pub fn quadratic_bound(&self, window: &ScreenBox) -> f64 {
        let (u, v) = self.reach(window);
        0.5 * (u * u + v * v + u * v + u + v + 1.0)
    }
}

/// A coefficient beyond 127 bits: no word can hold it.
#[derive(Clone, Debug, PartialEq)]
pub struct Unrepresentable {
    /// The exact coefficient.
    pub value: BigRational,
}

fn word(value: &BigRational) -> Result<i128, Unrepresentable> {
    // Room is left so that moving the expression to another origin cannot overflow.
    round_half_up(value)
        .to_i128()
        .filter(|v| v.unsigned_abs() < 1 << 95)
        .ok_or_else(|| Unrepresentable {
            value: value.clone(),
        })
}

/// Rounds about the anchor and moves to the screen origin.
pub fn round_linear(form: &LinearForm, anchor: Anchor) -> Result<Linear, Unrepresentable> {
    let centred = form.about(&integer(anchor.x), &integer(anchor.y));
    let rounded = Linear::new(word(&centred.a)?, word(&centred.b)?, word(&centred.c)?);
    Ok(rounded.from_zone(-anchor.x, -anchor.y))
}

/// Rounds about the anchor and moves to the screen origin.
pub fn round_quadratic(form: &QuadraticForm, anchor: Anchor) -> Result<Quadratic, Unrepresentable> {
    let centred = form.about(&integer(anchor.x), &integer(anchor.y));
    let rounded = Quadratic {
        a: word(&centred.a)?,
        b: word(&centred.b)?,
        c: word(&centred.c)?,
        d: word(&centred.d)?,
        e: word(&centred.e)?,
        f: word(&centred.f)?,
    };
    Ok(rounded.from_zone(-anchor.x, -anchor.y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rational::fraction;
    use num_traits::Signed;
    use proptest::prelude::*;

    fn to_f64(value: &BigRational) -> f64 {
        crate::rational::to_f64(value)
    }

    proptest! {
        #[test]
        fn rounding_stays_within_its_bound_on_every_pixel(
            n in proptest::array::uniform6(-1_000_000i64..1_000_000), d in 1i64..1000, x0 in 0i64..500, y0 in 0i64..500, w in 1i64..30, h in 1i64..30
        ) {
            let window = ScreenBox { x0, x1: x0 + w, y0, y1: y0 + h };
            let anchor = Anchor::middle_of(&window);
            let [a, b, c, dd, e, f] = n.map(|n| fraction(n, d));
            let linear = LinearForm::new(a.clone(), b.clone(), c.clone());
            let quadratic = QuadraticForm { a, b, c, d: dd, e, f };
            let l = round_linear(&linear, anchor).unwrap();
            let q = round_quadratic(&quadratic, anchor).unwrap();
            for x in [x0, anchor.x, x0 + w] {
                for y in [y0, anchor.y, y0 + h] {
                    let (px, py) = (integer(x), integer(y));
                    let off = BigRational::from_integer(l.exact_at(x, y)) - linear.at(&px, &py);
                    prop_assert!(to_f64(&off.abs()) <= anchor.linear_bound(&window));
                    let off = BigRational::from_integer(q.exact_at(x, y)) - quadratic.at(&px, &py);
                    prop_assert!(to_f64(&off.abs()) <= anchor.quadratic_bound(&window));
                }
            }
        }
    }
}
