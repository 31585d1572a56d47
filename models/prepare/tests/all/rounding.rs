use imogene_algebra::rational::{fraction, integer, power_of_two};
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::pe2::Quadratic;
use imogene_prepare::forms::{LinearForm, QuadraticForm};
use imogene_prepare::rounding::{
    Anchor, linear_error, quadratic_error, round_contour, round_half_plane, round_linear,
    round_quadratic,
};
use num_rational::BigRational;
use num_traits::Signed;
use proptest::prelude::*;

fn to_f64(value: &BigRational) -> f64 {
    imogene_algebra::rational::to_f64(value)
}

#[test]
fn bounds_before_the_coefficients_are_those_of_the_source() {
    for n in [720, 1024] {
        let window = ScreenBox {
            x0: 0,
            x1: n,
            y0: 0,
            y1: n,
        };
        let n = n as f64;
        assert_eq!(Anchor::ORIGIN.linear_bound(&window), (2.0 * n + 1.0) / 2.0);
        assert_eq!(
            Anchor::ORIGIN.quadratic_bound(&window),
            (3.0 * n * n + 2.0 * n + 1.0) / 2.0
        );
    }
}

#[test]
fn two_sides_of_a_line_or_a_contour_have_opposite_words() {
    let halves = |n: [i64; 6]| n.map(|n| fraction(n, 2));
    let [a, b, c, d, e, f] = halves([-1, 3, 5, -7, 9, 1]);
    let anchor = Anchor { x: 1, y: 2 };
    let linear = LinearForm::of_array([a.clone(), b.clone(), c.clone()]);
    let opposite = linear.scaled(&integer(-1));
    let sides = [&linear, &opposite];
    let [one, other] = sides.map(|form| round_half_plane(form, anchor).unwrap());
    assert_eq!([one.a, one.b, one.c], [-other.a, -other.b, -other.c]);
    // Rounding halves upwards would not do it.
    let [up, down] = sides.map(|form| round_linear(form, anchor).unwrap());
    assert_ne!(up.a, -down.a);
    let quadratic = QuadraticForm::of_array([a, b, c, d, e, f]);
    let other = quadratic.scaled(&integer(-1));
    let [one, other] = [&quadratic, &other].map(|form| round_contour(form, anchor).unwrap());
    let factors = |q: &Quadratic| [q.a, q.b, q.c, q.d, q.e, q.f];
    assert_eq!(factors(&one), factors(&other).map(|v| -v));
}

proptest! {
    /// At every pixel the error is at most the exact maximum, which is at most the bound known beforehand.
    #[test]
    fn rounding_stays_within_its_bounds_on_every_pixel(
        n in proptest::array::uniform6(-1_000_000i64..1_000_000), d in 1i64..1000, guards in 0u32..=8,
        x0 in 0i64..500, y0 in 0i64..500, w in 1i64..12, h in 1i64..12
    ) {
        let window = ScreenBox { x0, x1: x0 + w, y0, y1: y0 + h };
        let anchor = Anchor::middle_of(&window);
        let unit = power_of_two(guards);
        let [a, b, c, dd, e, f] = n.map(|n| fraction(n, d));
        let linear = LinearForm::of_array([a.clone(), b.clone(), c.clone()]);
        let quadratic = QuadraticForm::of_array([a, b, c, dd, e, f]);
        let l = round_linear(&linear.scaled(&unit), anchor).unwrap();
        let q = round_quadratic(&quadratic.scaled(&unit), anchor).unwrap();
        let error = linear_error(&l, &linear, guards, &window);
        let error2 = quadratic_error(&q, &quadratic, guards, &window);
        prop_assert!(to_f64(&(&error * &unit)) <= anchor.linear_bound(&window));
        prop_assert!(to_f64(&(&error2 * &unit)) <= anchor.quadratic_bound(&window));
        let mut worst = integer(0);
        for x in x0..=x0 + w {
            for y in y0..=y0 + h {
                let (px, py) = (integer(x), integer(y));
                let off = BigRational::from_integer(l.exact_at(x, y)) / &unit - linear.at(&px, &py);
                worst = worst.max(off.abs());
                let off = BigRational::from_integer(q.exact_at(x, y)) / &unit - quadratic.at(&px, &py);
                prop_assert!(off.abs() <= error2);
            }
        }
        prop_assert_eq!(worst, error);
    }
}
