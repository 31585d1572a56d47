//! STEP files of `parts/` against what they were made from: unions and differences of bodies, asked point by point,
//! and face lists.

use crate::common::list::{EACH_FACE, faces, file, off};
use crate::common::points::{Even, kept, point_of};
use crate::common::winding::Oracle;
use imogene_import::faces::model::Face;
use imogene_import::faces::vector::*;
use imogene_import::faces::{Cell, Form, Part, Surface, Verdict, compile, compile_step};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

fn step(name: &str) -> Part {
    let bytes = file(&format!("parts/{name}.step"));
    compile_step(&bytes, name, &EACH_FACE).unwrap()
}

/// Faces of a solid with their verdicts and cells.
fn compiled(part: &Part, solid: usize) -> Vec<(&Face, &Verdict, &[Cell])> {
    let own = part.model.solids[solid].faces.iter();
    let own = own.map(|face| &part.model.faces[*face]);
    let each = own.zip(faces(part, solid));
    each.map(|(face, compiled)| (face, &compiled.verdict, &compiled.cells[..]))
        .collect()
}

/// Normal of a surface at one of its points; a plane's own, away from the axis or centre otherwise.
fn normal(surface: &Surface, p: Vector) -> Vector {
    surface.normal_at(p).expect("not at an apex")
}

/// Whether the border of a body passes through a point of a surface, and then whether the body is on the side of the
/// surface's normal. Nothing near an edge.
fn on_border(
    inside: &dyn Fn(Vector) -> bool,
    surface: &Surface,
    p: Vector,
    reach: f64,
) -> Option<Option<bool>> {
    if surface.is_cone() {
        match dot(minus(p, surface.origin), surface.axis) {
            // On the other nappe no face is expected, and near the apex there is no normal.
            height if height < -0.01 => return Some(None),
            height if height < 0.01 => return None,
            _ => {}
        }
    }
    let n = normal(surface, p);
    let [e, f] = frame(n, 0.0);
    let at = |q: Vector| {
        let foot = surface.nearest(q).unwrap();
        let n = normal(surface, foot);
        let [above, below] = [1e-7, -1e-7].map(|step| inside(along(foot, step, n)));
        (above != below).then_some(above)
    };
    let own = at(p);
    let around = (0..12).map(|k| {
        let (sine, cosine) = (TAU * f64::from(k) / 12.0).sin_cos();
        along(along(p, reach * cosine, e), reach * sine, f)
    });
    around.into_iter().all(|q| at(q) == own).then_some(own)
}

/// Every face of a solid at random points of its surface: a point is kept by a face on that surface if the body ends
/// there, and the body is on the right side.
fn agrees(part: &Part, solid: usize, inside: &dyn Fn(Vector) -> bool) {
    let faces = compiled(part, solid);
    let size = part.model.size();
    for (face, ..) in &faces {
        if matches!(face.surface.form, Form::Torus(..) | Form::Other(_)) {
            continue;
        }
        let is_same = |(other, ..): &&(&Face, _, _)| other.surface.same(&face.surface, 1e-7);
        let on_same: Vec<_> = faces.iter().filter(is_same).collect();
        let deviations = on_same.iter().map(|(_, verdict, _)| off(verdict));
        let deviation = deviations.fold(0.0, f64::max);
        // The oracle looks around a point for edges; of a face that is approximated they are so far off.
        let reach = 1e-5_f64.max(1.01 * deviation);
        let oracle = Oracle::new(&part.model, face);
        let [low, high] = oracle.bounds();
        let (middle, reach_of_face) = (times(0.5, plus(low, high)), distance(low, high));
        let mut even = Even(face.name.len() as u64);
        let (mut yes, mut no) = (0, 0);
        for _ in 0..10_000 {
            let p = point_of(&face.surface, middle, reach_of_face.min(size), &mut even);
            let Some(expected) = on_border(inside, &face.surface, p, reach) else {
                continue;
            };
            let count = if expected.is_some() {
                &mut yes
            } else {
                &mut no
            };
            *count += 1;
            let mut is_kept = false;
            for (keeper, _, cells) in &on_same {
                if kept(part, cells, p) {
                    let aligned = dot(normal(&keeper.surface, p), normal(&face.surface, p)) > 0.0;
                    let body_above = Some(aligned == keeper.reversed);
                    assert_eq!(body_above, expected, "side of {} at {p:?}", keeper.name);
                    is_kept = true;
                }
            }
            let place = format!("face {} ({}) at {p:?}", face.name, face.surface.name());
            assert_eq!(is_kept, expected.is_some(), "{place}");
        }
        assert!(yes > 60, "{}: {yes} inside, {no} outside", face.name);
    }
}

/// Between two planes across an axis, and nearer to it than a radius that goes with the height.
fn turned(p: Vector, foot: Vector, axis: Vector, height: f64, radius: impl Fn(f64) -> f64) -> bool {
    let from = minus(p, foot);
    let h = dot(from, axis);
    (0.0..height).contains(&h) && length(cross(from, axis)) < radius(h)
}

fn in_box(p: Vector, low: Vector, high: Vector) -> bool {
    (0..3).all(|k| low[k] < p[k] && p[k] < high[k])
}

const X: Vector = [1.0, 0.0, 0.0];
const Y: Vector = [0.0, 1.0, 0.0];
const Z: Vector = [0.0, 0.0, 1.0];

fn kinds(part: &Part) -> Vec<(&str, usize)> {
    let mut kinds = BTreeMap::new();
    for face in &part.model.faces {
        *kinds.entry(face.surface.name()).or_default() += 1;
    }
    kinds.into_iter().collect()
}

#[test]
fn the_fixture_is_its_block_less_its_holes() {
    let part = step("fixture");
    // Six sides of the block; the end, the two cheeks of the sector; of the countersink none.
    let expected = [("cone", 2), ("cylinder", 2), ("plane", 9), ("sphere", 1)];
    assert_eq!(kinds(&part), expected);
    let body = |p: Vector| {
        let block = in_box(p, [-30.0, -20.0, 0.0], [30.0, 20.0, 12.0])
            && !turned(p, [-18.0, 0.0, -1.0], Z, 20.0, |_| 4.0)
            && !turned(p, [-18.0, 0.0, 8.0], Z, 5.0, |h| 4.0 + h)
            && distance(p, [0.0, 0.0, 14.0]) > 7.0
            && !turned(p, [0.0, -14.0, 6.0], Z, 7.0, |h| 5.0 * h / 6.0);
        let angle = p[1].atan2(p[0] - 18.0).rem_euclid(TAU);
        let sector =
            turned(p, [18.0, 0.0, 12.0 - 1e-9], Z, 16.0, |_| 9.0) && angle < 250.0_f64.to_radians();
        block || sector
    };
    agrees(&part, 0, &body);
}

#[test]
fn the_nut_has_six_hyperbolas() {
    let part = step("nut");
    assert_eq!(kinds(&part), [("cone", 1), ("cylinder", 1), ("plane", 8)]);
    let spread = (TAU / 12.0).tan();
    let body = |p: Vector| {
        let sides = (0..6).all(|k| {
            let angle = TAU * (f64::from(k) + 0.5) / 6.0;
            p[0] * angle.cos() + p[1] * angle.sin() < 10.0
        });
        let from_axis = p[0].hypot(p[1]);
        sides
            && (0.0..8.0).contains(&p[2])
            && from_axis > 5.0
            && from_axis < 20.0 - (p[2] - 2.0).max(0.0) / spread
    };
    agrees(&part, 0, &body);
}

#[test]
fn cavities_are_turned_inside_out() {
    let part = step("hollow");
    assert_eq!(kinds(&part), [("cylinder", 1), ("plane", 8), ("sphere", 1)]);
    let body = |p: Vector| {
        in_box(p, [0.0; 3], [30.0, 20.0, 10.0])
            && distance(p, [8.0, 10.0, 5.0]) > 4.0
            && !turned(p, [20.0, 10.0, 2.0], Z, 6.0, |_| 3.0)
    };
    agrees(&part, 0, &body);
}

#[test]
fn parts_of_an_assembly_are_where_they_are_placed() {
    const INCH: f64 = 25.4;
    let part = step("stand");
    let inches = |v: Vector| times(INCH, v);
    let solids = part.model.solids.iter();
    let solids = solids.map(|s| (s.name.as_str(), s.material.as_str()));
    // 0.15, 0.3, 0.6; 0.8, 0.2, 0.1; 0.5, 0.55, 0.6 times 255.
    let expected = [
        ("plate", "#264c99"),
        ("ball", "#cc3319"),
        ("pin", "#808c99"),
        ("pin 2", "#808c99"),
        ("pin 3", "#808c99"),
    ];
    assert_eq!(solids.collect::<Vec<_>>(), expected);
    let plate = |p: Vector| {
        in_box(p, inches([-1.5, -1.0, 0.0]), inches([1.5, 1.0, 0.25]))
            && !turned(p, [0.0, 0.0, -1.0], Z, 26.0, |_| 0.375 * INCH)
    };
    let ball = |p: Vector| distance(p, inches([0.0, 0.0, 0.5])) < 0.5 * INCH;
    let pin = |foot: Vector, axis: Vector| {
        move |p: Vector| {
            turned(p, inches(foot), axis, INCH, |h| {
                0.25 * INCH - (h - 0.75 * INCH).max(0.0) * 0.5
            })
        }
    };
    agrees(&part, 0, &plate);
    agrees(&part, 1, &ball);
    agrees(&part, 2, &pin([-1.0, 0.0, 0.25], Z));
    agrees(&part, 3, &pin([1.0, 0.0, 0.25], Z));
    agrees(&part, 4, &pin([0.0, 0.75, 0.75], X));
}

#[test]
fn a_flange_is_its_plate_and_boss_less_seven_holes() {
    let part = step("flange");
    assert_eq!(kinds(&part), [("cylinder", 9), ("plane", 3)]);
    let body = |p: Vector| {
        let whole =
            turned(p, [0.0; 3], Y, 10.0, |_| 50.0) || turned(p, [0.0; 3], Y, 30.0, |_| 22.0);
        let bore = turned(p, [0.0, -1.0, 0.0], Y, 40.0, |_| 12.0);
        let hole = (0..6).any(|k| {
            let angle = TAU * (f64::from(k) + 0.5) / 6.0;
            let foot = [38.0 * angle.cos(), -1.0, 38.0 * angle.sin()];
            turned(p, foot, Y, 12.0, |_| 4.5)
        });
        whole && !bore && !hole
    };
    agrees(&part, 0, &body);
}

#[test]
fn a_cross_drilled_pin_is_off_by_no_more_than_it_says() {
    let part = step("cross-drilled");
    assert_eq!(kinds(&part), [("cylinder", 2), ("plane", 2)]);
    let faces = faces(&part, 0).iter();
    let off = faces.filter(|face| matches!(face.verdict, Verdict::Approximated(_)));
    assert_eq!(off.count(), 2);
    let body =
        |p: Vector| turned(p, [0.0, -30.0, 0.0], Y, 60.0, |_| 20.0) && p[0].hypot(p[1]) > 8.0;
    agrees(&part, 0, &body);
}

/// The same parts as face lists: as many faces of every kind, on the same surfaces, with the same verdicts, the body
/// on the same side and the same points kept.
#[test]
fn step_files_and_face_lists_of_the_same_part_agree() {
    for name in ["flange", "fillet", "cross-drilled"] {
        let list = file(&format!("parts/{name}.faces.toml"));
        let one = compile(&list, name, &EACH_FACE).unwrap();
        let other = step(name);
        assert_eq!(kinds(&one), kinds(&other), "{name}");
        let (ours, theirs) = (compiled(&one, 0), compiled(&other, 0));
        for (face, verdict, cells) in &ours {
            let place = format!("{name}, {}", face.name);
            let is_same = |(other, ..): &&(&Face, _, _)| other.surface.same(&face.surface, 1e-9);
            let same: Vec<_> = theirs.iter().filter(is_same).collect();
            if face.surface.is_torus() {
                let (_, twins, twin_cells) = same[0];
                assert!(matches!(verdict, Verdict::Approximated(_)), "{place}");
                assert_eq!((twins, twin_cells.len()), (verdict, cells.len()), "{place}");
                continue;
            }
            let [(twin, twins, twin_cells)] = same[..] else {
                panic!("{place}: {} faces on its surface", same.len())
            };
            let off = match (verdict, twins) {
                (Verdict::Exact, Verdict::Exact) => 0.0,
                (Verdict::Approximated(one), Verdict::Approximated(other)) => one + other,
                others => panic!("{place}: {others:?}"),
            };
            let oracle = Oracle::new(&one.model, face);
            let mut inside = 0;
            for p in oracle.points(3000, 7, off) {
                let mine = kept(&one, cells, p);
                inside += usize::from(mine);
                assert_eq!(kept(&other, twin_cells, p), mine, "{place} at {p:?}");
                let aligned = dot(normal(&twin.surface, p), normal(&face.surface, p)) > 0.0;
                assert_eq!(twin.reversed == face.reversed, aligned, "{place}");
            }
            assert!(inside > 60, "{place}");
        }
    }
}

/// The compiler's second opinion of face lists, for STEP files.
#[test]
fn step_files_agree_with_the_winding_of_their_loops() {
    for name in ["fixture", "nut", "hollow", "stand", "flange"] {
        let part = step(name);
        for solid in 0..part.model.solids.len() {
            for (face, verdict, cells) in compiled(&part, solid) {
                assert_eq!(*verdict, Verdict::Exact);
                let oracle = Oracle::new(&part.model, face);
                for p in oracle.points(1000, 3, 0.0) {
                    let place = format!("{name} {} {p:?}", face.name);
                    assert_eq!(kept(&part, cells, p), oracle.has(p), "{place}");
                }
            }
        }
    }
}

#[test]
fn normals_have_length_one() {
    for name in ["stand", "fixture"] {
        for face in &step(name).model.faces {
            let Surface { axis, ref form, .. } = face.surface;
            if matches!(form, Form::Plane | Form::Cylinder(_)) {
                assert!(distance(unit(axis), axis) < 1e-15);
            }
        }
    }
}
