//! The true sign of f2 at every pixel of a box, in big integers.

use crate::exact::ray::second_degree;
use imogene_algebra::whole::common_denominator;
use imogene_golden::object::quadric::ScreenBox;
use imogene_prepare::forms::QuadraticForm;
use num_bigint::{BigInt, Sign};
use num_traits::{Signed, ToPrimitive};
use rayon::prelude::*;

/// What is true of f2 on a box; no format and no rounding has a part in it but the scale.
pub(super) struct TrueSigns {
    /// For each pixel, row by row: f2 >= 0.
    pub present: Vec<bool>,
    /// Pixels at which f2 is zero.
    pub ties: u64,
    /// Greatest ratio over the pixels, where f2 is not zero, of the error that rounding can have there to the magnitude
    /// of f2.
    pub risk: f64,
}

/// Evaluates the exact expression at every pixel. `reach` gives the greatest rounding error of any such expression at a
/// pixel, in last bits.
pub(super) fn true_signs(
    exact: &QuadraticForm,
    window: &ScreenBox,
    reach: impl Fn(i64, i64) -> f64 + Sync,
) -> TrueSigns {
    let (form, denominator) = common_denominator(exact.factors());
    let unit = denominator.to_f64().expect("a finite or infinite float");
    let line = |y: i64| {
        let mut line = TrueSigns {
            present: vec![],
            ties: 0,
            risk: 0.0,
        };
        // Forward differences along the line.
        let at = |x: i64| second_degree(&form, x, y);
        let mut value = at(window.x0);
        let mut step = at(window.x0 + 1) - &value;
        let second: BigInt = &form[0] * 2;
        for x in window.x0..=window.x1 {
            line.present.push(!value.is_negative());
            if value.sign() == Sign::NoSign {
                line.ties += 1;
            } else {
                let size = magnitude(&value, &denominator, unit);
                line.risk = line.risk.max(reach(x, y) / size);
            }
            value += &step;
            step += &second;
        }
        line
    };
    let lines: Vec<TrueSigns> = (window.y0..=window.y1).into_par_iter().map(line).collect();
    TrueSigns {
        ties: lines.iter().map(|l| l.ties).sum(),
        risk: lines.iter().map(|l| l.risk).fold(0.0, f64::max),
        present: lines.into_iter().flat_map(|l| l.present).collect(),
    }
}

/// |value / denominator|, also where one of them is beyond `f64`.
fn magnitude(value: &BigInt, denominator: &BigInt, unit: f64) -> f64 {
    let float = value.to_f64().expect("a finite or infinite float").abs();
    if float.is_finite() && unit.is_finite() {
        return float / unit;
    }
    // Leading bits only.
    let (n, d) = (value.bits() as i64, denominator.bits() as i64);
    let lead = |v: &BigInt, bits: i64| (v.abs() >> (bits - 60).max(0)).to_f64().expect("60 bits");
    let power = (n - 60).max(0) - (d - 60).max(0);
    lead(value, n) / lead(denominator, d) * f64::exp2(power as f64)
}
