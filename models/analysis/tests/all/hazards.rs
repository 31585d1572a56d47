//! Hazards of depth and shape: each test fails on the version that takes the source literally.

use imogene_algebra::rational::{fraction, integer};
use imogene_analysis::exact::ray::RayObject;
use imogene_golden::format::{Format, wrap64};
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::unit::cut_plane::{PlaneKind, cut};
use imogene_golden::unit::depth_interval::{Class, FACE_NEAR, FACE_NEAR_END, FACE_PLANE, Interval};
use imogene_golden::unit::root::fast_root;
use imogene_prepare::perspective::ScreenQuadric;
use imogene_scene::{FramedScene, Plane, Quadric, Surface, Transform};
use imogene_testkit::*;
use num_rational::BigRational;
use num_traits::Zero;

const F: Format = Format::BASE;

/// f1 and f2 at a pixel.
fn values(words: &QuadricWords, x: i64, y: i64) -> (i64, i64) {
    let f1 = words.f1.wrapped_at(x, y, F.sum);
    (f1 as i64, words.f2.wrapped_at(x, y, F.quadratic) as i64)
}

fn exact_number(scene: &FramedScene, x: i64, y: i64) -> Option<u8> {
    let ray = RayObject::new(framed(scene), scene);
    ray.first_hit(x, y).map(|hit| hit.number)
}

/// Planes through the middle of the screen in random directions: 37 % leave a 24-bit accumulator somewhere on the
/// screen (9.3), but none leaves the plane word on the box of the object it cuts.
#[test]
fn random_planes_wrap_a_depth_word_but_not_the_plane_word() {
    let mut random = Random(0x1234_5678_9abc);
    let samples = 3000;
    let mut wrapping = 0;
    for _ in 0..samples {
        let [a, b, c] = random.direction();
        let cut = [[a, b, c, 0]];
        let prepared = prepare(&scene(vec![ball([0, 0, 0], 40, &cut)]));
        let object = first(&prepared);
        let plane = &object.words.planes[0];
        let corners = [(0, 0), (719, 0), (0, 539), (719, 539)];
        let leaves = |bits: u32, (x, y)| {
            let exact = plane.depth.exact_at(x, y);
            exact != plane.depth.wrapped_at(x, y, bits).into()
        };
        wrapping += usize::from(corners.iter().any(|&p| leaves(24, p)));
        let ScreenBox { x0, x1, y0, y1 } = object.words.screen_box;
        let mut own = [(x0, y0), (x1, y0), (x0, y1), (x1, y1)].into_iter();
        assert!(own.all(|p| !leaves(F.plane, p)));
        assert!(object.needed.plane <= F.plane);
    }
    let percent = 100.0 * wrapping as f64 / f64::from(samples);
    println!("{percent:.1} % of random planes wrap a 24-bit accumulator");
    assert!((35.0..39.5).contains(&percent), "{percent} %");
}

/// The near root of a ball that comes close to the viewer lies beyond -2^24: three of the four quadrants of the sum
/// word.
#[test]
fn depth_sums_need_two_more_bits_than_the_depth() {
    let prepared = prepare(&scene(vec![ball([0, 0, -451], 290, &[])]));
    let object = first(&prepared);
    let (f1, f2) = values(&object.words, 360, 270);
    let near = f1 - fast_root(f2);
    assert!(near < -(1 << 24), "near root {near}");
    assert_eq!(object.needed.sum, F.sum);
    assert_eq!(wrap64(near, F.sum), near);
    for naive in [24, 25] {
        assert_ne!(wrap64(near, naive), near, "{naive} bits lose the near root");
    }
    // On 25 bits it comes back far behind the near end and the ball would seem to begin there.
    assert!(wrap64(near, 25) > F.z_low());
    let pixel = golden_at(&object.words, 360, 270).expect("the viewer looks at the ball");
    assert_eq!((pixel.zf, pixel.number), (F.z_low(), FACE_NEAR_END));
}

fn room(planes: &[[i64; 4]]) -> FramedScene {
    // x^2/1000^2 + y^2/1000^2 + (z + 1650)^2/1350^2 = 1, from z = -3000 to z = -300 around the eye at z = -1000.
    let wall = centred([729, 729, 400], [0, 0, -1650], 729_000_000);
    scene(vec![object("room", Surface::Patch, wall, planes)])
}

#[test]
fn from_inside_a_patch_the_inner_wall_is_seen_and_nothing_behind_the_viewer() {
    let scene = room(&[]);
    let words = &first(&prepare(&scene)).words.clone();
    assert_eq!(golden_pixels(words), (WIDTH * HEIGHT) as usize);
    for (x, y) in [(0, 0), (360, 270), (719, 539), (100, 400)] {
        let (f1, f2) = values(words, x, y);
        let far = f1 + fast_root(f2);
        assert!(far > F.z_max(), "the other root lies behind the viewer");
        let pixel = golden_at(words, x, y).expect("covered");
        assert_eq!((pixel.zf, pixel.number), (f1 - fast_root(f2), FACE_NEAR));
        assert_eq!(pixel.zb, pixel.zf, "the ghost is no back face either");
        assert_eq!(exact_number(&scene, x, y), Some(FACE_NEAR));
    }
}

/// Where a front plane removes the wall before the viewer, the naive chain goes on with the root behind him.
#[test]
fn a_cut_wall_does_not_show_the_ghost_behind_the_viewer() {
    let scene = room(&[[0, 0, -1, -310]]);
    let words = &first(&prepare(&scene)).words.clone();
    let plane = &words.planes[0];
    assert_eq!(plane.kind, PlaneKind::Front);
    let naive = |x, y| {
        let (f1, f2) = values(words, x, y);
        let r = fast_root(f2);
        let both = Interval::new((f1 - r, 0), (f1 + r, 1));
        let depth = plane.depth.wrapped_at(x, y, F.plane) as i64;
        cut(both, plane.kind, depth, FACE_PLANE, true, &F)
    };
    // The middle of the wall lies behind the plane.
    assert!(golden_at(words, 360, 270).is_some());
    let ScreenBox { x0, x1, y0, y1 } = words.screen_box;
    for (x, y) in [(x0, y0), (x1, y1), (x0, y1), (x1, y0)] {
        let ghost = naive(x, y);
        // The naive chain sees a ghost.
        assert!(ghost.is_present(&F) && ghost.zf > F.z_max());
        assert!(golden_at(words, x, y).is_none());
        assert_eq!(exact_number(&scene, x, y), None);
    }
}

/// x^2 + y^2 - z^2 = 1 seen along z and capped at -zc and zc: where f2 < 0 the whole line is inside. The naive rule
/// drills a hole of 1 / (1 + zc^2) of the cap.
#[test]
fn seen_from_inside_the_cap_has_no_hole_where_f2_is_negative() {
    let unit = 60;
    for (zc, loss_percent) in [(1, 50.0), (2, 20.0), (3, 10.0)] {
        let cuts = [[0, 0, -1, -unit * zc], [0, 0, 1, -unit * zc]];
        let quadric = centred([1, 1, -1], [0, 0, 0], unit * unit);
        let projection = parallel(1000);
        let cap = object("cap", Surface::Solid, quadric, &cuts);
        let scene = scene_of(WIDTH, HEIGHT, projection, vec![cap]);
        let words = &first(&prepare(&scene)).words.clone();
        assert_eq!(words.class, Class::Front);
        let radius = unit * unit * (1 + zc * zc);
        let (mut cap, mut hole) = (0, 0);
        for (x, y) in ScreenBox::of_screen(WIDTH, HEIGHT).each() {
            let (u, v) = (x - 360, y - 270);
            let (_, f2) = values(words, x, y);
            if u * u + v * v < radius {
                cap += 1;
                hole += usize::from(f2 < 0);
            }
        }
        let inside = golden_pixels(words);
        let percent = 100.0 * hole as f64 / f64::from(cap);
        println!("zc = {zc}: the naive rule loses {percent:.2} % of the cap");
        assert!((percent - loss_percent).abs() < 0.2);
        // The rim itself has zero thickness; only there may the count differ.
        let more = inside as i64 - i64::from(cap);
        assert!((0..60).contains(&more), "{more} of {cap} pixels");
        let middle = golden_at(words, 360, 270).expect("the middle of the cap");
        assert_eq!(middle.number, FACE_PLANE);
    }
}

fn tilted() -> Quadric {
    whole_quadric([3, 2, 5, 1, -1, 2, -40, 17, -900, 21_000])
}

/// `(z - f1)^2 - f2` is `Q' / c'`, coefficient by coefficient; with f1 twice and f2 four times as large (as printed) it
/// is not.
#[test]
fn the_depth_solves_the_quadric_and_the_printed_factors_do_not() {
    let screen = ScreenQuadric::new(&tilted(), &fraction(1, 1000));
    let q = &screen.q;
    let two = integer(2);
    let [d, g, h] = [&q.d, &q.g, &q.h].map(|v| &two * v);
    let of_quadric = [&q.a, &q.b, &d, &g, &h, &q.j].map(|v| v / &q.c);
    let z_terms = [&q.e, &q.f, &q.i].map(|v| v / &q.c);
    let solves = |k: i64| {
        let f1 = screen.f1().scaled(&integer(k));
        let f2 = screen.f2().scaled(&integer(k * k));
        let linear = f1.factors();
        let [a, b, c] = &linear;
        let squared = [
            a * a,
            b * b,
            &two * a * b,
            &two * a * c,
            &two * b * c,
            c * c,
        ];
        let constant = squared.into_iter().zip(f2.factors()).map(|(s, f)| s - f);
        let linear = linear.map(|v| -v);
        constant.eq(of_quadric.clone()) && linear == z_terms
    };
    assert!(solves(1));
    assert!(!solves(2));
    // On the axis of a ball the root is rational: the printed factors give twice the depth, off the ball.
    let ball = ScreenQuadric::new(&sphere([0, 0, 300], 100), &fraction(1, 1000));
    let zero = BigRational::zero;
    let near = fraction(1000 * 200, 1200);
    let f1 = ball.f1().at(&zero(), &zero());
    assert_eq!((&f1 - &near).pow(2), ball.f2().at(&zero(), &zero()));
    assert!(ball.q.value_at(&zero(), &zero(), &near).is_zero());
    assert!(!ball.q.value_at(&zero(), &zero(), &(&near * &two)).is_zero());
}

/// f1 - r is the nearer root whatever the sign of c'; the source's text has them reversed.
#[test]
fn the_near_root_is_the_one_with_the_minus_sign() {
    let ball = object("ball", Surface::Patch, sphere([20, -10, 300], 100), &[]);
    let ball = scene(vec![ball]);
    for scene in [ball, room(&[])] {
        let words = &first(&prepare(&scene)).words.clone();
        let (f1, f2) = values(words, 365, 268);
        let pixel = golden_at(words, 365, 268).expect("covered");
        assert_eq!(exact_number(&scene, 365, 268), Some(FACE_NEAR));
        assert_eq!(pixel.zf, f1 - fast_root(f2));
        assert!(f1 + fast_root(f2) > pixel.zf);
    }
}

/// Far from a ball f2 passes -2^47 and the word turns positive: only the screen box keeps the ball from showing there
/// again.
#[test]
fn the_screen_box_hides_the_wrapped_discriminant() {
    let projection = perspective(200);
    let scene = scene_of(WIDTH, HEIGHT, projection, vec![ball([0, 0, 0], 30, &[])]);
    let words = &first(&prepare(&scene)).words.clone();
    let (x, y) = (360 + 300, 270);
    assert!(words.f2.exact_at(x, y) < (-(1i64 << 47)).into());
    assert!(values(words, x, y).1 > 0, "the word has the wrong sign");
    let near = (360 + 275, 270);
    // Within sqrt(2) D of the centre the sign is right.
    assert!(values(words, near.0, near.1).1 < 0);
    let mut naive = words.clone();
    naive.screen_box = ScreenBox::of([0, 719], [0, 539]);
    let ghosts = golden_pixels(&naive) - golden_pixels(words);
    println!("{ghosts} ghost pixels without the screen box");
    assert!(ghosts > 1000);
    assert!(golden_at(words, x, y).is_none());
}

fn half_ball(planes: Vec<Plane>) -> QuadricWords {
    let mut half = object("half", Surface::Solid, sphere([0, 0, 300], 100), &[]);
    half.planes = planes;
    first(&prepare(&scene(vec![half]))).words.clone()
}

/// A mirror exchanges left and right, not the kept and the removed side.
#[test]
fn a_mirrored_cut_keeps_the_mirrored_half() {
    let mirror = Transform::scaling([integer(-1), integer(1), integer(1)]);
    for left_half in [plane([1, 0, 0, 0]), plane([3, 0, 1, -300])] {
        let seen = half_ball(vec![left_half.clone()]);
        let mirrored = half_ball(vec![left_half.transformed(&mirror)]);
        let [a, b, c, d] = left_half.transformed(&mirror).coefficients().map(|v| -v);
        let naive = half_ball(vec![Plane { a, b, c, d }]);
        let front = |words: &QuadricWords, x| golden_at(words, x, 270).map(|p| (p.zf, p.number));
        let agrees =
            |words: &QuadricWords| (300..420).all(|x| front(words, x) == front(&seen, 720 - x));
        assert!(agrees(&mirrored), "mirrored pixel by pixel");
        // cof(M) p without the sign of det(M) keeps the other half.
        assert!(!agrees(&naive));
    }
}

#[test]
fn a_plane_through_the_eye_is_a_half_plane_and_keeps_its_own_pixels() {
    let words = half_ball(vec![plane([1, 0, 0, 0])]);
    assert_eq!(words.planes[0].kind, PlaneKind::Perpendicular);
    let seen = [359, 360, 361].map(|x| golden_at(&words, x, 270).is_some());
    assert_eq!(seen, [true, true, false]);
}

/// x <= 0.01 passes 0.01 pixels beside the eye: its depth leaves the plane word, but its half-plane form is proven.
#[test]
fn a_plane_nearly_through_the_eye_is_taken_as_a_half_plane_by_proof() {
    let scene = scene(vec![ball([0, 0, 300], 100, &[[100, 0, 0, -1]])]);
    let prepared = prepare(&scene);
    let object = first(&prepared);
    assert_eq!(object.words.planes[0].kind, PlaneKind::Perpendicular);
    let notes = &object.notes;
    assert!(notes.iter().any(|n| n.contains("steep")), "{notes:?}");
    // A depth that takes the place of the half-plane would need more bits than the plane word has.
    let slope = fraction(1_000 * 100, 1) * integer(F.z_max()) / integer(1000);
    assert!(slope * integer(70) > integer(1 << (F.plane - 1)));
    for x in 340..380 {
        let drawn = golden_at(&object.words, x, 270).is_some();
        assert_eq!(drawn, exact_number(&scene, x, 270).is_some());
    }
}
