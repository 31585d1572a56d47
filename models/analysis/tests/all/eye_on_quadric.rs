//! Objects whose depth is a quotient: the eye lies on them, or looks along an asymptotic direction; golden picture
//! against exact picture.

use crate::pictures::{Pictures, UNIT};
use imogene_algebra::rational::{fraction, integer};
use imogene_golden::format::Format;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END};
use imogene_prepare::error::PrepareError;
use imogene_prepare::{PreparedObject, PreparedParts, PreparedScene, prepare_for_roots};
use imogene_scene::{FramedQuadric, FramedScene, Quadric, Surface};
use imogene_testkit::*;
use num_rational::BigRational;
use proptest::prelude::*;

const D: i64 = 1000;

fn small(object: FramedQuadric) -> FramedScene {
    scene_of(64, 48, perspective(D), vec![object])
}

/// The quadric of these coefficients, its constant such that the eye, (0, 0, -D), lies on it.
fn through_eye([a, b, c, d, e, f, g, h, i]: [i64; 9]) -> Quadric {
    whole_quadric([a, b, c, d, e, f, g, h, i, 2 * i * D - c * D * D])
}

fn parts(prepared: &PreparedScene) -> &PreparedParts {
    match &prepared.objects[0] {
        PreparedObject::Parts(parts) => parts,
        _ => panic!("drawn by roots"),
    }
}

/// Faces are the exact ones but at edges, where rounding may decide otherwise, and depths of the quadric within their
/// bound; returns the pixels that show it.
fn check(pictures: &Pictures) -> Result<usize, String> {
    let other: Vec<usize> = pictures.differing().collect();
    let is_edge = |i: usize| {
        let mut around = pictures.around(i, 1);
        around.any(|other| pictures.exact_face(other) != pictures.exact_face(i))
    };
    // Of 64 x 48 pixels.
    if other.len() > 30 || !other.iter().all(|&i| is_edge(i)) {
        return Err(format!("pixels {other:?} differ"));
    }
    let bound = parts(&pictures.prepared).depth_bound.unwrap_or(0.0);
    let mut shown = 0;
    let faces = [FACE_NEAR, FACE_FAR];
    for (index, exact) in pictures.seen().filter(|(_, e)| faces.contains(&e.number)) {
        shown += 1;
        let off = pictures.depth_error(index, &exact).abs();
        // The exact depth is itself cut after its fraction bits.
        if off > bound + 2.0 / UNIT {
            return Err(format!("pixel {index}: off by {off}, bound {bound}"));
        }
    }
    Ok(shown)
}

/// The same, if the scene can be drawn and is by roots.
fn check_parts(scene: FramedScene) -> Result<(), TestCaseError> {
    match Pictures::of(scene, Format::BASE) {
        Ok(pictures) if matches!(pictures.prepared.objects[0], PreparedObject::Parts(_)) => {
            check(&pictures).map_err(TestCaseError::fail).map(drop)
        }
        Ok(_) | Err(PrepareError::SteepPlane { .. }) => Ok(()),
        Err(other) => Err(TestCaseError::fail(other.to_string())),
    }
}

fn coefficients() -> impl Strategy<Value = [i64; 9]> {
    let squares = prop::array::uniform6(-40i64..=40);
    let linear = prop::array::uniform3(-20_000i64..=20_000);
    (squares, linear).prop_map(|([a, b, c, d, e, f], [g, h, i])| [a, b, c, d, e, f, g, h, i])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    /// Patches with up to two planes.
    #[test]
    fn surfaces_are_drawn_as_they_are(
        q in coefficients(), planes in prop::collection::vec([-9i64..9, -9..9, -9..9, -2000..2000], 0..3)
    ) {
        let planes: Vec<[i64; 4]> = planes.into_iter().filter(|p| p[..3] != [0; 3]).collect();
        check_parts(small(object("sheet", Surface::Patch, through_eye(q), &planes)))?;
    }

    /// Solids whose part about the eye is cut away.
    #[test]
    fn solids_are_drawn_as_they_are(q in coefficients(), at in -400i64..300, slope in [-1i64..=1, -1..=1]) {
        // Kept where it is behind a plane before the eye: -(z - at) + slope <= 0.
        let cut = [[slope[0], slope[1], -10, 10 * at]];
        check_parts(small(object("block", Surface::Solid, through_eye(q), &cut)))?;
    }
}

/// The inner wall of a ball of radius D about the origin, on which the eye lies: `x^2 + y^2 + z^2 = D^2` is met again
/// at `z_p = (x^2 + y^2 - D^2) / (2 D) + D ..`; at the middle pixel at z = D, that is z_p = D / 2 exactly.
#[test]
fn the_far_wall_of_a_ball_is_half_way_to_infinity() {
    let ball = object("ball", Surface::Patch, sphere([0, 0, 0], D), &[]);
    for format in [16, 20, 24, 28, 32] {
        let format = Format::new(format).unwrap();
        let pictures = Pictures::of(small(ball.clone()), format).unwrap();
        assert_eq!(check(&pictures), Ok(64 * 48));
        let middle = 24 * 64 + 32;
        assert!((pictures.golden.depth[middle] - format.z_max() / 2).abs() <= 1);
        let parts = parts(&pictures.prepared);
        assert!(matches!(parts.words[0], ProcessorWords::Quotient(_)));
        // Room below the depth word: 12 bits of the denominator.
        assert!(parts.depth_bound.unwrap() < 1.1, "{:?}", parts.depth_bound);
        for (_, angle) in pictures.normal_errors() {
            assert!(angle < 0.05, "{angle} degrees");
        }
    }
}

/// A paraboloid along its axis: `z = (x^2 + y^2) / 100 - 100`, whole numbers of depth words times a constant, seen
/// from within.
#[test]
fn parallel_lines_along_an_asymptotic_direction() {
    let bowl = whole_quadric([1, 1, 0, 0, 0, 0, 0, 0, -50, -10_000]);
    let projection = parallel(500);
    for surface in [Surface::Patch, Surface::Solid] {
        let bowl = object("bowl", surface, bowl.clone(), &[]);
        let scene = scene_of(64, 48, projection.clone(), vec![bowl]);
        let pictures = Pictures::of(scene, Format::BASE).unwrap();
        assert_eq!(check(&pictures), Ok(64 * 48));
        let depth = |x: usize, y: usize| pictures.golden.depth[y * 64 + x] as f64;
        let scale = Format::BASE.z_max() as f64 / 500.0;
        for (x, y) in [(32, 24), (0, 0), (63, 10)] {
            let (u, v) = (x as f64 - 32.0, y as f64 - 24.0);
            let expected = ((u * u + v * v) / 100.0 - 100.0) * scale;
            assert!((depth(x, y) - expected).abs() <= 1.1);
        }
    }
}

#[test]
fn a_solid_on_which_the_eye_lies_is_open_at_the_near_end_and_machines_of_roots_alone_refuse_it() {
    let ball = |surface| object("ball", surface, sphere([0, 0, 0], D), &[]);
    let open = Pictures::of(small(ball(Surface::Solid)), Format::BASE).unwrap();
    assert_eq!(check(&open), Ok(0));
    assert!(open.golden.number.iter().all(|&face| face == FACE_NEAR_END));
    let scene = small(ball(Surface::Patch));
    let error = prepare_for_roots(&scene, Format::BASE).unwrap_err();
    assert!(matches!(error, PrepareError::ViewerOnSurface { .. }));
    let mut widths = Format::BASE.widths();
    widths.plane -= 1;
    let error = imogene_prepare::prepare(&scene, Format::fitted(&widths).unwrap()).unwrap_err();
    assert!(matches!(error, PrepareError::ViewerOnSurface { .. }));
}

/// The ball again, the eye off it by `off`: the quotient with a root in its denominator is right within its bound,
/// however near the eye is.
#[test]
fn the_eye_nearly_on_a_quadric() {
    let off_by = |off: BigRational| {
        let mut ball = sphere([0, 0, 0], D);
        ball.j = &ball.j - off * integer(2 * D);
        small(object("ball", Surface::Patch, ball, &[]))
    };
    let offs = [1, 1000, 1_000_000, 1_000_000_000_000].map(|n| [(-1, n), (1, n)]);
    for (sign, parts_of_one) in offs.into_iter().flatten() {
        let off = off_by(fraction(sign, parts_of_one));
        let pictures = Pictures::of(off.clone(), Format::BASE).unwrap();
        assert_eq!(check(&pictures), Ok(64 * 48));
        let parts = parts(&pictures.prepared);
        assert!(parts.notes.iter().any(|n| n.contains("so nearly")));
        assert!(parts.depth_bound.unwrap() < 1.1, "{:?}", parts.depth_bound);
        let error = prepare_for_roots(&off, Format::BASE).unwrap_err();
        assert!(matches!(error, PrepareError::TooLarge { .. }), "{error}");
    }
}
