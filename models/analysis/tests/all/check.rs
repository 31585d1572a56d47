//! The check: what it reports, and that its bounds and its word on undecided pixels hold.

use imogene_algebra::rational::from_f64_exact;
use imogene_analysis::bounds::{CheckReport, QuadricReport, Shows, check, depth_bound};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;
use imogene_prepare::{PreparedObject, PreparedQuadric, prepare as prepare_scene};
use imogene_scene::{FramedQuadric, Quadric, Surface};
use imogene_testkit::*;
use num_traits::Signed;

fn report(objects: Vec<FramedQuadric>) -> CheckReport {
    let scene = scene(objects);
    check(&scene, &prepare(&scene))
}

/// The check of one object.
fn report_of(object: FramedQuadric) -> CheckReport {
    report(vec![object])
}

fn first_of(report: &CheckReport) -> &QuadricReport {
    report.objects[0].quadric().expect("a quadric")
}

const CENTRE: [i64; 3] = [20, -10, 300];
const ENDS: [[i64; 4]; 2] = [[0, 1, 0, -120], [0, -1, 0, -120]];

/// A double cone about an axis in the picture's plane, its apex on the screen: x^2 - y^2/4 + (z - 200)^2 = 0.
fn double_cone() -> Quadric {
    centred([4, -1, 4], [17, -13, 200], 0)
}

#[track_caller]
fn assert_problem(report: &CheckReport, essential: &str) {
    let problems = &report.objects[0].problems;
    let found = problems.iter().any(|p| p.contains(essential));
    assert!(found, "'{essential}' not in {problems:?}");
}

#[test]
fn a_plain_ball_has_no_problem() {
    let report = report_of(ball(CENTRE, 100, &[]));
    let ball = &report.objects[0];
    assert!(report.ok && ball.problems.is_empty(), "{:?}", ball.problems);
    assert_eq!((&*ball.name, ball.kind), ("ball", "ellipsoid"));
    assert_eq!(first_of(&report).class, Class::Side);
    assert!(ball.pixels > 15_000);
    assert!(report.bounds.depth_lsb <= report.bounds.depth_lsb_closed_form);
    assert!(report.bounds.silhouette_px < 1e-5);
    assert!(report.bounds.normal_deg_999 <= report.bounds.normal_deg);
    assert!(report.bounds.normal_deg < 0.05);
}

#[test]
fn the_report_has_the_keys_that_scripts_rely_on() {
    let surface = object("ball", Surface::Patch, sphere(CENTRE, 100), &[]);
    let report = report_of(surface);
    let json = serde_json::to_value(&report).expect("serialisable");
    for key in ["name", "kind", "class", "problems"] {
        assert!(json["objects"][0].get(key).is_some(), "objects[].{key}");
    }
    for key in ["depth_lsb", "silhouette_px", "normal_deg"] {
        assert!(json["bounds"][key].is_f64(), "bounds.{key}");
    }
    assert_eq!(json["ok"], true);
    assert_eq!(json["objects"][0]["class"], "patch");
    assert_eq!(json["widths"]["format"]["depth"], 24);
}

#[test]
fn planes_without_effect_are_named() {
    let cuts = [[0, 0, -1, 250], [0, 0, 1, -500]];
    let report = report_of(ball(CENTRE, 100, &cuts));
    assert_problem(&report, "cut 1 changes no pixel");
    assert_eq!(report.objects[0].problems.len(), 1);
}

#[test]
fn objects_off_the_screen_and_notes_of_the_preparation_are_told() {
    let aside = report_of(ball([2000, 0, 300], 100, &[]));
    assert_problem(&aside, "outside the screen");
    assert_eq!(aside.objects[0].pixels, 0);
    let apart = [[1, 0, 0, 0], [-1, 0, 0, 1]];
    let slice = sphere([0, 0, 300], 100);
    let empty = report_of(object("slice", Surface::Patch, slice, &apart));
    assert_problem(&empty, "leave nothing");
    assert_eq!(empty.objects[0].pixels, 0);
}

#[test]
fn a_solid_before_the_near_end_is_told() {
    let report = report_of(ball([0, 0, -451], 290, &[]));
    assert_problem(&report, "near end");
    assert_eq!(report.widths.needed.sum, Format::BASE.sum);
}

#[test]
fn the_apex_of_a_double_cone_is_told_and_bounded() {
    let cone = object("hourglass", Surface::Solid, double_cone(), &ENDS);
    let report = report_of(cone);
    assert_problem(&report, "no direction");
    let cone = first_of(&report);
    assert_eq!(report.objects[0].kind, "cone");
    assert!(cone.bounds.silhouette_singular);
    println!(
        "silhouette of a double cone within {:.3} pixels",
        cone.bounds.silhouette_px
    );
    assert!(cone.bounds.silhouette_px < 0.5 && report.ok);
}

/// A disc thinner than the rounding of f2 may be there in one picture and not in the other: the check fails.
#[test]
fn a_silhouette_that_may_vanish_fails_the_check() {
    let format = Format::new(16).expect("in the catalogue");
    // x^2/80^2 + y^2/80^2 + (z - 300)^2/0.05^2 = 1
    let disc = centred([1, 1, 2_560_000], [0, 0, 300], 6400);
    let scene = scene(vec![object("disc", Surface::Solid, disc, &[])]);
    let prepared = prepare_scene(&scene, format).expect("fits");
    let report = check(&scene, &prepared);
    assert!(!report.ok && report.bounds.silhouette_px > 10.0);
    assert_problem(&report, "no direction");
    assert!(report.undecided_pixels > 1000);
}

/// Points of the computed contour, one for each crossing of a line of the box, with the unit gradient.
fn contour_points(object: &PreparedQuadric) -> Vec<([f64; 2], [f64; 2])> {
    let q = &object.words.f2;
    let ScreenBox { x0, x1, y0, y1 } = object.words.screen_box;
    let mut points = vec![];
    for y in y0..=y1 {
        // About the box's middle, so that no digits are lost.
        let middle = (x0 + x1) / 2;
        let along = q.from_zone(middle, y);
        let [a, b, c] = [along.a, along.d, along.f].map(|v| v as f64);
        let root = (b * b - 4.0 * a * c).sqrt();
        let crossings = [-1.0, 1.0].map(|s| (-b + s * root) / (2.0 * a));
        for u in crossings.into_iter().filter(|u| u.is_finite()) {
            let x = middle as f64 + u;
            if x < x0 as f64 || x > x1 as f64 {
                continue;
            }
            let gx = 2.0 * a * u + b;
            let gy = along.c as f64 * u + along.e as f64;
            let length = gx.hypot(gy);
            points.push(([x, y as f64], [gx / length, gy / length]));
        }
    }
    points
}

fn exact_sign(object: &PreparedQuadric, [x, y]: [f64; 2]) -> bool {
    let f2 = &object.exact.f2;
    f2.at(&from_f64_exact(x), &from_f64_exact(y)).is_positive()
}

/// From every point of the computed contour the true one is crossed within the stated displacement, along the slope.
#[test]
fn the_true_silhouette_lies_within_the_stated_displacement() {
    let egg = whole_quadric([3, 2, 5, 1, -1, 1, -60, 17, -1200, 320_000]);
    for solid in [
        ball(CENTRE, 100, &[]),
        object("egg", Surface::Solid, egg, &[]),
        object("hourglass", Surface::Solid, double_cone(), &ENDS),
    ] {
        let name = solid.name.clone();
        for (depth, guards) in [(16, 0), (16, 6), (20, 0), (20, 8), (24, 0)] {
            let scene = scene(vec![solid.clone()]);
            let format = Format::new(depth).expect("in the catalogue");
            let format = format.with_guards(3, guards).expect("within limits");
            let prepared = prepare_scene(&scene, format).expect("fits");
            let object = first(&prepared);
            let reach = check(&scene, &prepared).bounds.silhouette_px;
            let points = contour_points(object);
            assert!(points.len() > 100);
            for ([x, y], [gx, gy]) in &points {
                let at = |s: f64| [x + s * reach * gx, y + s * reach * gy];
                // The hourglass bound also covers the neighbourhood of the apex, where the slope turns.
                let crossed = exact_sign(object, at(1.0)) != exact_sign(object, at(-1.0));
                assert!(
                    crossed || name == "hourglass",
                    "{name}, {depth} bits, ({x}, {y})"
                );
            }
            println!("{name}, {depth} bits, {guards} guard bits: within {reach:.2e} pixels");
        }
    }
}

#[test]
fn longer_words_are_never_worse() {
    let scene = scene(vec![ball(CENTRE, 100, &[[0, 0, -1, 250]])]);
    let mut last = f64::INFINITY;
    for depth in [16, 20, 24, 28, 32] {
        let prepared =
            prepare_scene(&scene, Format::new(depth).expect("in the catalogue")).expect("fits");
        let object = first(&prepared);
        assert!(depth_bound(object, 0, 1 << 20) < 1e4);
        let silhouette = check(&scene, &prepared).bounds.silhouette_px;
        assert!(silhouette < last, "{depth} bits");
        last = silhouette;
    }
}

/// The preparation proves the exact depth of a plane. In short words rounding is coarse: what the words reach is
/// checked again.
#[test]
fn planes_that_wrap_as_loaded_fail_the_check() {
    let scene = scene(vec![ball(CENTRE, 100, &[[0, 0, -1, 250]])]);
    let mut prepared = prepare(&scene);
    assert!(check(&scene, &prepared).ok);
    let PreparedObject::Quadric(object) = &mut prepared.objects[0] else {
        panic!("not a quadric");
    };
    let plane = &mut object.words.planes[0].depth;
    // Reaches 2^35 in the last column of the box, and nowhere else.
    *plane = Linear::new(1, 0, (1 << 35) - i128::from(object.words.screen_box.x1));
    let report = check(&scene, &prepared);
    assert!(!report.ok);
    assert_problem(&report, "reaches 37 bits");
}

#[test]
fn what_an_object_is_and_whether_it_shows_are_fields() {
    let before = object("before", Surface::Solid, sphere([0, 0, 100], 150), &[]);
    let behind = object("behind", Surface::Solid, sphere([0, 0, 600], 20), &[]);
    let aside = object("aside", Surface::Solid, sphere([2000, 0, 300], 100), &[]);
    let report = report(vec![before, behind, aside]);
    let shows: Vec<Shows> = report.objects.iter().map(|o| o.shows).collect();
    assert_eq!(shows, [Shows::Visible, Shows::Hidden, Shows::EmptyBox]);
    assert_eq!(report.summary.never_shown, ["behind", "aside"]);
    assert_eq!(report.summary.without_highlights.len(), 3);
    let machine = report.summary.machine.as_ref().expect("quadrics alone");
    assert_eq!(machine.slots, "0,0,0");
    let [first, second, third] = &report.objects[..] else {
        panic!("three objects");
    };
    assert_eq!(first.visible_pixels, first.pixels);
    assert!(second.pixels > 0 && second.visible_pixels == 0);
    assert!(third.quadric().expect("a quadric").accumulators.is_none());
}

#[test]
fn planes_and_classes_are_fields() {
    // Vertical half-plane through the eye, one that cuts, one that does nothing.
    let cuts = [[1, 0, 0, -20], [0, 0, -1, 250], [0, 0, 1, -500]];
    let cut = report_of(ball(CENTRE, 100, &cuts));
    let found = first_of(&cut);
    assert_eq!(found.planes_without_effect, [2]);
    assert!(!found.front_view && !found.prism && !found.degenerate);
    assert_eq!(cut.summary.planes_without_effect, ["ball"]);
    // Through the eye.
    let sliced = report_of(ball(CENTRE, 100, &[[1, 0, 0, 0]]));
    let found = first_of(&sliced);
    assert_eq!(found.perpendicular_planes, [0]);
    assert_eq!(sliced.summary.perpendicular_planes, ["ball"]);
    // Two planes x = 100, x = 140, of which the viewer is not between.
    let slab = whole_quadric([1, 0, 0, 0, 0, 0, -120, 0, 0, 14_000]);
    let pair = [
        [0, 1, 0, -90],
        [0, -1, 0, -90],
        [0, 0, 1, -400],
        [0, 0, -1, 200],
    ];
    let slab = report_of(object("slab", Surface::Solid, slab, &pair));
    let found = first_of(&slab);
    assert!(found.degenerate, "{}", slab.objects[0].kind);
    assert_eq!(slab.summary.degenerate, ["slab"]);
}
