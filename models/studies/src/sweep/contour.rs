//! The computed contour of a quadric against the true one.

use imogene_algebra::rational::{from_f64_exact, power_of_two, to_f64};
use imogene_golden::format::Format;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_prepare::PreparedQuadric;
use imogene_prepare::forms::QuadraticForm;
use num_rational::BigRational;
use num_traits::Signed;

/// How far the computed contour is from the true one, to first order: `|q2 - f2|` over the length of the gradient of
/// q2, at every point in which it crosses a line or a column of the screen box and that the planes keep. The numerator
/// is exact; the bound of the check divides the greatest such difference by the least gradient.
pub(super) fn displaced(object: &PreparedQuadric, format: &Format) -> Option<f64> {
    let window = object.words.screen_box;
    if window.is_empty() {
        return None;
    }
    let unit = power_of_two(format.guard_quadratic);
    let residual = QuadraticForm::of_words(&object.words.f2).minus(&object.exact.f2.scaled(&unit));
    let lines = (window.y0..=window.y1).flat_map(|y| crossings(object, y, Along::Line));
    let columns = (window.x0..=window.x1).flat_map(|x| crossings(object, x, Along::Column));
    let off = |point: Crossing| {
        let [x, y] = point.at.map(from_f64_exact);
        let off = to_f64(&residual.at(&x, &y)).abs();
        is_kept(object, &x, &y).then(|| off / point.slope)
    };
    lines.chain(columns).filter_map(off).reduce(f64::max)
}

/// A point of the computed contour, with the length of the gradient there.
struct Crossing {
    at: [f64; 2],
    slope: f64,
}

/// What a contour is crossed along.
#[derive(Clone, Copy)]
enum Along {
    Line,
    Column,
}

impl Along {
    /// What belongs to columns and to lines as what is along and across, or the other way round.
    fn turned<T>(self, [first, second]: [T; 2]) -> [T; 2] {
        match self {
            Along::Line => [first, second],
            Along::Column => [second, first],
        }
    }
}

/// Where the computed contour crosses a line or a column of the screen box.
fn crossings(object: &PreparedQuadric, number: i64, along: Along) -> Vec<Crossing> {
    let window = object.words.screen_box;
    let sides = [[window.x0, window.x1], [window.y0, window.y1]];
    let [[first, last], _] = along.turned(sides);
    // About the middle, so that no digits are lost.
    let middle = (first + last) / 2;
    let [x, y] = along.turned([middle, number]);
    let q = object.words.f2.from_zone(x, y);
    let [square, _] = along.turned([q.a, q.b]);
    let [linear, across] = along.turned([q.d, q.e]);
    let [a, b, c, across, mixed] = [square, linear, q.f, across, q.c].map(|v| v as f64);
    let root = (b * b - 4.0 * a * c).sqrt();
    // The root that does not cancel, and the other from the product of both.
    let steady = -0.5 * (b + root.copysign(b));
    let found = [steady / a, c / steady].map(|u| Crossing {
        at: along.turned([middle as f64 + u, number as f64]),
        slope: (2.0 * a * u + b).hypot(mixed * u + across),
    });
    let inside = |p: &Crossing| {
        let mut places = sides.iter().zip(p.at);
        places.all(|([first, last], at)| (*first as f64..=*last as f64).contains(&at))
    };
    let crossed = |p: &Crossing| p.slope > 0.0 && inside(p);
    found.into_iter().filter(crossed).collect()
}

/// True if no plane removes the contour, whose depth is f1, at a place of the screen.
fn is_kept(object: &PreparedQuadric, x: &BigRational, y: &BigRational) -> bool {
    let depth = object.exact.f1.at(x, y);
    let has_depth = !matches!(object.words.class, Class::Front | Class::Prism);
    let planes = object.words.planes.iter().zip(&object.exact.planes);
    planes.into_iter().all(|(words, exact)| {
        let value = exact.at(x, y);
        match words.kind {
            PlaneKind::Perpendicular => !value.is_negative(),
            PlaneKind::Front if has_depth => depth >= value,
            PlaneKind::Back if has_depth => depth <= value,
            _ => true,
        }
    })
}
