//! Bands of cones against the torus that they stand for: every place of a face has one of its cells within the
//! deviation, and no other place has.

use crate::common::list::{self, HEAD, circle, face, faces, off, solid};
use crate::common::points::kept;
use imogene_import::faces::{Compiled, Part};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const R: f64 = 20.0;
const TUBE: f64 = 5.0;

const Y: [f64; 3] = [0.0, 1.0, 0.0];

/// Faces of one solid.
fn part(edges: &str, faces: &str, names: &str, max_deviation: f64) -> Part {
    let text = format!("{HEAD}{edges}{faces}{}", solid(names));
    list::part(&text, max_deviation)
}

/// A place at the angle u about the y axis and v about the tube, so far from the middle of the tube.
fn place(u: f64, v: f64, from_middle: f64) -> [f64; 3] {
    let out = R + from_middle * v.cos();
    [out * u.cos(), from_middle * v.sin(), -out * u.sin()]
}

/// Cells that have a place within the deviation below the torus, straight down to the middle of the tube.
fn covering(part: &Part, compiled: &Compiled, u: f64, v: f64, off: f64) -> usize {
    let [below, above] = [TUBE - off - 1e-9, TUBE + 1e-9].map(|r| place(u, v, r));
    let has = |cell: &&imogene_import::faces::Cell| {
        let quadric = cell.quadric.unwrap();
        if (quadric.value(below) <= 0.0) == (quadric.value(above) <= 0.0) {
            return false;
        }
        let (mut low, mut high) = (TUBE - off - 1e-9, TUBE + 1e-9);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if (quadric.value(place(u, v, middle)) <= 0.0) == (quadric.value(below) <= 0.0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        kept(part, std::slice::from_ref(*cell), place(u, v, low))
    };
    compiled.cells.iter().filter(has).count()
}

/// Asks places all over the torus, which is the first face; `inside` says which are of the face, `border` how far a
/// place is from its border (radians).
fn agrees(part: &Part, inside: impl Fn(f64, f64) -> bool, border: impl Fn(f64, f64) -> f64) {
    let compiled = &faces(part, 0)[0];
    let off = off(&compiled.verdict);
    let mut counts = [0, 0];
    for i in 0..180 {
        for j in 0..120 {
            let u = TAU * (f64::from(i) + 0.37) / 180.0;
            let v = TAU * (f64::from(j) + 0.41) / 120.0;
            if border(u, v) < 0.03 {
                continue;
            }
            let expected = inside(u, v);
            counts[usize::from(expected)] += 1;
            let found = covering(part, compiled, u, v, off);
            assert_eq!(found > 0, expected, "u {u} v {v}");
        }
    }
    assert!(counts[1] > 300, "{counts:?}");
}

fn torus(loops: &str) -> String {
    let ring = "kind = 'torus', centre = [0, 0, 0], axis = [0, 1, 0]";
    let surface = format!("{ring}, major = {R}, minor = {TUBE}");
    face("tube", &surface, loops)
}

fn apart(a: f64, b: f64) -> f64 {
    ((a - b + PI).rem_euclid(TAU) - PI).abs()
}

#[test]
fn a_whole_ring_is_bands_all_round() {
    for deviation in [0.2, 0.05, 0.01] {
        let part = part("", &torus("[]"), "'tube'", deviation);
        let off = off(&faces(&part, 0)[0].verdict);
        assert!(off <= deviation && off > 0.2 * deviation);
        agrees(&part, |_, _| true, |_, _| 1.0);
    }
}

/// Between the foot of a fillet (v = 270 degrees) and its top (v = 180 degrees), and the other three quarters of the
/// same ring.
#[test]
fn a_fillet_is_a_quarter_and_its_rest_three() {
    let edges = circle("foot", [0.0, -TUBE, 0.0], Y, R) + &circle("top", [0.0; 3], Y, R - TUBE);
    let quarter = |v: f64| v > PI && v < 1.5 * PI;
    let border = |_: f64, v: f64| apart(v, PI).min(apart(v, 1.5 * PI));
    let fillet = part(&edges, &torus("[['-foot'], ['top']]"), "'tube'", 0.02);
    agrees(&fillet, |_, v| quarter(v), border);
    let rest = part(&edges, &torus("[['foot'], ['-top']]"), "'tube'", 0.02);
    agrees(&rest, |_, v| !quarter(v), border);
    let [one, other] = [&fillet, &rest].map(|part| &part.model.faces[0].surface);
    assert!(one.same(other, 0.0));
}

/// A quarter of a ring between two discs, which are polygons of the bands: no gap is left between them.
#[test]
fn an_elbow_and_the_discs_that_close_it_have_the_same_border() {
    // At u = 0 the tube stands on the x axis, at u = 90 degrees on the negative z axis.
    let edges = circle("one", [R, 0.0, 0.0], [0.0, 0.0, 1.0], TUBE)
        + &circle("other", [0.0, 0.0, -R], [1.0, 0.0, 0.0], TUBE);
    let disc = "kind = 'plane', origin = [20, 0, 0], normal = [0, 0, 1]";
    let lid = "kind = 'plane', origin = [0, 0, -20], normal = [-1, 0, 0]";
    let all = torus("[['-one'], ['other']]")
        + &face("disc", disc, "[['one']]")
        + &face("lid", lid, "[['-other']]");
    let elbow = part(&edges, &all, "'tube', 'disc', 'lid'", 0.05);
    let border = |u: f64, _: f64| apart(u, 0.0).min(apart(u, FRAC_PI_2));
    agrees(&elbow, |u, _| u < FRAC_PI_2, border);
    assert_eq!(elbow.model.faces[0].surface.name(), "torus");
    // Beside the disc, just below the bands and just above them.
    let disc = &faces(&elbow, 0)[1];
    let off = off(&disc.verdict);
    for k in 0..720 {
        let v = TAU * (f64::from(k) + 0.3) / 720.0;
        let kept = |r: f64| kept(&elbow, &disc.cells, place(0.0, v, r));
        assert!(kept(TUBE - off - 1e-6) && !kept(TUBE + 1e-6), "v {v}");
    }
}
