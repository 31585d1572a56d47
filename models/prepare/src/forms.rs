//! Exact expressions in the screen coordinates, before any rounding.

use imogene_algebra::rational::integer;
use imogene_algebra::whole::{common_denominator, common_divisor};
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

/// The factors of an expression: whole numbers over one positive denominator. They are not reduced: that would take
/// longer than everything else that is done with them.
#[derive(Clone, Debug)]
pub struct Form<const N: usize> {
    whole: [BigInt; N],
    unit: BigInt,
}

/// `a x + b y + c`.
pub type LinearForm = Form<3>;

/// `a x^2 + b y^2 + c x y + d x + e y + f`.
pub type QuadraticForm = Form<6>;

impl<const N: usize> Form<N> {
    /// The expression that is zero everywhere.
    pub fn zero() -> Self {
        Self::of_whole(std::array::from_fn(|_| BigInt::zero()))
    }

    /// The expression with these factors.
    pub fn of_array(factors: [BigRational; N]) -> Self {
        let (whole, unit) = common_denominator(factors.each_ref());
        Form { whole, unit }
    }

    /// The expression with these factors over a denominator that is not zero.
    pub(super) fn over(whole: [BigInt; N], unit: BigInt) -> Self {
        match unit.is_negative() {
            true => Form {
                whole: whole.map(|v| -v),
                unit: -unit,
            },
            false => Form { whole, unit },
        }
    }

    fn of_whole(whole: [BigInt; N]) -> Self {
        Form {
            whole,
            unit: BigInt::one(),
        }
    }

    /// The factors, not reduced.
    pub fn factors(&self) -> [BigRational; N] {
        unreduced(self.whole.clone(), &self.unit)
    }

    /// The factors times a positive number: whole numbers, and that number.
    pub fn whole(&self) -> (&[BigInt; N], &BigInt) {
        (&self.whole, &self.unit)
    }

    /// The factors rounded to the nearest integer, halves upwards.
    pub(super) fn rounded(&self) -> [BigInt; N] {
        let double: BigInt = &self.unit * 2;
        let round = |v: &BigInt| (v * 2i32 + &self.unit).div_floor(&double);
        self.whole.each_ref().map(round)
    }

    /// True if the expression is zero at every point.
    pub fn is_zero_everywhere(&self) -> bool {
        self.whole.iter().all(Zero::is_zero)
    }

    /// True if the first factor that is not zero is negative.
    pub(super) fn leads_downwards(&self) -> bool {
        let leading = self.whole.iter().find(|factor| !factor.is_zero());
        leading.is_some_and(Signed::is_negative)
    }

    /// All coefficients times `k`.
    pub fn scaled(&self, k: &BigRational) -> Self {
        let whole = self.whole.each_ref().map(|v| v * k.numer());
        Self::over(whole, &self.unit * k.denom())
    }

    /// The positive multiple whose factors are whole and without common divisor.
    pub(super) fn primitive(&self) -> Self {
        let divisor = common_divisor(self.whole.each_ref());
        match divisor.is_zero() {
            true => Self::zero(),
            false => Self::of_whole(self.whole.each_ref().map(|v| v / &divisor)),
        }
    }

    /// The sum of two expressions.
    pub fn plus(&self, other: &Self) -> Self {
        let sum = |k: usize| &self.whole[k] * &other.unit + &other.whole[k] * &self.unit;
        Self::over(std::array::from_fn(sum), &self.unit * &other.unit)
    }

    /// The difference of two expressions.
    pub fn minus(&self, other: &Self) -> Self {
        let difference = |k: usize| &self.whole[k] * &other.unit - &other.whole[k] * &self.unit;
        Self::over(std::array::from_fn(difference), &self.unit * &other.unit)
    }

    /// The expression plus a constant.
    pub fn raised(&self, constant: &BigRational) -> Self {
        let mut whole = self.whole.each_ref().map(|v| v * constant.denom());
        whole[N - 1] += &self.unit * constant.numer();
        Self::over(whole, &self.unit * constant.denom())
    }
}

impl LinearForm {
    /// Value at a point.
    pub fn at(&self, x: &BigRational, y: &BigRational) -> BigRational {
        let [.., value] = self.about(x, y).factors();
        value
    }

    /// The same expression in coordinates whose origin is the point (dx, dy) of the present ones.
    pub fn about(&self, dx: &BigRational, dy: &BigRational) -> LinearForm {
        let [a, b, c] = &self.whole;
        let ([x, y], unit) = common_denominator([dx, dy]);
        let moved = [a * &unit, b * &unit, a * x + b * y + c * &unit];
        Form::over(moved, &self.unit * unit)
    }

    /// The expression that coefficient words stand for.
    pub fn of_words(words: &Linear) -> LinearForm {
        Form::of_whole([words.a, words.b, words.c].map(BigInt::from))
    }

    /// Largest magnitude over a box of pixels.
    pub fn max_abs_on(&self, window: &ScreenBox) -> BigRational {
        let (least, greatest) = self.range_on(window);
        BigRational::new_raw(
            least.numer().abs().max(greatest.numer().abs()),
            self.unit.clone(),
        )
    }

    /// Least and greatest value over a box of pixels: a first-degree expression has them in corners.
    pub fn range_on(&self, window: &ScreenBox) -> (BigRational, BigRational) {
        let [a, b, c] = &self.whole;
        let ends = |slope: &BigInt, ends: [i64; 2]| {
            let mut ends = ends.map(|at| slope * at);
            ends.sort();
            ends
        };
        let along = ends(a, [window.x0, window.x1]);
        let down = ends(b, [window.y0, window.y1]);
        let value = |k: usize| BigRational::new_raw(&along[k] + &down[k] + c, self.unit.clone());
        (value(0), value(1))
    }
}

impl QuadraticForm {
    /// Value at a point.
    pub fn at(&self, x: &BigRational, y: &BigRational) -> BigRational {
        let [.., value] = self.about(x, y).factors();
        value
    }

    /// The same expression in coordinates whose origin is the point (dx, dy) of the present ones.
    pub fn about(&self, dx: &BigRational, dy: &BigRational) -> QuadraticForm {
        let [a, b, c, d, e, f] = &self.whole;
        let ([x, y], unit) = common_denominator([dx, dy]);
        let square = &unit * &unit;
        let along = a * &x + c * &y;
        let down = b * &y + c * &x;
        let constant = &along * &x + b * &y * &y + (d * &x + e * &y) * &unit + f * &square;
        let moved = [
            a * &square,
            b * &square,
            c * &square,
            (a * &x + along + d * &unit) * &unit,
            (b * &y + down + e * &unit) * &unit,
            constant,
        ];
        Form::over(moved, &self.unit * square)
    }

    /// The same expression in coordinates (u, v) with `x = u column(u) + v column(v) + origin`, where each column and
    /// the origin are pairs (x, y).
    pub fn in_frame(
        &self,
        columns: [[&BigRational; 2]; 2],
        origin: [&BigRational; 2],
    ) -> QuadraticForm {
        let Form { whole, unit } = self.about(origin[0], origin[1]);
        let [a, b, c, d, e, f] = &whole;
        let [u, v] = columns;
        let ([ux, uy, vx, vy], length) = common_denominator([u[0], u[1], v[0], v[1]]);
        let square = &length * &length;
        let moved = [
            (a * &ux + c * &uy) * &ux + b * &uy * &uy,
            (a * &vx + c * &vy) * &vx + b * &vy * &vy,
            (a * &ux * &vx + b * &uy * &vy) * 2 + c * (&ux * &vy + &uy * &vx),
            (d * &ux + e * &uy) * &length,
            (d * &vx + e * &vy) * &length,
            f * &square,
        ];
        Form::over(moved, unit * square)
    }

    /// A first-degree expression as one of second degree.
    pub fn of_linear(form: &LinearForm) -> QuadraticForm {
        let zero = BigInt::zero;
        let [a, b, c] = form.whole.clone();
        Form::over([zero(), zero(), zero(), a, b, c], form.unit.clone())
    }

    /// The square of a first-degree expression.
    pub fn square_of(form: &LinearForm) -> QuadraticForm {
        let [a, b, c] = &form.whole;
        let square = [a * a, b * b, a * b * 2, a * c * 2, b * c * 2, c * c];
        Form::over(square, &form.unit * &form.unit)
    }

    /// The expression that coefficient words stand for.
    pub fn of_words(words: &Quadratic) -> QuadraticForm {
        let Quadratic { a, b, c, d, e, f } = *words;
        Form::of_whole([a, b, c, d, e, f].map(BigInt::from))
    }

    /// Largest magnitude over the rectangle of a box of pixels.
    pub fn max_abs_on(&self, window: &ScreenBox) -> BigRational {
        let (least, greatest) = self.range_on(window);
        greater(least.abs(), greatest.abs())
    }

    /// Least and greatest value over the rectangle of a box of pixels: they lie in a corner, on an edge where the
    /// derivative along the edge is zero, or where both derivatives are zero.
    pub fn range_on(&self, window: &ScreenBox) -> (BigRational, BigRational) {
        let [a, b, c, d, e, f] = &self.whole;
        let at = |x: i64, y: i64| (a * x + c * y + d) * x + (b * y + e) * y + f;
        let (x, y) = ([window.x0, window.x1], [window.y0, window.y1]);
        let mut corners = [0, 1, 2, 3].map(|k| at(x[k % 2], y[k / 2]));
        corners.sort();
        let [least, .., greatest] = corners;
        let mut values: Vec<BigRational> = vec![least.into(), greatest.into()];
        for y in [window.y0, window.y1] {
            let (linear, constant) = (c * y + d, (b * y + e) * y + f);
            values.extend(vertex(a, &linear, &constant, window.x0, window.x1));
        }
        for x in [window.x0, window.x1] {
            let (linear, constant) = (c * x + e, (a * x + d) * x + f);
            values.extend(vertex(b, &linear, &constant, window.y0, window.y1));
        }
        let determinant: BigInt = a * b * 4 - c * c;
        if !determinant.is_zero() {
            let x: BigInt = c * e - b * d * 2;
            let y: BigInt = c * d - a * e * 2;
            let inside = is_between(&x, &determinant, window.x0, window.x1)
                && is_between(&y, &determinant, window.y0, window.y1);
            if inside {
                let value = f * &determinant * 2 + d * x + e * y;
                values.push(quotient(value, &determinant * 2));
            }
        }
        let over = |value: &BigRational| {
            BigRational::new_raw(value.numer().clone(), value.denom() * &self.unit)
        };
        let (least, greatest) = ends(&values);
        (over(least), over(greatest))
    }

    /// Least and greatest value over the rectangle `x0 .. x1`, `y0 .. y1`.
    pub fn range_between(&self, rectangle: &[BigRational; 4]) -> (BigRational, BigRational) {
        let [x0, x1, y0, y1] = rectangle;
        let (zero, unit) = (integer(0), ScreenBox::of([0, 1], [0, 1]));
        let (columns, lines) = (x1 - x0, y1 - y0);
        let in_unit = self.in_frame([[&columns, &zero], [&zero, &lines]], [x0, y0]);
        in_unit.range_on(&unit)
    }
}

fn ends(values: &[BigRational]) -> (&BigRational, &BigRational) {
    let least = values.iter().min_by(|a, b| order(a, b));
    let ends = (least, values.iter().max_by(|a, b| order(a, b)));
    (ends.0.expect("a corner"), ends.1.expect("a corner"))
}

/// Value of `a t^2 + b t + c` where it has no slope, if that is within the bounds.
fn vertex(a: &BigInt, b: &BigInt, c: &BigInt, low: i64, high: i64) -> Option<BigRational> {
    let double: BigInt = a * 2;
    let met = !double.is_zero() && is_between(&-b, &double, low, high);
    met.then(|| quotient(&double * c * 2 - b * b, double * 2))
}

fn is_between(n: &BigInt, d: &BigInt, low: i64, high: i64) -> bool {
    let (from, to) = (d * low, d * high);
    match d.is_negative() {
        true => to <= *n && *n <= from,
        false => from <= *n && *n <= to,
    }
}

/// Not reduced: reducing is what takes the time.
fn quotient(n: BigInt, d: BigInt) -> BigRational {
    if d.is_negative() {
        BigRational::new_raw(-n, -d)
    } else {
        BigRational::new_raw(n, d)
    }
}

/// The order of two fractions, neither of them reduced.
fn order(a: &BigRational, b: &BigRational) -> Ordering {
    if a.denom() == b.denom() {
        return a.numer().cmp(b.numer());
    }
    (a.numer() * b.denom()).cmp(&(b.numer() * a.denom()))
}

/// The greater of two fractions, as it is.
pub(super) fn greater(a: BigRational, b: BigRational) -> BigRational {
    match order(&a, &b) {
        Ordering::Less => b,
        _ => a,
    }
}

/// The product of two fractions, not reduced.
pub(super) fn times(a: &BigRational, b: &BigRational) -> BigRational {
    BigRational::new_raw(a.numer() * b.numer(), a.denom() * b.denom())
}

/// The sum of two fractions, not reduced.
pub(super) fn sum(a: &BigRational, b: &BigRational) -> BigRational {
    let numerator = a.numer() * b.denom() + b.numer() * a.denom();
    BigRational::new_raw(numerator, a.denom() * b.denom())
}

/// The inverse of a fraction that is not zero, as it is.
pub(super) fn inverse(a: &BigRational) -> BigRational {
    quotient(a.denom().clone(), a.numer().clone())
}

/// The quotients as they are.
pub(super) fn unreduced<const N: usize>(n: [BigInt; N], d: &BigInt) -> [BigRational; N] {
    n.map(|v| BigRational::new_raw(v, d.clone()))
}
