//! The golden vectors of the restated specification (4.3 sphere, 6.7 cut cylinder), through the real preparation.

use imogene_algebra::rational::{fraction, from_f64_exact, integer};
use imogene_analysis::bounds::depth_bound;
use imogene_analysis::exact::ray::RayObject;
use imogene_golden::format::{Format, wrap64};
use imogene_golden::object::quadric::QuadricWords;
use imogene_golden::unit::cut_plane::{PlaneKind, cut};
use imogene_golden::unit::depth_interval::{FACE_PLANE, Interval, halves};
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use imogene_golden::unit::root::restoring_root;
use imogene_prepare::PreparedQuadric;
use imogene_prepare::perspective::ScreenQuadric;
use imogene_scene::{FramedScene, Surface};
use imogene_testkit::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

fn cut_cylinder(surface: Surface) -> FramedScene {
    let planes = [[0, 0, -1, 250], [0, 1, 0, -80], [0, -1, 0, -80]];
    let cylinder = centred([1, 0, 1], [0, 0, 300], 10_000);
    scene(vec![object("cylinder", surface, cylinder, &planes)])
}

fn sphere_scene() -> FramedScene {
    scene(vec![ball([20, -10, 300], 100, &[])])
}

fn words_of(scene: &FramedScene) -> QuadricWords {
    first(&prepare_at_origin(scene)).words.clone()
}

fn radicand_at(words: &QuadricWords, x: i64, y: i64) -> i64 {
    words.f2.wrapped_at(x, y, Format::BASE.quadratic) as i64
}

fn root_at(words: &QuadricWords, x: i64, y: i64) -> i64 {
    restoring_root(radicand_at(words, x, y) as u128, Format::BASE.root).root as i64
}

/// Front depth, back depth and front face number.
type Faces = (i64, i64, u8);

/// One row of table 6.7: pixel, root (nothing where f2 < 0), plane depths before saturation, volume, patch.
type Row = (
    (i64, i64),
    Option<i64>,
    [i64; 3],
    Option<Faces>,
    Option<(i64, u8)>,
);

const MIDDLE: [i64; 3] = [1_677_721, 8_388_496, 8_388_718];
#[rustfmt::skip]
const CYLINDER_ROWS: [Row; 7] = [
    ((360, 270), Some(499_321), MIDDLE, Some((1_677_721, 2_396_744, 2)), Some((2_396_744, 1))),
    ((400, 270), Some(426_971), MIDDLE, Some((1_677_721, 2_324_394, 2)), Some((2_324_394, 1))),
    ((360, 330), Some(499_321), [1_677_721, 2_097_016, 14_680_198], Some((1_677_721, 2_097_016, 2)), None),
    ((360, 337), Some(499_321), [1_677_721, 1_363_010, 15_414_204], None, None),
    ((430, 270), Some(209_952), MIDDLE, Some((1_687_471, 2_107_375, 0)), Some((1_687_471, 0))),
    ((435, 270), Some(117_101), MIDDLE, Some((1_780_322, 2_014_524, 0)), Some((1_780_322, 0))),
    ((440, 270), None, MIDDLE, None, None),
];

#[test]
fn cylinder_words() {
    let words = words_of(&cut_cylinder(Surface::Solid));
    assert_eq!(words.f1, Linear::new(0, 0, 1_897_423));
    let f2 = Quadratic::new([-41_886_147, 0, 0, 30_158_026_029, 0, -5_179_122_380_046]);
    assert_eq!(words.f2, f2);
    let planes: Vec<_> = words.planes.iter().map(|p| (p.kind, p.depth)).collect();
    let expected = [
        (PlaneKind::Front, Linear::new(0, 0, 1_677_721)),
        (PlaneKind::Back, Linear::new(0, -104_858, 36_700_156)),
        (PlaneKind::Back, Linear::new(0, 104_858, -19_922_942)),
    ];
    assert_eq!(planes, expected);
}

#[test]
fn cylinder_pixels_of_volume_and_patch() {
    let volume = words_of(&cut_cylinder(Surface::Solid));
    let patch = words_of(&cut_cylinder(Surface::Patch));
    for ((x, y), root, depths, solid, face) in CYLINDER_ROWS {
        match root {
            Some(root) => assert_eq!(root_at(&volume, x, y), root, "root at ({x}, {y})"),
            None => assert_eq!(radicand_at(&volume, x, y), -18_748_986_486),
        }
        let wide =
            [0, 1, 2].map(|i| volume.planes[i].depth.wrapped_at(x, y, Format::BASE.plane) as i64);
        assert_eq!(wide, depths, "plane words at ({x}, {y})");
        let seen = golden_at(&volume, x, y).map(|p| (p.zf, p.zb, p.number));
        assert_eq!(seen, solid, "volume at ({x}, {y})");
        let seen = golden_at(&patch, x, y).map(|p| (p.zf, p.number));
        assert_eq!(seen, face, "patch at ({x}, {y})");
    }
}

/// The back faces of the table's volume column, which the processor does not hand on as a number.
#[test]
fn cylinder_back_faces() {
    let words = words_of(&cut_cylinder(Surface::Solid));
    for ((x, y), back) in [((360, 270), 1), ((360, 330), 3), ((430, 270), 1)] {
        let merged = chain(&words, x, y, Format::BASE.plane);
        assert_eq!(merged.nb, back, "back face at ({x}, {y})");
    }
}

/// Half A after all planes, with plane depths from an accumulator of `width` bits: 24 is the naive machine.
fn chain(words: &QuadricWords, x: i64, y: i64, width: u32) -> Interval {
    let format = Format::BASE;
    let f1 = words.f1.wrapped_at(x, y, format.sum) as i64;
    let f2 = radicand_at(words, x, y);
    let r = if f2 < 0 { 0 } else { root_at(words, x, y) };
    let start = halves(words.class, f1 - r, f1 + r, f2 < 0, &format).0;
    let planes = words.planes.iter().enumerate();
    planes.fold(start, |state, (i, plane)| {
        let zp = wrap64(plane.depth.wrapped_at(x, y, 64) as i64, width);
        cut(state, plane.kind, zp, FACE_PLANE + i as u8, false, &format)
    })
}

#[test]
fn a_plane_accumulator_of_24_bits_loses_the_cylinder_at_the_screen_centre() {
    let words = words_of(&cut_cylinder(Surface::Solid));
    assert_eq!(words.planes[2].depth.wrapped_at(360, 270, 24), -8_388_498);
    assert!(!chain(&words, 360, 270, 24).is_present(&Format::BASE));
    let whole_line = (260..=460).all(|x| !chain(&words, x, 270, 24).is_present(&Format::BASE));
    // The naive machine keeps nothing of the line through the centre.
    assert!(whole_line);
    assert!(chain(&words, 360, 270, Format::BASE.plane).is_present(&Format::BASE));
    assert!(golden_at(&words, 360, 270).is_some());
}

#[test]
fn sphere_after_perspective() {
    let screen = ScreenQuadric::new(&sphere([20, -10, 300], 100), &fraction(1, 1000));
    // In 2000ths.
    let expected = [
        2000,
        2000,
        3361,
        0,
        40,
        -20,
        -40_000,
        20_000,
        -761_000,
        161_000_000,
    ];
    let expected = expected.map(|n| fraction(n, 2000));
    assert_eq!(screen.q.coefficients(), expected.each_ref());
}

/// Pixel; then f1, f2, root, front and back depth.
#[rustfmt::skip]
const SPHERE_ROWS: [((i64, i64), [i64; 5]); 4] = [
    ((375, 262), [1_897_417, 249_235_747_241, 499_235, 1_398_182, 2_396_652]),
    ((375, 200), [1_894_317, 86_922_767_447, 294_826, 1_599_491, 2_189_143]),
    ((300, 262), [1_904_917, 10_761_878_741, 103_739, 1_801_178, 2_008_656]),
    ((450, 262), [1_889_917, 16_742_788_241, 129_393, 1_760_524, 2_019_310]),
];

#[test]
fn sphere_words_and_pixels() {
    let words = words_of(&sphere_scene());
    assert_eq!(words.f1, Linear::new(-100, 50, 1_921_817));
    let f2 = Quadratic::new([
        -41_863_718,
        -41_871_193,
        -9_967,
        31_440_272_584,
        21_966_180_078,
        -8_533_734_878_403,
    ]);
    assert_eq!(words.f2, f2);
    for ((x, y), [f1, f2, root, zf, zb]) in SPHERE_ROWS {
        assert_eq!(words.f1.wrapped_at(x, y, Format::BASE.sum) as i64, f1);
        assert_eq!(radicand_at(&words, x, y), f2);
        assert_eq!(root_at(&words, x, y), root);
        let pixel = golden_at(&words, x, y).expect("inside the sphere");
        assert_eq!((pixel.zf, pixel.zb, pixel.number), (zf, zb, 0));
    }
}

/// The exact front depth in depth words, from the reference that solves the ray.
fn exact_front(scene: &FramedScene, x: i64, y: i64) -> f64 {
    let ray = RayObject::new(framed(scene), scene);
    let full = BigInt::from(Format::BASE.z_max());
    let hit = ray.first_hit(x, y).expect("the object is seen here");
    let fixed = hit.w.fixed(&full, &full, 20);
    let fixed: i64 = fixed.try_into().expect("a visible depth");
    fixed as f64 / f64::from(1 << 20)
}

fn assert_within_bounds(scene: &FramedScene, object: &PreparedQuadric, x: i64, y: i64) {
    let (px, py) = (integer(x), integer(y));
    let holds = |computed: BigInt, exact: BigRational, bound: f64| {
        let off = (BigRational::from_integer(computed) - exact).abs();
        assert!(off <= from_f64_exact(bound), "({x}, {y})");
    };
    let (words, exact, bounds) = (&object.words, &object.exact, &object.bounds);
    if !words.screen_box.contains(x, y) {
        // The bounds are those of the box.
        assert!(golden_at(words, x, y).is_none());
        return;
    }
    holds(words.f1.exact_at(x, y), exact.f1.at(&px, &py), bounds.f1);
    holds(words.f2.exact_at(x, y), exact.f2.at(&px, &py), bounds.f2);
    for (i, plane) in words.planes.iter().enumerate() {
        let value = exact.planes[i].at(&px, &py);
        holds(plane.depth.exact_at(x, y), value, bounds.planes[i]);
    }
    if let Some(pixel) = golden_at(&object.words, x, y) {
        let bound = depth_bound(object, pixel.number, radicand_at(words, x, y));
        let off = (pixel.zf as f64 - exact_front(scene, x, y)).abs();
        let most = bound + 1e-5;
        assert!(off <= most, "({x}, {y}): {off} beyond {bound}");
    }
}

#[test]
fn rounding_about_the_box_centre_stays_within_the_stated_bounds() {
    for surface in [Surface::Solid, Surface::Patch] {
        let scene = cut_cylinder(surface);
        let prepared = prepare(&scene);
        for ((x, y), ..) in CYLINDER_ROWS.iter().take(6) {
            assert_within_bounds(&scene, first(&prepared), *x, *y);
        }
    }
    let scene = sphere_scene();
    let prepared = prepare(&scene);
    for ((x, y), ..) in SPHERE_ROWS {
        assert_within_bounds(&scene, first(&prepared), x, y);
    }
}
