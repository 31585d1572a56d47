//! Compiled cells against a second opinion: winding numbers of the loops in the parameters of the surface, and random
//! sectors whose inside is known.

use crate::common::list::{self, HEAD, arc, circle, faces, line, off, part, solid};
use crate::common::points::{Even, kept, point_of};
use crate::common::says;
use crate::common::winding::Oracle;
use imogene_import::faces::vector::{Vector, along, cross, dot, frame, minus, plus, times, unit};
use imogene_import::faces::{Cell, Part, Verdict};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Points of a face.
const POINTS: usize = 2500;

/// A point of an axis, or the centre of a sphere.
const ORIGIN: Vector = [0.3, -0.7, 1.1];

fn cells(part: &Part, name: &str) -> (Verdict, Vec<Cell>) {
    for (index, solid) in part.model.solids.iter().enumerate() {
        for (face, compiled) in solid.faces.iter().zip(faces(part, index)) {
            if part.model.faces[*face].name == name {
                return (compiled.verdict.clone(), compiled.cells.clone());
            }
        }
    }
    panic!("no face {name}")
}

/// All drawn faces of a part against the winding of their loops, at points farther than the verdict's deviation from
/// every edge; adds up the points by kind of surface.
fn compare(part: &Part, points: usize, kinds: &mut BTreeMap<String, usize>) {
    for face in &part.model.faces {
        let (verdict, cells) = cells(part, &face.name);
        if matches!(verdict, Verdict::Rejected(_)) {
            continue;
        }
        let off = off(&verdict);
        let oracle = Oracle::new(&part.model, face);
        let mut inside = 0;
        // Of an exact face only the sagitta of the oracle's own polylines is left out.
        for p in oracle.points(points, face.name.len() as u64, off) {
            let expected = oracle.has(p);
            inside += usize::from(expected);
            *kinds.entry(face.surface.name().to_owned()).or_default() += 1;
            let place = format!("face {} at {p:?}, {verdict:?}", face.name);
            assert_eq!(kept(part, &cells, p), expected, "{place}");
        }
        assert!(inside > points / 50, "{}: {inside} inside", face.name);
    }
}

fn shipped(name: &str) -> String {
    list::text(&format!("parts/{name}.faces.toml"))
}

#[test]
fn shipped_parts_agree_with_the_winding_of_their_loops() {
    let mut kinds = BTreeMap::new();
    for name in "flange bracket ball-joint fillet volumes curved-plate".split(' ') {
        compare(&part(&shipped(name), 0.0), POINTS, &mut kinds);
    }
    assert_eq!(kinds.len(), 4);
    let enough = kinds.values().all(|points| *points >= 2 * POINTS);
    assert!(enough, "{kinds:?}");
}

#[test]
fn approximated_borders_are_off_by_no_more_than_they_say() {
    for asked in [0.3, 0.05] {
        let part = part(&shipped("cross-drilled"), asked);
        for name in ["side", "hole"] {
            let verdict = cells(&part, name).0;
            assert!(matches!(verdict, Verdict::Approximated(off) if off <= asked));
        }
        compare(&part, POINTS, &mut BTreeMap::new());
    }
}

#[test]
fn a_deviation_that_is_not_allowed_rejects_the_face() {
    let part = part(&shipped("cross-drilled"), 0.0);
    for name in ["side", "hole"] {
        let (Verdict::Rejected(why), cells) = cells(&part, name) else {
            panic!("{name} is drawn")
        };
        says(why, "planar pieces");
        assert!(cells.is_empty());
    }
    assert_eq!(cells(&part, "lid").0, Verdict::Exact);
}

/// A frame from three angles, so that nothing is along a coordinate axis.
fn turned(angles: [f64; 3]) -> [Vector; 3] {
    let axis = unit([angles[0].cos(), angles[0].sin(), angles[1]]);
    let [e, f] = frame(axis, angles[2]);
    [e, f, axis]
}

/// Writes the sides of a polygon with the corners `p0`, `p1`, ..; their names.
fn sides(text: &mut String, count: u32) -> String {
    let side = |k: u32| {
        let ends = [k, (k + 1) % count].map(|k| format!("p{k}"));
        *text += &line(&format!("e{k}"), &ends[0], &ends[1]);
        format!("\"e{k}\"")
    };
    (0..count).map(side).collect::<Vec<_>>().join(", ")
}

/// The only face.
fn face(surface: &str, loops: &str) -> String {
    list::face("face", surface, loops) + &solid("'face'")
}

/// A sector of a cylinder or cone between two heights on it, from the angle `from` over `sweep`.
fn sector(
    [e, f, axis]: [Vector; 3],
    at: impl Fn(f64) -> f64,
    [low, high]: [f64; 2],
    from: f64,
    sweep: f64,
    surface: &str,
) -> String {
    let point = |angle: f64, height: f64| {
        let out = plus(times(angle.cos(), e), times(angle.sin(), f));
        along(along(ORIGIN, height, axis), at(height), out)
    };
    let mut text = format!("{HEAD}[vertices]\n");
    for (name, angle, height) in [
        ("a", from, low),
        ("b", from + sweep, low),
        ("c", from + sweep, high),
        ("d", from, high),
    ] {
        text += &format!("{name} = {:?}\n", point(angle, height));
    }
    let parallel = |name, height| circle(name, along(ORIGIN, height, axis), axis, at(height));
    text += &arc(parallel("low", low), "a", "b");
    text += &arc(parallel("high", high), "d", "c");
    text += &line("left", "a", "d");
    text += &line("right", "b", "c");
    text + &face(surface, "[[\"low\", \"right\", \"-high\", \"-left\"]]")
}

/// The cells of the only face of a part, which keep of its surface what is between two heights and over an angle.
fn sector_cells(
    part: &Part,
    [e, f, axis]: [Vector; 3],
    [low, high]: [f64; 2],
    [from, sweep]: [f64; 2],
    size: f64,
    mut even: Even,
) -> Result<Vec<Cell>, TestCaseError> {
    let (verdict, cells) = cells(part, "face");
    prop_assert_eq!(verdict, Verdict::Exact);
    for _ in 0..1000 {
        let p = point_of(&part.model.faces[0].surface, ORIGIN, size, &mut even);
        let [x, y, height] = [e, f, axis].map(|d| dot(minus(p, ORIGIN), d));
        let turned = (y.atan2(x) - from).rem_euclid(TAU);
        let round = [0.0, sweep, TAU].map(|end| turned - end);
        let up = [low, high].map(|end| height - end);
        if round.iter().chain(&up).any(|d| d.abs() < 1e-9) {
            continue;
        }
        // On the other nappe of a cone the height is negative.
        let expected = turned < sweep && (low..high).contains(&height);
        let kept = kept(part, &cells, p);
        prop_assert_eq!(kept, expected, "{:?} {} {}", p, turned, height);
    }
    Ok(cells)
}

fn angles() -> impl Strategy<Value = [f64; 3]> {
    [0.0..TAU, -2.0..2.0, 0.0..TAU]
}

/// Convex polygons of more corners than an object has cut planes, with and without a round hole: halved until they have
/// not.
#[test]
fn convex_polygons_of_many_corners() {
    for (count, hole) in [(11, false), (24, false), (24, true), (60, false)] {
        let mut text = format!("{HEAD}[vertices]\n");
        for k in 0..count {
            let angle = TAU * f64::from(k) / f64::from(count);
            text += &format!("p{k} = [{:?}, {:?}, 0.5]\n", angle.cos(), angle.sin());
        }
        let sides = sides(&mut text, count);
        text += &circle("hole", [0.1, 0.2, 0.5], [0.0, 0.0, 1.0], 0.3);
        let inner = if hole { ", [\"-hole\"]" } else { "" };
        let plane = "kind = \"plane\", origin = [0, 0, 0.5], normal = [0, 0, 1]";
        text += &face(plane, &format!("[[{sides}]{inner}]"));
        let part = part(&text, 0.0);
        let (verdict, cells) = cells(&part, "face");
        assert_eq!(verdict, Verdict::Exact, "{count}");
        assert!(cells.iter().all(|cell| cell.cuts.len() <= 10));
        let mut even = Even(5);
        for _ in 0..3000 {
            let (x, y) = (2.2 * (even.next() - 0.5), 2.2 * (even.next() - 0.5));
            // The polygon is inside all its sides.
            let inner = (TAU / f64::from(2 * count)).cos();
            let reach = (0..count).map(|k| {
                let angle = TAU * (f64::from(k) + 0.5) / f64::from(count);
                x * angle.cos() + y * angle.sin()
            });
            let reach = reach.fold(f64::MIN, f64::max);
            let from_hole = (x - 0.1).hypot(y - 0.2) - 0.3;
            if (reach - inner).abs() < 1e-7 || from_hole.abs() < 1e-7 {
                continue;
            }
            let expected = reach < inner && !(hole && from_hole < 0.0);
            let kept = kept(&part, &cells, [x, y, 0.5]);
            assert_eq!(kept, expected, "{count}: {x} {y}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// One plane through both generators, whatever the angle, below or above 180 degrees.
    #[test]
    fn sectors_of_cylinders(angles in angles(), from in 0.0..TAU, sweep in 0.2..6.0_f64, low in -3.0..0.0, high in 0.5..4.0_f64) {
        let frame = turned(angles);
        let surface = format!("kind = \"cylinder\", origin = {ORIGIN:?}, axis = {:?}, radius = 1.5", frame[2]);
        let part = part(&sector(frame, |_| 1.5, [low, high], from, sweep, &surface), 0.0);
        let cells = sector_cells(&part, frame, [low, high], [from, sweep], 6.0, Even(1))?;
        prop_assert_eq!(cells.len(), 1);
        prop_assert_eq!(cells[0].cuts.len(), 3);
    }

    /// A plane through the apex and two generators flips its side on the other nappe: a plane between the nappes keeps
    /// that off.
    #[test]
    fn sectors_of_cones(angles in angles(), from in 0.0..TAU, sweep in 0.2..6.0_f64, low in 0.1..1.0_f64, length in 0.5..4.0_f64, degrees in 5.0..80.0_f64) {
        let frame = turned(angles);
        let slope = degrees.to_radians().tan();
        let high = low + length;
        let surface = format!("kind = \"cone\", apex = {ORIGIN:?}, axis = {:?}, half_angle = {degrees:?}", frame[2]);
        let part = part(&sector(frame, |h| h * slope, [low, high], from, sweep, &surface), 0.0);
        let cells = sector_cells(&part, frame, [low, high], [from, sweep], 4.0, Even(2))?;
        prop_assert_eq!(cells.len(), 1);
        prop_assert!(cells[0].cuts.len() <= 4);
    }

    /// A zone between two latitudes and a lune between two meridians, together: AND up to 180 degrees, two patches
    /// above.
    #[test]
    fn spherical_quadrangles(angles in angles(), from in 0.0..TAU, sweep in 0.3..6.0_f64, low in -1.2..0.0, high in 0.2..1.3_f64) {
        let [e, f, axis] = turned(angles);
        let radius = 2.0;
        let point = |u: f64, v: f64| {
            let out = plus(times(u.cos(), e), times(u.sin(), f));
            plus(ORIGIN, times(radius, plus(times(v.cos(), out), times(v.sin(), axis))))
        };
        let mut text = format!("{HEAD}[vertices]\n");
        for (name, u, v) in [("a", from, low), ("b", from + sweep, low), ("c", from + sweep, high), ("d", from, high)] {
            text += &format!("{name} = {:?}\n", point(u, v));
        }
        for (name, ends, v) in [("low", ("a", "b"), low), ("high", ("d", "c"), high)] {
            let parallel = circle(name, along(ORIGIN, radius * v.sin(), axis), axis, radius * v.cos());
            text += &arc(parallel, ends.0, ends.1);
        }
        for (name, ends, u) in [("left", ("a", "d"), from), ("right", ("b", "c"), from + sweep)] {
            let out = plus(times(u.cos(), e), times(u.sin(), f));
            text += &arc(circle(name, ORIGIN, cross(out, axis), radius), ends.0, ends.1);
        }
        let sphere = format!("kind = \"sphere\", centre = {ORIGIN:?}, radius = {radius:?}");
        text += &face(&sphere, "[[\"low\", \"right\", \"-high\", \"-left\"]]");
        let part = part(&text, 0.0);
        let heights = [low, high].map(|v: f64| radius * v.sin());
        let cells = sector_cells(&part, [e, f, axis], heights, [from, sweep], 4.0, Even(3))?;
        if sweep < PI - 0.01 {
            prop_assert_eq!(cells.len(), 1);
            prop_assert_eq!(cells[0].cuts.len(), 4);
        }
    }

    /// Star-shaped polygons of up to 16 corners, convex or not, in any plane.
    #[test]
    fn polygons(angles in angles(), radii in proptest::collection::vec(0.4..3.0_f64, 3..16)) {
        let [e, f, axis] = turned(angles);
        let count = radii.len();
        let corner = |k: usize| {
            let u = TAU * (k % count) as f64 / count as f64;
            (radii[k % count] * u.cos(), radii[k % count] * u.sin())
        };
        let mut text = format!("{HEAD}[vertices]\n");
        for k in 0..count {
            let (x, y) = corner(k);
            text += &format!("p{k} = {:?}\n", along(along(ORIGIN, x, e), y, f));
        }
        let sides = sides(&mut text, count as u32);
        text += &face(&format!("kind = \"plane\", origin = {ORIGIN:?}, normal = {axis:?}"), &format!("[[{sides}]]"));
        let part = part(&text, 0.0);
        let (verdict, cells) = cells(&part, "face");
        prop_assert_eq!(verdict, Verdict::Exact);
        prop_assert!(cells.iter().all(|cell| cell.cuts.len() <= 10));
        let mut even = Even(4);
        for _ in 0..1000 {
            let (x, y) = (8.0 * (even.next() - 0.5), 8.0 * (even.next() - 0.5));
            // The wedge of the corner angles, and the side of its edge.
            let u = y.atan2(x).rem_euclid(TAU);
            let k = ((u / TAU * count as f64) as usize).min(count - 1);
            let ((ax, ay), (bx, by)) = (corner(k), corner(k + 1));
            let side = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
            let wedge = (u - TAU * k as f64 / count as f64).min(TAU * (k + 1) as f64 / count as f64 - u);
            if side.abs() < 1e-7 || wedge < 1e-7 {
                continue;
            }
            let p = along(along(ORIGIN, x, e), y, f);
            prop_assert_eq!(kept(&part, &cells, p), side > 0.0, "{} {}", x, y);
        }
    }
}
