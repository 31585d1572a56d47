//! Exact expressions in the screen coordinates, before any rounding.

use imogene_algebra::rational::integer;
use imogene_algebra::whole::common_denominator;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// `a x + b y + c` in exact rationals.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearForm {
    /// Factor of x.
    pub a: BigRational,
    /// Factor of y.
    pub b: BigRational,
    /// Value at the origin.
    pub c: BigRational,
}

/// `a x^2 + b y^2 + c x y + d x + e y + f` in exact rationals.
#[derive(Clone, Debug, PartialEq)]
pub struct QuadraticForm {
    /// Factor of x^2.
    pub a: BigRational,
    /// Factor of y^2.
    pub b: BigRational,
    /// Factor of x y.
    pub c: BigRational,
    /// Factor of x.
    pub d: BigRational,
    /// Factor of y.
    pub e: BigRational,
    /// Value at the origin.
    pub f: BigRational,
}

impl LinearForm {
    /// The expression that is zero everywhere.
    pub fn zero() -> LinearForm {
        LinearForm::of_array(std::array::from_fn(|_| BigRational::zero()))
    }

    /// True if the expression is zero at every point.
    pub fn is_zero_everywhere(&self) -> bool {
        self.a.is_zero() && self.b.is_zero() && self.c.is_zero()
    }

    /// Value at a point.
    pub fn at(&self, x: &BigRational, y: &BigRational) -> BigRational {
        &self.a * x + &self.b * y + &self.c
    }

    /// The same expression in coordinates whose origin is the point (dx, dy) of the present ones.
    pub fn about(&self, dx: &BigRational, dy: &BigRational) -> LinearForm {
        let ([a, b, c], d) = self.whole();
        let ([x, y], e) = common_denominator([dx, dy]);
        let moved = [&a * &e, &b * &e, a * x + b * y + c * &e];
        LinearForm::of_array(unreduced(moved, &(d * e)))
    }

    /// All coefficients times `k`.
    pub fn scaled(&self, k: &BigRational) -> LinearForm {
        let (n, d) = self.whole();
        LinearForm::of_array(unreduced(n.map(|v| v * k.numer()), &(d * k.denom())))
    }

    fn whole(&self) -> ([BigInt; 3], BigInt) {
        common_denominator([&self.a, &self.b, &self.c])
    }

    /// The expression with these factors.
    pub fn of_array([a, b, c]: [BigRational; 3]) -> LinearForm {
        LinearForm { a, b, c }
    }

    /// The expression that coefficient words stand for.
    pub fn of_words(words: &Linear) -> LinearForm {
        LinearForm::of_array([words.a, words.b, words.c].map(whole))
    }

    /// The difference of two expressions.
    pub fn minus(&self, other: &LinearForm) -> LinearForm {
        self.plus(&other.scaled(&integer(-1)))
    }

    /// The sum of two expressions.
    pub fn plus(&self, other: &LinearForm) -> LinearForm {
        LinearForm::of_array(added(self.whole(), other.whole()))
    }

    /// Largest magnitude over a box of pixels: a first-degree expression has it in a corner.
    pub fn max_abs_on(&self, window: &ScreenBox) -> BigRational {
        let ([a, b, c], d) = self.whole();
        let greatest = corners(window)
            .iter()
            .map(|(x, y)| (&a * x + &b * y + &c).abs())
            .max()
            .expect("four corners");
        BigRational::new_raw(greatest, d)
    }
}

impl QuadraticForm {
    /// The expression that is zero everywhere.
    pub fn zero() -> QuadraticForm {
        QuadraticForm::of_array(std::array::from_fn(|_| BigRational::zero()))
    }

    /// The factors, in the order of [`Quadratic`].
    pub fn factors(&self) -> [&BigRational; 6] {
        [&self.a, &self.b, &self.c, &self.d, &self.e, &self.f]
    }

    /// Value at a point.
    pub fn at(&self, x: &BigRational, y: &BigRational) -> BigRational {
        (&self.a * x + &self.c * y + &self.d) * x + (&self.b * y + &self.e) * y + &self.f
    }

    /// The same expression in coordinates whose origin is the point (dx, dy) of the present ones.
    pub fn about(&self, dx: &BigRational, dy: &BigRational) -> QuadraticForm {
        let ([a, b, c, d, e, f], denominator) = self.whole();
        let ([x, y], unit) = common_denominator([dx, dy]);
        let square = &unit * &unit;
        let along = &a * &x + &c * &y;
        let down = &b * &y + &c * &x;
        let constant = &along * &x + &b * &y * &y + (&d * &x + &e * &y) * &unit + &f * &square;
        let moved = [
            &a * &square,
            &b * &square,
            &c * &square,
            (&a * &x + along + &d * &unit) * &unit,
            (&b * &y + down + &e * &unit) * &unit,
            constant,
        ];
        QuadraticForm::of_array(unreduced(moved, &(denominator * square)))
    }

    /// All coefficients times `k`.
    pub fn scaled(&self, k: &BigRational) -> QuadraticForm {
        let (n, d) = self.whole();
        QuadraticForm::of_array(unreduced(n.map(|v| v * k.numer()), &(d * k.denom())))
    }

    fn whole(&self) -> ([BigInt; 6], BigInt) {
        common_denominator(self.factors())
    }

    /// The same expression in coordinates (u, v) with `x = u column(u) + v column(v) + origin`, where each column and
    /// the origin are pairs (x, y).
    pub fn in_frame(
        &self,
        columns: [[&BigRational; 2]; 2],
        origin: [&BigRational; 2],
    ) -> QuadraticForm {
        let moved = self.about(origin[0], origin[1]);
        let two = integer(2);
        let [[ux, uy], [vx, vy]] = columns;
        QuadraticForm {
            a: (&moved.a * ux + &moved.c * uy) * ux + &moved.b * uy * uy,
            b: (&moved.a * vx + &moved.c * vy) * vx + &moved.b * vy * vy,
            c: &two * (&moved.a * ux * vx + &moved.b * uy * vy) + &moved.c * (ux * vy + uy * vx),
            d: &moved.d * ux + &moved.e * uy,
            e: &moved.d * vx + &moved.e * vy,
            f: moved.f,
        }
    }

    /// The expression with these factors, in the order of [`Quadratic`].
    pub fn of_array([a, b, c, d, e, f]: [BigRational; 6]) -> QuadraticForm {
        QuadraticForm { a, b, c, d, e, f }
    }

    /// A first-degree expression as one of second degree.
    pub fn of_linear(form: &LinearForm) -> QuadraticForm {
        QuadraticForm {
            d: form.a.clone(),
            e: form.b.clone(),
            f: form.c.clone(),
            ..QuadraticForm::zero()
        }
    }

    /// The expression plus a constant.
    pub fn raised(&self, constant: &BigRational) -> QuadraticForm {
        let mut raised = self.clone();
        raised.f += constant;
        raised
    }

    /// The square of a first-degree expression.
    pub fn square_of(form: &LinearForm) -> QuadraticForm {
        let two = integer(2);
        QuadraticForm {
            a: &form.a * &form.a,
            b: &form.b * &form.b,
            c: &two * &form.a * &form.b,
            d: &two * &form.a * &form.c,
            e: &two * &form.b * &form.c,
            f: &form.c * &form.c,
        }
    }

    /// The expression that coefficient words stand for.
    pub fn of_words(words: &Quadratic) -> QuadraticForm {
        let Quadratic { a, b, c, d, e, f } = *words;
        QuadraticForm::of_array([a, b, c, d, e, f].map(whole))
    }

    /// The difference of two expressions.
    pub fn minus(&self, other: &QuadraticForm) -> QuadraticForm {
        let (other, unit) = other.whole();
        QuadraticForm::of_array(added(self.whole(), (other.map(|v| -v), unit)))
    }

    /// Largest magnitude over the rectangle of a box of pixels.
    pub fn max_abs_on(&self, window: &ScreenBox) -> BigRational {
        let (least, greatest) = self.range_on(window);
        least.abs().max(greatest.abs())
    }

    /// Least and greatest value over the rectangle of a box of pixels: they lie in a corner, on an edge where the
    /// derivative along the edge is zero, or where both derivatives are zero.
    pub fn range_on(&self, window: &ScreenBox) -> (BigRational, BigRational) {
        let ([a, b, c, d, e, f], denominator) = self.whole();
        let at = |(x, y): (i64, i64)| ((&a * x + &c * y + &d) * x + (&b * y + &e) * y + &f).into();
        let mut values: Vec<BigRational> = corners(window).map(at).to_vec();
        for y in [window.y0, window.y1] {
            let (linear, constant) = (&c * y + &d, (&b * y + &e) * y + &f);
            values.extend(vertex(&a, &linear, &constant, window.x0, window.x1));
        }
        for x in [window.x0, window.x1] {
            let (linear, constant) = (&c * x + &e, (&a * x + &d) * x + &f);
            values.extend(vertex(&b, &linear, &constant, window.y0, window.y1));
        }
        let determinant: BigInt = &a * &b * 4 - &c * &c;
        if !determinant.is_zero() {
            let x: BigInt = &c * &e - &b * &d * 2;
            let y: BigInt = &c * &d - &a * &e * 2;
            let inside = is_between(&x, &determinant, window.x0, window.x1)
                && is_between(&y, &determinant, window.y0, window.y1);
            if inside {
                let value = &f * &determinant * 2 + &d * x + &e * y;
                values.push(quotient(value, &determinant * 2));
            }
        }
        let over = |value: &BigRational| {
            BigRational::new_raw(value.numer().clone(), value.denom() * &denominator)
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
    let ends = (values.iter().min(), values.iter().max());
    (ends.0.expect("a corner"), ends.1.expect("a corner"))
}

/// Value of `a t^2 + b t + c` where it has no slope, if that is within the bounds.
fn vertex(a: &BigInt, b: &BigInt, c: &BigInt, low: i64, high: i64) -> Option<BigRational> {
    let double: BigInt = a * 2;
    let met = !double.is_zero() && is_between(&-b, &double, low, high);
    met.then(|| quotient(&double * c * 2 - b * b, double * 2))
}

/// Is `n / d` between the bounds.
fn is_between(n: &BigInt, d: &BigInt, low: i64, high: i64) -> bool {
    let (n, d) = if d.is_negative() {
        (-n, -d)
    } else {
        (n.clone(), d.clone())
    };
    &d * low <= n && n <= d * high
}

/// Not reduced: reducing is what takes the time.
fn quotient(n: BigInt, d: BigInt) -> BigRational {
    if d.is_negative() {
        BigRational::new_raw(-n, -d)
    } else {
        BigRational::new_raw(n, d)
    }
}

/// The sum of expressions, each in whole numbers over a denominator.
fn added<const N: usize>(
    (n, d): ([BigInt; N], BigInt),
    (m, e): ([BigInt; N], BigInt),
) -> [BigRational; N] {
    let sum = std::array::from_fn(|k| &n[k] * &e + &m[k] * &d);
    unreduced(sum, &(d * e))
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

fn whole(value: i128) -> BigRational {
    BigRational::from_integer(value.into())
}

fn corners(window: &ScreenBox) -> [(i64, i64); 4] {
    let (x, y) = ([window.x0, window.x1], [window.y0, window.y1]);
    [0, 1, 2, 3].map(|k| (x[k % 2], y[k / 2]))
}
