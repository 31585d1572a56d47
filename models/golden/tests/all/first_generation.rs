//! The first generation against exact cuts and against the second.

use crate::common::*;
use imogene_golden::object::first_generation::{ContourPlane, FirstGenerationWords, latency};
use imogene_golden::unit::depth_interval::FACE_NEAR_END;
use num_bigint::BigInt;
use num_traits::Signed;

const SIDE: i64 = 18;
const F: Format = Format::BASE;

/// The words of a plane of depth `depth` that cuts the quadric `f1 -+ sqrt(f2)`, in the units of the depths: conic
/// `f2 - (depth - f1)^2`, and line `depth - f1` times the sign, which is negative for the front plane.
fn contours(
    depth: Linear,
    f1: &Linear,
    f2: &Quadratic,
    sign: i128,
    normal: [i16; 3],
) -> ContourPlane {
    let (p, q, r) = (depth.a - f1.a, depth.b - f1.b, depth.c - f1.c);
    ContourPlane {
        depth,
        conic: Quadratic::new([
            f2.a - p * p,
            f2.b - q * q,
            f2.c - 2 * p * q,
            f2.d - 2 * p * r,
            f2.e - 2 * q * r,
            f2.f - r * r,
        ]),
        polar: Linear::new(sign * p, sign * q, sign * r),
        normal,
    }
}

/// A quadric of integer words, two parallel planes `thickness` apart, and the same for the second generation.
fn object(
    f1: Linear,
    f2: Quadratic,
    front: Linear,
    thickness: i128,
    patch: bool,
) -> (FirstGenerationWords, QuadricWords) {
    let back = Linear::new(front.a, front.b, front.c + thickness);
    let screen_box = ScreenBox::of([0, SIDE - 1], [1, SIDE - 1]);
    let g = [[9000, -70, 40], [-3, 8000, 1 << 18], [1, 2, -(1 << 22)]];
    let g = g.map(|[a, b, c]| Linear::new(a, b, c));
    let (k, shift) = ([900, -4000, 31_000], 0);
    let normal = NormalWords { g, k, shift };
    let normals = [[1, -2, -300], [-1, 2, 300]];
    let first = FirstGenerationWords {
        patch,
        screen_box,
        f1,
        f2,
        normal,
        front: contours(front, &f1, &f2, -1, normals[0]),
        back: contours(back, &f1, &f2, 1, normals[1]),
    };
    let second = QuadricWords {
        class: if patch { Class::Patch } else { Class::Side },
        screen_box,
        f1,
        f2,
        normal,
        planes: vec![
            PlaneWords::new(PlaneKind::Front, front, normals[0]),
            PlaneWords::new(PlaneKind::Back, back, normals[1]),
        ],
    };
    (first, second)
}

fn both(
    first: &FirstGenerationWords,
    second: &QuadricWords,
    mut visit: impl FnMut(i64, i64, ObjectPixel, ObjectPixel),
) {
    for (x, y) in square(SIDE) {
        visit(x, y, first.at(x, y, &F), second.at(x, y, &F));
    }
}

/// Which faces a patch keeps: exact comparisons of the roots with the planes, closed as in the second generation, or
/// open as the conics have it.
fn faces_exact(words: &FirstGenerationWords, x: i64, y: i64, closed: bool) -> [bool; 2] {
    let f2 = words.f2.exact_at(x, y);
    let middle = words.f1.exact_at(x, y);
    let [front, back] = [&words.front, &words.back].map(|p| p.depth.exact_at(x, y) - &middle);
    // z against -+ sqrt(f2): d <= sqrt(f2), < if open.
    let at_most_root =
        |d: &BigInt, closed: bool| d.is_negative() || d * d < f2 || (closed && d * d == f2);
    let root_at_most = |d: &BigInt, closed: bool| !at_most_root(d, !closed);
    let [minus_front, minus_back] = [-&front, -&back];
    [
        // front <= -root, -root <= back
        root_at_most(&minus_front, closed) && at_most_root(&minus_back, true),
        // front <= root, root <= back
        at_most_root(&front, true) && root_at_most(&back, closed),
    ]
}

fn slope() -> impl Strategy<Value = i128> {
    -12i128..=12
}

fn parts() -> impl Strategy<Value = (Linear, Quadratic, Linear, i128)> {
    let linear = || (slope(), slope(), -80i128..=80).prop_map(|(a, b, c)| Linear::new(a, b, c));
    let quadratic = (-60i128..=25, -60i128..=25, -30i128..=30, 0i128..6000);
    (linear(), quadratic, linear(), 0i128..200).prop_map(|(f1, (a, b, c, f), front, thickness)| {
        let f2 = Quadratic::new([a, b, c, i128::from(-SIDE) * a, i128::from(-SIDE) * b, f]);
        (f1, f2, front, thickness)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    /// A solid is the second generation's, bit for bit: depths, and face and normal but where two faces have the same
    /// depth.
    #[test]
    fn solid_equals_the_second_generation((f1, f2, front, thickness) in parts()) {
        let (first, second) = object(f1, f2, front, thickness, false);
        let mut wrong = None;
        both(&first, &second, |x, y, ours, theirs| {
            let depths = (ours.zf, ours.zb) == (theirs.zf, theirs.zb);
            let tie = ours.zf == front.wrapped_at(x, y, 64) as i64;
            if !depths || (ours != theirs && !tie) {
                wrong = Some((x, y, ours, theirs));
            }
        });
        prop_assert_eq!(wrong, None);
    }

    /// A patch keeps exactly the faces that are strictly inside: compared as roots, not as the integers below them.
    #[test]
    fn patch_keeps_what_is_exactly_inside((f1, f2, front, thickness) in parts()) {
        let (first, second) = object(f1, f2, front, thickness, true);
        let mut wrong = None;
        both(&first, &second, |x, y, ours, theirs| {
            let there = y > 0 && !first.f2.exact_at(x, y).is_negative();
            let present = ours.zf != F.z_max();
            let [near, far] = faces_exact(&first, x, y, false).map(|face| face && there);
            let root = first.f2.exact_at(x, y).max(BigInt::ZERO).sqrt();
            let depth = first.f1.exact_at(x, y) + if near { -root.clone() } else { root.clone() };
            // A face exactly in a plane: the conic's border belongs to the conic, so the face is gone, and the patch is
            // open there.
            let right = present == (near || far) && (!present || depth == BigInt::from(ours.zf));
            // The second generation compares the integers, so it may differ only where a plane stands at one.
            let middle = first.f1.exact_at(x, y);
            let mut both = [&first.front, &first.back].into_iter();
            let tie = both.any(|p| (p.depth.exact_at(x, y) - &middle).abs() == root);
            if !right || (ours != theirs && !tie) {
                wrong = Some((x, y, ours, theirs));
            }
        });
        prop_assert_eq!(wrong, None);
    }
}

/// One object on which every face is seen.
#[test]
fn an_ellipsoid_between_two_planes() {
    let f2 = Quadratic::new([-60, -60, 0, 1080, 1080, -4860]);
    let f1 = Linear::new(2, 0, 0);
    let count = |front: Linear, thickness: i128, patch: bool| {
        let (first, second) = object(f1, f2, front, thickness, patch);
        let mut numbers = [0u32; 5];
        both(&first, &second, |_, _, ours, _| {
            let absent = ours.zf == F.z_max();
            let seen = if absent { 4 } else { usize::from(ours.number) };
            numbers[seen] += 1;
        });
        numbers
    };
    let cut = count(Linear::new(2, 0, -40), 60, false);
    let shows_ends = cut[0] > 0 && cut[2] > 0 && cut[1] == 0 && cut[3] == 0;
    assert!(shows_ends, "{cut:?}");
    let hollow = count(Linear::new(2, 0, -40), 200, true);
    let shows_both = hollow[0] > 0 && hollow[1] > 0 && hollow[2] == 0;
    assert!(shows_both, "{hollow:?}");
    // The back face is cut away wherever the front face is, and further out: a ring around a hole.
    let tube = count(Linear::new(2, 0, -40), 60, true);
    let shows_one = tube[0] > 0 && tube[1] == 0 && tube[4] > hollow[4];
    assert!(shows_one, "{tube:?}");
    let before = count(Linear::new(2, 0, 100), 60, false);
    assert_eq!(before, [0, 0, 0, 0, (SIDE * SIDE) as u32]);
}

#[test]
fn a_solid_that_reaches_nearer_than_the_near_end_is_capped() {
    let f1 = Linear::new(0, 0, i128::from(F.z_low()));
    let f2 = Quadratic::new([0, 0, 0, 0, 0, 10_000]);
    let (first, second) = object(f1, f2, Linear::new(0, 0, f1.c - 50), 100, false);
    both(&first, &second, |_, y, ours, theirs| {
        assert_eq!(ours, theirs);
        assert_eq!(ours.number == FACE_NEAR_END, y > 0);
    });
}

#[test]
fn two_planes_without_a_chain() {
    assert_eq!(latency(&F, 1), 33);
}
