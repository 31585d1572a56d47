//! Sphere and cylinder by paraboloids: exact outlines, and the errors of depth that the source accepts.

use imogene_algebra::rational::{fraction, integer, power_of_two, to_f64};
use imogene_algebra::whole::primitive;
use imogene_golden::format::Format;
use imogene_golden::object::cylinder::{CylinderWords, FACE_DISC};
use imogene_golden::object::paraboloid::{depth_guard, normal_guard, plane_guard};
use imogene_golden::object::quadric::{ObjectPixel, ScreenBox};
use imogene_golden::object::sphere::SphereWords;
use imogene_golden::object::words::Object;
use imogene_golden::unit::normal::LINEAR_WIDTH;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use imogene_prepare::forms::{LinearForm, QuadraticForm};
use imogene_prepare::rounding::{Anchor, round_linear, round_quadratic};
use imogene_prepare::shapes::{CylinderShape, SphereShape};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

/// In units of `2^-guard`, half a unit of the result added.
fn second_degree(exact: &QuadraticForm, guard: u32) -> Quadratic {
    let scaled = exact.scaled(&power_of_two(guard));
    round_quadratic(&scaled.raised(&integer(1 << guard >> 1)), Anchor::ORIGIN).unwrap()
}

/// The same of three coefficients.
fn first_degree(exact: &LinearForm, guard: u32) -> Linear {
    let scaled = exact.scaled(&power_of_two(guard));
    round_linear(&scaled.raised(&integer(1 << guard >> 1)), Anchor::ORIGIN).unwrap()
}

/// Whole numbers without a common divisor: the sign is exact.
fn contour(exact: &QuadraticForm) -> Quadratic {
    let whole = QuadraticForm::of_array(primitive(exact.factors()));
    round_quadratic(&whole, Anchor::ORIGIN).unwrap()
}

fn sphere_words(shape: &SphereShape, screen_box: ScreenBox, format: &Format) -> SphereWords {
    let across = |exact| first_degree(&exact, LINEAR_WIDTH - format.normal);
    SphereWords {
        screen_box,
        contour: contour(&shape.outline()),
        front: second_degree(&shape.paraboloid(), depth_guard(format)),
        sum: (integer(2) * &shape.z).round().to_i64().unwrap(),
        normal: shape.normal_across().map(across),
        normal_z: second_degree(&shape.normal_deep(), normal_guard(format)),
    }
}

fn cylinder_words(shape: &CylinderShape, screen_box: ScreenBox, format: &Format) -> CylinderWords {
    let side = |exact: LinearForm| {
        let whole = LinearForm::of_array(primitive(exact.factors()));
        round_linear(&whole, Anchor::ORIGIN).unwrap()
    };
    let normal = |exact| second_degree(&exact, normal_guard(format));
    CylinderWords {
        screen_box,
        sides: shape.sides().map(side),
        discs: shape.discs().each_ref().map(contour),
        body: second_degree(&shape.body(), depth_guard(format)),
        normal: shape.body_normal().map(normal),
        disc: first_degree(&shape.disc(), plane_guard(format)),
        disc_normal: shape.disc_normal(),
    }
}

/// The pixels of a square, line by line.
fn square(side: i64) -> impl Iterator<Item = (i64, i64)> {
    (0..side).flat_map(move |y| (0..side).map(move |x| (x, y)))
}

/// Value of an exact expression at a pixel.
fn value_at(exact: &QuadraticForm, x: i64, y: i64) -> BigRational {
    exact.at(&integer(x), &integer(y))
}

/// Half a count of the result, and what rounding six coefficients to `2^-guard` can do at a pixel.
fn rounding_bound(x: i64, y: i64, guard: u32) -> BigRational {
    let counts = x * x + y * y + x * y + x + y + 1;
    fraction(1, 2) + fraction(counts, 2 << guard)
}

/// The same of three coefficients.
fn linear_bound(x: i64, y: i64, guard: u32) -> BigRational {
    fraction(1, 2) + fraction(x + y + 1, 2 << guard)
}

fn screen(width: i64, height: i64) -> ScreenBox {
    ScreenBox::of([0, width - 1], [0, height - 1])
}

fn shape(x: BigRational, y: BigRational, radius: BigRational) -> SphereShape {
    let (z, scale) = (integer(300_001), integer(8192));
    SphereShape {
        x,
        y,
        z,
        radius,
        scale,
    }
}

fn sphere_picture(shape: &SphereShape, side: i64, mut visit: impl FnMut(i64, i64, ObjectPixel)) {
    let words = sphere_words(shape, screen(side, side), &Format::BASE);
    for (x, y) in square(side) {
        visit(x, y, words.at(x, y, &Format::BASE));
    }
}

#[test]
fn sphere_outline_is_exact() {
    let places = [
        (integer(50), integer(50), integer(40)),
        (fraction(1001, 20), fraction(399, 8), fraction(305, 8)),
        (fraction(1, 3), fraction(200, 7), fraction(65, 3)),
        (fraction(45, 2), integer(60), fraction(1, 2)),
    ];
    for (x1, y1, radius) in places {
        let shape = shape(x1.clone(), y1.clone(), radius.clone());
        let mut covered = 0;
        sphere_picture(&shape, 100, |x, y, pixel| {
            let (u, v) = (integer(x) - &x1, integer(y) - &y1);
            let inside = &u * &u + &v * &v <= &radius * &radius;
            let is_seen = pixel.zf != Format::BASE.z_max();
            assert_eq!(is_seen, inside, "({x}, {y}) of {shape:?}");
            covered += u32::from(inside);
        });
        assert!(covered > 0, "{shape:?}");
    }
}

/// The words lose at most the stated rounding against the real paraboloid, front and back.
#[test]
fn sphere_depth_is_the_paraboloid() {
    let shape = shape(fraction(1001, 20), fraction(399, 8), fraction(305, 8));
    let exact = shape.paraboloid();
    let guard = depth_guard(&Format::BASE);
    sphere_picture(&shape, 100, |x, y, pixel| {
        if pixel.zf == Format::BASE.z_max() {
            return;
        }
        let front = value_at(&exact, x, y);
        let back = integer(2) * &shape.z - &front;
        let bound = rounding_bound(x, y, guard);
        for (found, exact) in [(pixel.zf, &front), (pixel.zb, &back)] {
            assert!((integer(found) - exact).abs() <= bound, "({x}, {y})");
        }
    });
}

/// The figures of the restatement of the source (5.4), over all pixels of a disc of radius 400.
#[test]
fn sphere_depth_errors_are_those_of_the_source() {
    const R: i64 = 400;
    let shape = shape(integer(R), integer(R), integer(R));
    let (mut worst, mut best, mut squares, mut pixels) = (0f64, 0f64, 0f64, 0f64);
    let (mut worst_at, mut best_at) = (0f64, 0f64);
    let mut angles = (0f64, 0f64);
    sphere_picture(&shape, 2 * R + 1, |x, y, pixel| {
        if pixel.zf == Format::BASE.z_max() {
            return;
        }
        let square = (x - R) * (x - R) + (y - R) * (y - R);
        let radius = (square as f64).sqrt() / R as f64;
        let true_bulge = ((R * R - square) as f64).sqrt();
        let bulge = (300_001 - pixel.zf) as f64 / 8192.0;
        let error = (bulge - true_bulge) / R as f64;
        if error > worst {
            (worst, worst_at) = (error, radius);
        }
        if error < best {
            (best, best_at) = (error, radius);
        }
        squares += error * error;
        pixels += 1.0;
        let true_normal = [(x - R) as f64, (y - R) as f64, -true_bulge];
        let angle = angle_between(true_normal, pixel.normal.map(f64::from));
        angles = (angles.0 + angle, angles.1.max(angle));
    });
    // Outline, with pixels exactly on it.
    assert_eq!(worst_at, 1.0);
    let rms = (squares / pixels).sqrt();
    // The integral over the disc is 0.05076; pixels at the steep outline are a coarse sample of it.
    for (found, expected, tolerance) in [
        (worst, 0.2945, 0.00005),
        (best, -0.0450, 0.00005),
        (best_at, 0.734, 0.002),
        (rms, 0.05076, 0.00006),
        (angles.0 / pixels, 1.6, 0.05),
        (angles.1, 16.4, 0.05),
    ] {
        let off = (found - expected).abs();
        assert!(off < tolerance, "{found} for {expected}");
    }
}

fn angle_between(a: [f64; 3], b: [f64; 3]) -> f64 {
    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let cosine = dot(a, b) / (dot(a, a) * dot(b, b)).sqrt();
    cosine.min(1.0).acos().to_degrees()
}

/// The numeric example of the restatement (5.4): centre (8, 8), depth 100, radius 6, 256 counts per pixel.
#[test]
fn sphere_coefficients_of_the_specification() {
    let shape = SphereShape {
        x: integer(8),
        y: integer(8),
        z: integer(25_600),
        radius: integer(6),
        scale: integer(256),
    };
    let whole = shape.paraboloid().factors().map(|v| to_f64(&v).round());
    assert_eq!(whole, [31.0, 31.0, 0.0, -503.0, -503.0, 28_038.0]);
    let words = sphere_words(&shape, screen(16, 16), &Format::BASE);
    let row = (1..=16).map(|x| words.contour.wrapped_at(x, 8, 48));
    let expected = [
        -13, 0, 11, 20, 27, 32, 35, 36, 35, 32, 27, 20, 11, 0, -13, -28,
    ];
    assert!(row.eq(expected));
}

#[test]
fn a_sphere_that_reaches_nearer_than_the_near_end_is_capped() {
    let mut shape = shape(integer(20), integer(20), integer(15));
    shape.z = integer(Format::BASE.z_low());
    let mut caps = 0;
    sphere_picture(&shape, 40, |_, _, pixel| {
        if pixel.zf != Format::BASE.z_max() {
            assert_eq!((pixel.zf, pixel.number), (Format::BASE.z_low(), 15));
            assert_eq!(pixel.normal, [0, 0, -32767]);
            caps += 1;
        }
    });
    assert!(caps > 600, "{caps}");
}

fn cylinder() -> CylinderShape {
    CylinderShape {
        centre: [fraction(41, 2), integer(25), integer(-9)],
        direction: [fraction(4, 5), fraction(3, 5)],
        level: fraction(12, 13),
        deep: fraction(5, 13),
        radius: fraction(31, 2),
        length: fraction(113, 2),
        scale: integer(8192),
    }
}

/// What a ray meets first, in exact signs: the disc, the body or nothing.
fn cylinder_part(shape: &CylinderShape, x: i64, y: i64) -> Option<u8> {
    let [cos, sin] = &shape.direction;
    let (u, v) = (integer(x) - &shape.centre[0], integer(y) - &shape.centre[1]);
    let (a, t) = (cos * &u + sin * &v, cos * &v - sin * &u);
    // Height of the surface over the axis, squared; a point of the body at a lies at (a - deep q) / level along the
    // axis.
    let q2 = &shape.radius * &shape.radius - &t * &t;
    if q2.is_negative() {
        return None;
    }
    let reach = &shape.deep * &shape.deep * &q2;
    let within = |distance: &BigRational| distance * distance <= reach;
    let end = &a - &shape.length * &shape.level;
    if within(&a) {
        Some(FACE_DISC)
    } else if a.is_positive() && (!end.is_positive() || within(&end)) {
        Some(0)
    } else {
        None
    }
}

#[test]
fn cylinder_outline_disc_and_body() {
    const SIDE: i64 = 96;
    for (cos, sin) in [(4, 3), (-4, 3), (3, -4), (-3, -4), (5, 0), (0, 5)] {
        let mut shape = cylinder();
        shape.direction = [fraction(cos, 5), fraction(sin, 5)];
        shape.centre[0] = integer(48);
        shape.centre[1] = fraction(93, 2);
        check_cylinder(&shape, SIDE);
    }
    let mut steep = cylinder();
    (steep.level, steep.deep) = (fraction(3, 5), fraction(4, 5));
    check_cylinder(&steep, SIDE);
    check_cylinder(&cylinder(), SIDE);
}

fn check_cylinder(shape: &CylinderShape, side: i64) {
    let format = Format::BASE;
    let words = cylinder_words(shape, screen(side, side), &format);
    let body = shape.body();
    let (mut discs, mut bodies) = (0, 0);
    for (x, y) in square(side) {
        let pixel = words.at(x, y, &format);
        let part = cylinder_part(shape, x, y);
        let ours = (pixel.zf != format.z_max()).then_some(pixel.number);
        assert_eq!(ours, part, "({x}, {y}) of {shape:?}");
        match part {
            Some(FACE_DISC) => {
                discs += 1;
                check_disc(shape, x, y, &pixel);
            }
            Some(_) => {
                bodies += 1;
                let bound = rounding_bound(x, y, depth_guard(&format));
                let error = (integer(pixel.zf) - value_at(&body, x, y)).abs();
                assert!(error <= bound, "({x}, {y})");
                check_envelope(shape, x, y, &pixel);
            }
            None => assert_eq!(pixel.normal, [0; 3]),
        }
    }
    assert!(discs > 200 && bodies > 500, "{discs} {bodies}");
}

/// The disc is a plane: its depth is exact but for the rounding of its words.
fn check_disc(shape: &CylinderShape, x: i64, y: i64, pixel: &ObjectPixel) {
    let [cos, sin] = &shape.direction;
    let (u, v) = (integer(x) - &shape.centre[0], integer(y) - &shape.centre[1]);
    let a = cos * &u + sin * &v;
    let exact = &shape.scale * (&shape.centre[2] - a * &shape.level / &shape.deep);
    let bound = linear_bound(x, y, plane_guard(&Format::BASE));
    let error = (integer(pixel.zf) - exact).abs();
    assert!(error <= bound, "disc ({x}, {y})");
}

/// The body's error is that of the profile, -4.51 to +29.46 % of R, over the level part of the axis; its normal is
/// within 16.5 degrees.
fn check_envelope(shape: &CylinderShape, x: i64, y: i64, pixel: &ObjectPixel) {
    let [cos, sin] = shape.direction.each_ref().map(to_f64);
    let centre = shape.centre.each_ref().map(to_f64);
    let (u, v) = (x as f64 - centre[0], y as f64 - centre[1]);
    let (a, t) = (cos * u + sin * v, cos * v - sin * u);
    let [level, deep, radius, scale] =
        [&shape.level, &shape.deep, &shape.radius, &shape.scale].map(to_f64);
    let q = (radius * radius - t * t).max(0.0).sqrt();
    let z = centre[2] + a * deep / level - q / level;
    let error = (z - pixel.zf as f64 / scale) * level / radius;
    assert!((-0.0452..=0.2947).contains(&error), "({x}, {y}): {error}");
    let along = deep * q;
    let normal = [along * cos - sin * t, along * sin + cos * t, -level * q];
    let angle = angle_between(normal, pixel.normal.map(f64::from));
    assert!(angle < 16.5, "({x}, {y}): {angle}");
}
