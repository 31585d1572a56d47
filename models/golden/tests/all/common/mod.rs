//! Words of processors, and random ones, for tests.

use imogene_algebra::rational::{fraction, integer};
use imogene_contract::{MachineWords, RootForm};
pub use imogene_golden::format::{Format, wrap};
pub use imogene_golden::object::quadric::{ObjectPixel, PlaneWords, QuadricWords, ScreenBox};
pub use imogene_golden::object::volume::{VolumeKind, VolumePlane, VolumeQuadric, VolumeWords};
pub use imogene_golden::object::words::Object;
pub use imogene_golden::unit::cut_plane::PlaneKind;
pub use imogene_golden::unit::depth_interval::{Class, Interval};
pub use imogene_golden::unit::normal::NormalWords;
pub use imogene_golden::unit::pe1::Linear;
pub use imogene_golden::unit::pe2::Quadratic;
use num_bigint::BigInt;
use num_rational::BigRational;
pub use proptest::prelude::*;

/// Side of the zones that are compared pixel by pixel.
pub const SIDE: i64 = 20;

/// The pixels of such a zone, line by line.
pub fn pixels() -> impl Iterator<Item = (i64, i64)> {
    square(SIDE)
}

/// The pixels of a square, line by line.
pub fn square(side: i64) -> impl Iterator<Item = (i64, i64)> {
    (0..side).flat_map(move |y| (0..side).map(move |x| (x, y)))
}

/// The values of a processor that goes from pixel to pixel, line by line.
pub fn raster(
    columns: usize,
    lines: usize,
    mut value: impl FnMut(usize, usize) -> i128,
) -> Vec<Vec<i128>> {
    let line = |y| (0..columns).map(|x| value(x, y)).collect();
    (0..lines).map(line).collect()
}

/// Every value of a raster is the exact one modulo its width, and that of the closed form, which `at` gives too.
pub fn check_modulo(
    raster: &[Vec<i128>],
    width: u32,
    at: impl Fn(i64, i64) -> (BigInt, i128),
) -> Result<(), TestCaseError> {
    for (y, line) in (0..).zip(raster) {
        for (x, &value) in (0..).zip(line) {
            let (exact, closed) = at(x, y);
            prop_assert_eq!((exact - value) % (BigInt::from(1) << width), BigInt::ZERO);
            prop_assert_eq!((value, value), (wrap(value, width), closed));
        }
    }
    Ok(())
}

/// Any first-degree expression.
pub fn any_linear() -> impl Strategy<Value = Linear> {
    let words = any::<[i64; 3]>().prop_map(|words| words.map(i128::from));
    words.prop_map(|[a, b, c]| Linear::new(a, b, c))
}

/// Any second-degree expression.
pub fn any_quadratic() -> impl Strategy<Value = Quadratic> {
    any::<[i64; 6]>().prop_map(|words| Quadratic::new(words.map(i128::from)))
}

/// An expression of degree two with rational coefficients, in the order of [`Quadratic`].
pub type Exact = [BigRational; 6];

/// Value of an exact expression at a pixel.
pub fn value_at([a, b, c, d, e, f]: &Exact, x: i64, y: i64) -> BigRational {
    let (x, y) = (integer(x), integer(y));
    (a * &x + c * &y + d) * &x + (b * &y + e) * &y + f
}

/// Half a count of the result, and what rounding six coefficients to `2^-guard` can do at a pixel.
pub fn rounding_bound(x: i64, y: i64, guard: u32) -> BigRational {
    let counts = x * x + y * y + x * y + x + y + 1;
    fraction(1, 2) + fraction(counts, 2 << guard)
}

/// The same of three coefficients.
pub fn linear_bound(x: i64, y: i64, guard: u32) -> BigRational {
    fraction(1, 2) + fraction(x + y + 1, 2 << guard)
}

/// A first-degree expression with factors and constant up to these.
pub fn linear(slope: i64, constant: i64) -> impl Strategy<Value = Linear> {
    let one = -slope..=slope;
    let parts = (one.clone(), one, -constant..=constant);
    parts.prop_map(|(a, b, c)| Linear::new(a.into(), b.into(), c.into()))
}

/// A second-degree expression that changes its sign on a picture.
pub fn quadratic() -> impl Strategy<Value = Quadratic> {
    (any::<[i32; 3]>(), any::<[i64; 3]>()).prop_map(|(q, l)| {
        let ([a, b, c], [d, e, f]) = (q.map(i128::from), l.map(i128::from));
        Quadratic::new([a, b, c, d >> 22, e >> 22, f >> 17])
    })
}

/// A bowl about the middle of a zone, `f` where it is highest.
pub fn bowl(a: i128, b: i128, f: i128) -> Quadratic {
    let side = i128::from(SIDE);
    let middle = (a + b) * side * side / 4;
    Quadratic::new([a, b, 3, -side * a, -side * b, f + middle])
}

/// Every choice of so many of these, in every order and again.
pub fn choices<T: Copy>(of: &[T], count: u32) -> impl Iterator<Item = Vec<T>> {
    let place = |code: usize, k: u32| of[code / of.len().pow(k) % of.len()];
    let choice = move |code| (0..count).map(|k| place(code, k)).collect();
    (0..of.len().pow(count)).map(choice)
}

/// All orders of n planes.
pub fn permutations(n: usize) -> Vec<Vec<usize>> {
    let places: Vec<usize> = (0..n).collect();
    let has_all = |order: &Vec<usize>| places.iter().all(|place| order.contains(place));
    choices(&places, n as u32).filter(has_all).collect()
}

/// The base format with some widths changed.
pub fn fitted(change: impl FnOnce(&mut MachineWords)) -> Format {
    let mut widths = Format::BASE.widths();
    change(&mut widths);
    Format::fitted(&widths).unwrap()
}

/// A front and a back plane at each of these levels, and perpendicular ones that keep and remove the pixel.
pub fn planes_at(levels: &[i64]) -> Vec<(PlaneKind, i64)> {
    let across = |&z: &i64| [(PlaneKind::Front, z), (PlaneKind::Back, z)];
    let along = [0, -1].map(|value| (PlaneKind::Perpendicular, value));
    levels.iter().flat_map(across).chain(along).collect()
}

/// A volume of one line: its columns x0 to x1 from a depth on.
pub fn slab(
    (kind, source): (VolumeKind, u8),
    [x0, x1]: [i64; 2],
    depth: i128,
    margin: u32,
) -> VolumeWords {
    let (front, depth) = (PlaneKind::Front, Linear::new(0, 0, depth));
    let plane = VolumePlane { kind: front, depth };
    VolumeWords {
        kind,
        source,
        screen_box: ScreenBox::of([x0, x1], [0, 0]),
        margin,
        quadric: None,
        planes: vec![plane],
    }
}

/// How a plane lies; seldom not at all.
pub fn kind() -> impl Strategy<Value = PlaneKind> {
    prop_oneof![
        1 => Just(PlaneKind::None),
        4 => Just(PlaneKind::Front),
        4 => Just(PlaneKind::Back),
        1 => Just(PlaneKind::Perpendicular),
    ]
}

/// Any form of the root of so many digits; the usual one as often as all others.
pub fn root_form(digits: u32) -> impl Strategy<Value = RootForm> {
    let all = (0..=2).flat_map(|count| [RootForm::Linear(count), RootForm::Quadratic(count)]);
    let leading = (1..=digits).map(RootForm::Leading);
    let all = all.chain(leading).chain([RootForm::NonRestoring]);
    let others: Vec<RootForm> = all.filter(|form| form.least_digits() <= digits).collect();
    prop_oneof![Just(RootForm::Restoring), prop::sample::select(others)]
}

/// Any class.
pub fn class() -> impl Strategy<Value = Class> {
    prop::sample::select(&Class::ALL[..])
}

/// A box in a zone.
pub fn window() -> impl Strategy<Value = ScreenBox> {
    let side = || [0..SIDE, 0..SIDE].prop_map(|[a, b]| [a.min(b), a.max(b)]);
    (side(), side()).prop_map(|(columns, lines)| ScreenBox::of(columns, lines))
}
