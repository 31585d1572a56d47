//! The exact reference is tested itself: against a slow floating-point ray caster, and in rationals against the
//! equation it solves.

use imogene_algebra::rational::{fraction, integer, to_f64};
use imogene_analysis::exact::ray::RayObject;
use imogene_analysis::exact::render::{DEPTH_FRACTION, render};
use imogene_golden::format::Format;
use imogene_golden::unit::depth_interval::{FACE_NEAR_END, FACE_PLANE};
use imogene_prepare::Framing;
use imogene_scene::{FramedQuadric, FramedScene, Projection, Surface};
use imogene_testkit::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;

const F: Format = Format::BASE;
const NAMES: [&str; 6] = [
    "teapot",
    "ellipsoid",
    "hyperboloid-two-sheets",
    "hyperbolic-paraboloid",
    "cone",
    "orthographic",
];

fn collection(name: &str, width: u32, height: u32) -> FramedScene {
    scene_file(name).frame(width, height).expect("a valid size")
}

/// A face that a line of sight meets: depth as a fraction of the depth word, -1 .. 1, and number.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    depth: f64,
    number: u8,
}

/// What is found by sorting all faces along the ray and testing the middle of every piece between them; nothing is
/// known if two faces are too close for floating point.
enum Found {
    Nothing,
    Hit(Candidate),
    Unclear,
}

/// Points of a line of sight in the camera frame by depth fraction.
fn point_at(scene: &FramedScene, x: usize, y: usize, depth: f64) -> [f64; 3] {
    let depth = depth * scene.projection.full_depth();
    scene.projection.antecedent(scene.pixel_centre(x, y), depth)
}

fn quadric_value(object: &FramedQuadric, p: [f64; 3]) -> f64 {
    let n = gradient(&object.quadric, p);
    let coefficients = object.quadric.coefficients().map(to_f64);
    let greatest = coefficients.iter().fold(0.0, |most, c| c.abs().max(most));
    let [.., g, h, i, j] = coefficients.map(|c| c / greatest);
    (n[0] + g) * p[0] + (n[1] + h) * p[1] + (n[2] + i) * p[2] + j
}

fn plane_value(object: &FramedQuadric, index: usize, p: [f64; 3]) -> f64 {
    let [a, b, c, d] = object.planes[index].coefficients().map(to_f64);
    let length = (a * a + b * b + c * c).sqrt();
    (a * p[0] + b * p[1] + c * p[2] + d) / length
}

/// The value of an expression along a line of sight times a positive power of the distance is a polynomial of the depth
/// fraction; it is found from its values at -1/2, 0 and 1/2.
fn quadratic_along(value: impl Fn(f64) -> f64) -> [f64; 3] {
    let [low, middle, high] = [-0.5, 0.0, 0.5].map(value);
    [2.0 * (low + high) - 4.0 * middle, high - low, middle]
}

/// The distance of a depth fraction, as a part of that of the viewer.
fn weight(scene: &FramedScene, depth: f64) -> f64 {
    match scene.projection {
        Projection::Perspective { .. } => 1.0 - depth,
        Projection::Orthographic { .. } => 1.0,
    }
}

/// Depth fractions of the quadric in order, nothing if there are none, an error if it is unclear.
fn roots(
    scene: &FramedScene,
    object: &FramedQuadric,
    x: usize,
    y: usize,
) -> Result<Vec<Candidate>, ()> {
    let value =
        |depth| quadric_value(object, point_at(scene, x, y, depth)) * weight(scene, depth).powi(2);
    let [a, b, c] = quadratic_along(value);
    let size = b * b + (4.0 * a * c).abs();
    let discriminant = b * b - 4.0 * a * c;
    if a.abs() < 1e-9 * (b.abs() + c.abs()) || discriminant.abs() < 1e-6 * size {
        return Err(());
    }
    if discriminant < 0.0 {
        return Ok(vec![]);
    }
    let mut depths = [-1.0, 1.0].map(|s| (-b + s * discriminant.sqrt()) / (2.0 * a));
    depths.sort_by(f64::total_cmp);
    let candidates = depths.into_iter().zip(0..);
    Ok(candidates
        .map(|(depth, number)| Candidate { depth, number })
        .collect())
}

fn cast(scene: &FramedScene, object: &FramedQuadric, x: usize, y: usize) -> Found {
    let Ok(quadric) = roots(scene, object, x, y) else {
        return Found::Unclear;
    };
    let planes = (0..object.planes.len()).filter_map(|i| {
        let at = |depth| point_at(scene, x, y, depth);
        let value = |depth| plane_value(object, i, at(depth)) * weight(scene, depth);
        let (low, high) = (value(-0.5), value(0.5));
        let depth = -0.5 - low / (high - low);
        depth.is_finite().then_some(Candidate {
            depth,
            number: FACE_PLANE + i as u8,
        })
    });
    let ends =
        [(-1.0, FACE_NEAR_END), (1.0, 255)].map(|(depth, number)| Candidate { depth, number });
    let mut faces: Vec<Candidate> = quadric.iter().copied().chain(planes).chain(ends).collect();
    faces.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    if faces.windows(2).any(|w| w[1].depth - w[0].depth < 1e-6) {
        return Found::Unclear;
    }
    let kept = |depth: f64| {
        let p = point_at(scene, x, y, depth);
        (0..object.planes.len()).all(|i| plane_value(object, i, p) <= 0.0)
    };
    let visible = |depth: f64| (-1.0..1.0).contains(&depth);
    let hit = match object.surface {
        Surface::Patch => quadric
            .into_iter()
            .find(|c| visible(c.depth) && kept(c.depth)),
        Surface::Solid => faces.windows(2).find_map(|w| {
            let middle = 0.5 * (w[0].depth + w[1].depth);
            let inside = quadric_value(object, point_at(scene, x, y, middle)) <= 0.0;
            (visible(w[0].depth) && inside && kept(middle)).then_some(w[0])
        }),
    };
    hit.map_or(Found::Nothing, Found::Hit)
}

#[test]
fn agrees_with_a_slow_ray_caster_wherever_floats_can_tell() {
    let mut random = Random(0xfeed_5eed);
    let (mut hits, mut misses, mut unclear) = (0, 0, 0);
    for name in NAMES {
        let scene = collection(name, 320, 240);
        let objects = || scene.objects.iter().filter_map(|o| o.quadric());
        let rays: Vec<_> = objects().map(|o| RayObject::new(o, &scene)).collect();
        for _ in 0..1500 {
            let at = |v: f64, size: u32| ((v + 1.0) * 0.5 * f64::from(size)) as usize;
            let (x, y) = (
                at(random.signed(), scene.width),
                at(random.signed(), scene.height),
            );
            for (object, ray) in objects().zip(&rays) {
                let exact = ray.first_hit(x as i64, y as i64);
                let depth = |w: &imogene_analysis::exact::number::SurdReal| {
                    let fixed = w.fixed(&BigInt::from(1), &BigInt::from(1), 50);
                    let fixed: i64 = fixed.try_into().expect("visible");
                    fixed as f64 / 2f64.powi(50)
                };
                match (cast(&scene, object, x, y), exact) {
                    (Found::Unclear, _) => unclear += 1,
                    (Found::Nothing, None) => misses += 1,
                    (Found::Hit(slow), Some(hit)) => {
                        assert_eq!(slow.number, hit.number, "{name} {} ({x}, {y})", object.name);
                        let off = (slow.depth - depth(&hit.w)).abs();
                        assert!(off < 1e-8, "{name} {} ({x}, {y}): {off}", object.name);
                        hits += 1;
                    }
                    (_, exact) => panic!("{name} {} ({x}, {y}): exact {exact:?}", object.name),
                }
            }
        }
    }
    println!("{hits} hits, {misses} misses, {unclear} too close for floating point");
    assert!(hits > 1000 && misses > 1000 && unclear < (hits + misses) / 15);
}

/// The camera-frame point of a pixel at an exact depth fraction.
fn exact_point(scene: &FramedScene, x: i64, y: i64, depth: &BigRational) -> [BigRational; 3] {
    let column = integer(x) - integer(i64::from(scene.width)) / integer(2);
    let line = integer(y) - integer(i64::from(scene.height)) / integer(2);
    match &scene.projection {
        Projection::Perspective { distance } => {
            let k = (integer(1) - depth).recip();
            [column * &k, line * &k, distance * depth * k]
        }
        Projection::Orthographic { half_depth } => [column, line, half_depth * depth],
    }
}

/// The value of the face's own equation at a pixel and depth fraction.
fn face_value(
    scene: &FramedScene,
    id: u32,
    number: u8,
    x: i64,
    y: i64,
    depth: &BigRational,
) -> BigRational {
    let object = scene.objects[id as usize].quadric().expect("a quadric");
    let [px, py, pz] = exact_point(scene, x, y, depth);
    match number {
        0 | 1 => object.quadric.value_at(&px, &py, &pz),
        n => object.planes[usize::from(n - FACE_PLANE)].value_at(&px, &py, &pz),
    }
}

/// Around every visible depth the face's own equation changes its sign, in exact arithmetic.
#[test]
fn every_visible_point_lies_on_its_face() {
    let mut checked = 0;
    for name in NAMES {
        let scene = collection(name, 80, 60);
        let picture = render(&scene, &F, || ());
        let full = BigInt::from(F.z_max());
        for (index, pixel) in picture.iter().enumerate() {
            let Some(pixel) = pixel.filter(|p| p.number != FACE_NEAR_END) else {
                continue;
            };
            let (x, y) = (index as i64 % 80, index as i64 / 80);
            let value = |units: i64| {
                let depth =
                    BigRational::new(BigInt::from(pixel.depth + units), &full << DEPTH_FRACTION);
                face_value(&scene, pixel.id, pixel.number, x, y, &depth)
            };
            let (before, after) = (value(-1), value(2));
            let changes =
                before.is_zero() || after.is_zero() || before.is_positive() != after.is_positive();
            assert!(changes, "{name} ({x}, {y}): {pixel:?}");
            checked += 1;
        }
    }
    assert!(checked > 5000, "{checked}");
}

/// Balls of radius 25 seen in parallel: at whole points of the circle the depth is a whole number and is met exactly.
#[test]
fn rational_roots_are_exact() {
    let projection = parallel(100);
    for surface in [Surface::Solid, Surface::Patch] {
        let ball = object("ball", surface, sphere([0, 0, 0], 25), &[]);
        let scene = scene_of(64, 64, projection.clone(), vec![ball]);
        let ray = RayObject::new(framed(&scene), &scene);
        for (u, v, z) in [
            (0, 0, 25),
            (7, 0, 24),
            (0, -15, 20),
            (-24, 0, 7),
            (12, 9, 20),
            (25, 0, 0),
        ] {
            let hit = ray.first_hit(u + 32, v + 32).expect("on the ball");
            // z = 100 (1 + w)
            let order = hit.w.cmp_ratio(&BigInt::from(-z - 100), &BigInt::from(100));
            assert_eq!(order, Ordering::Equal);
            let depth = fraction(-z, 100);
            assert!(face_value(&scene, 0, hit.number, u + 32, v + 32, &depth).is_zero());
        }
        assert!(ray.first_hit(32 + 25, 32 + 1).is_none());
    }
}
