//! The tracer against closed forms, against itself without intervals, and on random objects.

use crate::common::{PARALLEL, PERSPECTIVE, scene};
use imogene_golden::object::facet::FACE_FACET;
use imogene_oracle::body::Body;
use imogene_oracle::camera::Sight;
use imogene_oracle::root::Real;
use imogene_oracle::trace::Tracer;
use imogene_oracle::verdict::{Solved, Verdict};
use imogene_scene::{DepthRange, Plane, Quadric, SceneFile, Transform};
use num_rational::BigRational;
use proptest::prelude::*;
use std::cmp::Ordering;

fn fraction(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

struct Rays {
    sight: Sight,
    bodies: Vec<Body>,
}

impl Rays {
    fn new(scene: &SceneFile) -> Rays {
        let sight = Sight::new(&scene.camera, &DepthRange::of_camera(&scene.camera), 64, 48);
        let bodies = scene.objects.iter().flat_map(|o| Body::of(o, &sight));
        Rays {
            bodies: bodies.collect(),
            sight,
        }
    }

    fn solve(&self, body: usize, column: u32, line: u32) -> Option<Solved> {
        let (x, y) = self.sight.place(column, line);
        self.bodies[body].solve(x, y, &self.sight.ends())
    }

    /// What intervals say of a rectangle of pixels is true at this one of it.
    fn check(&self, body: usize, cell: [u32; 4], (column, line): (u32, u32)) -> Result<(), String> {
        let [x0, y0, x1, y1] = cell;
        let verdict = self.bodies[body].decide(&self.sight.cell([x0, y0], [x1, y1]));
        let truth = self.solve(body, column, line);
        let exact = |value: f64| BigRational::from_float(value);
        let not_before = |t: &Real, least: f64| {
            exact(least).is_none_or(|least| t.cmp_fraction(&least) != Ordering::Less)
        };
        let not_behind = |t: &Real, most: f64| {
            exact(most).is_none_or(|most| t.cmp_fraction(&most) != Ordering::Greater)
        };
        let agrees = match (&verdict, &truth) {
            (Verdict::Absent, None) | (Verdict::Open(_), None) => true,
            (Verdict::Open(from), Some(found)) => not_before(&found.t, *from),
            (Verdict::Hit { t, number, .. }, Some(found)) => {
                let is_within = not_before(&found.t, t.lo) && not_behind(&found.t, t.hi);
                *number == found.number && is_within
            }
            _ => false,
        };
        let reason = || format!("{cell:?} {column} {line}: {verdict:?}, in truth {truth:?}");
        agrees.then_some(()).ok_or_else(reason)
    }
}

/// Closed forms at the middle of the picture, pixel (32, 24), and beside it.
#[test]
fn depths_are_those_of_closed_forms() {
    let cut = "cuts = [{ point = [0, 0, 1], normal = [0, 0, 1] }]";
    let away = "cuts = [{ point = [0, 0, -1], normal = [0, 0, -1] }]";
    // Object, distance of its first point from the eye over ten, and the number of its face.
    let cases = [
        ("kind = \"sphere\"\nradius = 2".to_owned(), fraction(8, 10), 0),
        ("kind = \"ellipsoid\"\nradii = [2, 1, 0.5]".to_owned(), fraction(95, 100), 0),
        ("kind = \"elliptic_cylinder\"\nradii = [2, 1]".to_owned(), fraction(9, 10), 0),
        (format!("kind = \"sphere\"\nradius = 2\n{cut}"), fraction(9, 10), 2),
        (format!("kind = \"sphere\"\nradius = 2\n{away}"), fraction(8, 10), 0),
        // A patch that is open in front shows its inner wall.
        (format!("kind = \"sphere\"\nradius = 2\nmode = \"patch\"\n{cut}"), fraction(12, 10), 1),
        ("kind = \"sphere\"\nradius = 6".to_owned(), fraction(1, 2), 15),
        // A cone about an axis along the view, three units beside it: the line meets it one before and one behind the
        // apex, of which the cut leaves the second.
        ("kind = \"cone\"\nradii = [1, 1, 1]\nplace = [{ rotate = { axis = \"x\", degrees = 90 } }, { translate = [0, 3, -1] }]\n\
          cuts = [{ point = [0, 0, 0], normal = [0, 1, 0] }]".to_owned(), fraction(14, 10), 1),
        ("kind = \"polyhedron\"\ncuts = [{ point = [0, 0, 2], normal = [0, 0, 3] }]".to_owned(), fraction(8, 10), 2),
        ("kind = \"mesh\"\nvertices = [[-1, -1, 1], [1, -1, 1], [0, 2, 1]]\nfaces = [[0, 2, 1]]".to_owned(), fraction(9, 10), FACE_FACET),
    ];
    for (object, t, number) in cases {
        let found = Rays::new(&scene(PERSPECTIVE, &[&object])).solve(0, 32, 24);
        let found = found.unwrap_or_else(|| panic!("{object}: nothing seen"));
        let order = found.t.cmp_fraction(&t);
        assert_eq!(order, Ordering::Equal, "{object}: {found:?}");
        assert_eq!(found.number, number, "{object}");
    }
}

/// Off the axis: |eye + t d|^2 = r^2 with d = (x, y, -10), in floating point to 1e-12 and by the exact sign of the
/// discriminant.
#[test]
fn a_sphere_is_hit_where_its_equation_says() {
    let rays = Rays::new(&scene(PERSPECTIVE, &["kind = \"sphere\"\nradius = 2"]));
    let mut hits = 0;
    for line in 0..48 {
        for column in 0..64 {
            // Ten pixels to the unit: in tenths all numbers are whole.
            let (x, y) = (i64::from(column) - 32, i64::from(line) - 24);
            let (r, s, t) = (x * x + y * y + 10_000, -10_000, 10_000 - 400);
            let found = rays.solve(0, column, line);
            assert_eq!(found.is_some(), s * s - r * t >= 0, "{column} {line}");
            if let Some(found) = found {
                hits += 1;
                let expected = (10_000.0 - ((s * s - r * t) as f64).sqrt()) / r as f64;
                for end in <[BigRational; 2]>::from(found.t.between(80)) {
                    let end = imogene_algebra::rational::to_f64(&end);
                    assert!((end - expected).abs() < 1e-12, "{column} {line}");
                }
            }
        }
    }
    assert!(hits > 1200, "{hits}");
}

/// The dual axes of a camera that looks askew: every pixel of a plane through its target, parallel to the screen, has
/// the depth 0.
#[test]
fn a_camera_that_looks_askew_sees_the_screen_plane_at_depth_zero() {
    let camera = "kind = \"perspective\"\neye = [4, 5, 20]\ntarget = [0, 1, 0]\nviewer_distance = 21\nview_height = 6\n";
    let cut = "kind = \"polyhedron\"\ncuts = [{ point = [0, 1, 0], normal = [4, 4, 20] }]";
    let scene = scene(camera, &[cut]);
    let length = (16.0f64 + 16.0 + 400.0).sqrt();
    let traced = Tracer::new(&scene, &DepthRange::of_camera(&scene.camera), 64, 48).draw(|| ());
    for pixel in &traced.pixels {
        let depth = pixel.expect("the plane fills the picture").depth.middle();
        assert!((depth - (1.0 - 21.0 / length)).abs() < 1e-13, "{depth}");
    }
}

/// Of two equal surfaces the first is seen; cells, quarters and occlusion change nothing.
#[test]
fn the_picture_is_that_of_every_object_at_every_pixel() {
    let cut = "cuts = [{ point = [0.3, 0, 0], normal = [1, 2, 0.5] }]";
    let objects = [
        "kind = \"sphere\"\nradius = 1.5\nmode = \"patch\"".to_owned(),
        "kind = \"sphere\"\nradius = 1.5".to_owned(),
        format!("kind = \"hyperboloid_one_sheet\"\nradii = [0.5, 1, 0.5]\nplace = [{{ translate = [-2, 0, 0.5] }}]\n{cut}"),
        format!("kind = \"cone\"\nradii = [1, 1, 1]\nmode = \"patch\"\nplace = [{{ translate = [1, 0.5, 1] }}]\n{cut}"),
        "kind = \"mesh\"\nvertices = [[-3, -1, -1], [2, -2, 1.2], [3, 2, 1], [-1, 2, 2]]\nfaces = [[0, 1, 2, 3]]".to_owned(),
        "kind = \"tetrahedron_patch\"\ncorners = [[-2, -2, 0], [2, -2, 0], [0, 2, 0], [0, 0, 3]]\n\
         weights = [-1, 1, 1, 1, 0, 0, 0, 0.5, 0.5, 0.5]".to_owned(),
    ];
    let objects: Vec<&str> = objects.iter().map(String::as_str).collect();
    for camera in [PERSPECTIVE, PARALLEL] {
        let scene = scene(camera, &objects);
        let rays = Rays::new(&scene);
        let tracer = Tracer::new(&scene, &DepthRange::of_camera(&scene.camera), 64, 48);
        let traced = tracer.draw(|| ());
        let mut seen = [false; 6];
        for line in 0..48u32 {
            for column in 0..64u32 {
                let mut nearest: Option<(u32, Solved)> = None;
                for (index, (object, _)) in tracer.bodies.iter().enumerate() {
                    let Some(found) = rays.solve(index, column, line) else {
                        continue;
                    };
                    let nearer = |(_, n): &(u32, Solved)| found.t.compare(&n.t) == Ordering::Less;
                    if nearest.as_ref().is_none_or(nearer) {
                        nearest = Some((*object, found));
                    }
                }
                let pixel = traced.pixels[(line * 64 + column) as usize];
                let expected = nearest.map(|(object, found)| (object, found.number, found.part));
                let own = pixel.map(|p| (p.object, p.number, p.part));
                assert_eq!(own, expected, "{column} {line}");
                if let Some(pixel) = pixel {
                    seen[pixel.object as usize] = true;
                }
            }
        }
        assert_eq!(seen, [true, false, true, true, true, true]);
    }
}

fn number() -> impl Strategy<Value = f64> {
    // Round numbers make coincidences: planes through centres, lines along axes.
    prop_oneof![(-4i32..=4).prop_map(|v| f64::from(v) / 2.0), -2.0f64..2.0]
}

fn radius() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), 0.05f64..2.5]
}

prop_compose! {
    fn object()(
        family in 0usize..12, r in [radius(), radius(), radius()], q in [number(), number(), number(), number(), number(), number(), number(), number(), number(), number()],
        patch: bool, quarter in 0i32..8, axis in [number(), number(), number()], at in [number(), number(), number()],
        cuts in proptest::collection::vec(([number(), number(), number()], [number(), number(), number()]), 0..4), mirror: bool,
    ) -> String {
        let [a, b, c] = r;
        let shape = match family {
            0 => format!("kind = \"sphere\"\nradius = {a:?}"),
            1 => format!("kind = \"ellipsoid\"\nradii = [{a:?}, {b:?}, {c:?}]"),
            2 => format!("kind = \"elliptic_cylinder\"\nradii = [{a:?}, {c:?}]"),
            3 => format!("kind = \"hyperbolic_cylinder\"\nradii = [{a:?}, {c:?}]"),
            4 => format!("kind = \"parabolic_cylinder\"\nradii = [{a:?}, {c:?}]"),
            5 => format!("kind = \"cone\"\nradii = [{a:?}, {b:?}, {c:?}]"),
            6 => format!("kind = \"hyperboloid_one_sheet\"\nradii = [{a:?}, {b:?}, {c:?}]"),
            7 => format!("kind = \"hyperboloid_two_sheets\"\nradii = [{a:?}, {b:?}, {c:?}]"),
            8 => format!("kind = \"elliptic_paraboloid\"\nradii = [{a:?}, {b:?}, {c:?}]"),
            9 => format!("kind = \"hyperbolic_paraboloid\"\nradii = [{a:?}, {b:?}, {c:?}]"),
            10 => format!("kind = \"quadric\"\ncoefficients = {:?}", if q[..6].iter().all(|v| *v == 0.0) { [1.0; 10] } else { q }),
            _ => "kind = \"polyhedron\"".to_owned(),
        };
        let direction = |v: [f64; 3]| if v == [0.0; 3] { [0.0, 0.0, 1.0] } else { v };
        let mut cuts: Vec<String> = cuts.into_iter()
            .map(|(p, n)| format!("{{ point = {p:?}, normal = {:?} }}", direction(n))).collect();
        if family == 11 {
            cuts.push("{ point = [0, 0, 1], normal = [0, 0, 1] }".to_owned());
        }
        let mode = if patch && family != 11 { "mode = \"patch\"\n" } else { "" };
        let degrees = if quarter < 4 { f64::from(quarter) * 90.0 } else { f64::from(quarter) * 17.3 };
        let scale = if mirror { "[-1, 1, 0.5]" } else { "[1, 1.5, 1]" };
        format!(
            "{shape}\n{mode}cuts = [{}]\nplace = [{{ scale = {scale} }}, {{ rotate = {{ axis = {:?}, degrees = {degrees:?} }} }}, {{ translate = {at:?} }}]",
            cuts.join(", "), direction(axis)
        )
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    /// What intervals say of single pixels and of rectangles is what exact arithmetic finds there.
    #[test]
    fn intervals_hold_the_exact_answer(object in object(), parallel: bool, corners in [[0u32..64, 0u32..48], [0u32..64, 0u32..48]], within in proptest::collection::vec((0u32..1000, 0u32..1000), 12)) {
        let camera = if parallel { PARALLEL } else { PERSPECTIVE };
        let rays = Rays::new(&scene(camera, &[&object]));
        let [[a, b], [c, d]] = corners;
        let cell = [a.min(c), b.min(d), a.max(c), b.max(d)];
        for (u, v) in within {
            let (x, y) = (cell[0] + u % (cell[2] - cell[0] + 1), cell[1] + v % (cell[3] - cell[1] + 1));
            for cell in [cell, [x, y, x, y], [x & !3, y & !3, x | 3, y | 3]] {
                let checked = rays.check(0, cell, (x, y));
                prop_assert!(checked.is_ok(), "{object}\n{}", checked.unwrap_err());
            }
        }
    }
    /// No point before the first one is in the solid: membership of points in scene coordinates, by the quadric and the
    /// planes of the scene module. Points within 1e-9 of the hit are left out, since rotations are computed by another
    /// formula there.
    #[test]
    fn no_point_before_the_hit_is_inside(object in object().prop_filter("a solid", |o| !o.contains("patch")), parallel: bool, column in 0u32..64, line in 0u32..48, samples in proptest::collection::vec(0.0f64..1.0, 40)) {
        let camera = if parallel { PARALLEL } else { PERSPECTIVE };
        let scene = scene(camera, &[&object]);
        let rays = Rays::new(&scene);
        let solid = &scene.objects[0];
        let placed = Transform::placement(&solid.place);
        let quadric = Quadric::from_shape(&solid.shape).expect("no mesh").transformed(&placed);
        let planes: Vec<Plane> = solid.cuts.iter().map(|c| Plane::from_cut(c).transformed(&placed)).collect();
        let found = rays.solve(0, column, line);
        let (x, y) = rays.sight.place(column, line);
        let at = |affine: &[[BigRational; 4]; 3], k: usize| &affine[0][k] * fraction(x, 1) + &affine[1][k] * fraction(y, 1) + &affine[2][k];
        for sample in samples {
            let t = if parallel { 2.0 * sample - 1.0 } else { 0.5 + 1.5 * sample };
            let t = BigRational::from_float(t).expect("finite");
            let [px, py, pz] = [0, 1, 2].map(|k| at(&rays.sight.from, k) + &t * at(&rays.sight.along, k));
            let inside = quadric.value_at(&px, &py, &pz) <= fraction(0, 1) && planes.iter().all(|p| p.value_at(&px, &py, &pz) <= fraction(0, 1));
            let later = &t + fraction(1, 1_000_000_000);
            let before = found.as_ref().is_none_or(|f| f.t.cmp_fraction(&later) == Ordering::Greater);
            prop_assert!(!(inside && before), "{object}\n{t} is inside, hit {found:?}");
        }
    }
}
