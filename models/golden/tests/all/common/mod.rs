//! Random words for tests.

use imogene_contract::RootForm;
use imogene_golden::object::screen_box::ScreenBox;
use imogene_golden::object::volume::{VolumeKind, VolumePlane, VolumeWords};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use proptest::prelude::*;

/// Side of the zones that are compared pixel by pixel.
pub const SIDE: i64 = 20;

/// The pixels of such a zone, line by line.
pub fn pixels() -> impl Iterator<Item = (i64, i64)> {
    (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)))
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
    if n == 0 {
        return vec![vec![]];
    }
    permutations(n - 1)
        .into_iter()
        .flat_map(|shorter| {
            (0..n).map(move |at| {
                let mut order = shorter.clone();
                order.insert(at, n - 1);
                order
            })
        })
        .collect()
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
    let depth = Linear::new(0, 0, depth);
    VolumeWords {
        kind,
        source,
        screen_box: ScreenBox::of([x0, x1], [0, 0]),
        margin,
        quadric: None,
        planes: vec![VolumePlane {
            kind: PlaneKind::Front,
            depth,
        }],
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
