//! Two failures of trimming by the adjacent surfaces (Hanniel and Haller; thesis section II.3.2), and that the
//! compiler does not have them.
//!
//! The naive compiler takes one half-space for each neighbour, its whole surface, on the side on which the face
//! begins, and joins them by one AND or one OR.

use crate::common::list::{self, HEAD, arc, circle, face, faces, line, solid};
use crate::common::points;
use crate::common::winding::Oracle;
use imogene_import::faces::vector::Vector;
use imogene_import::faces::{Part, Verdict};

/// Whether the cells of face 0, solid 0, keep a point of its surface.
fn kept(part: &Part, p: Vector) -> bool {
    let first = &faces(part, 0)[0];
    assert_eq!(first.verdict, Verdict::Exact);
    points::kept(part, &first.cells, p)
}

/// A face in the plane z = 0 whose border runs along the plane A (y = 0) and the cylinder B (radius 1) twice: left of
/// the axis the face is above A AND inside B, right of it above A OR inside B.
fn keyhole() -> String {
    let mut text = HEAD.to_owned();
    text += "[vertices]\nw = [-1, 0, 0]\no = [0, 0, 0]\ns = [0, -1, 0]\ne = [1, 0, 0]\na = [3, 0, 0]\nb = [3, 2, 0]\nc = [0, 2, 0]\nn = [0, 1, 0]\n";
    for name in "wo os ea ab bc cn".split(' ') {
        text += &line(name, &name[..1], &name[1..]);
    }
    for name in ["se", "nw"] {
        let circle = circle(name, [0.0; 3], [0.0, 0.0, 1.0], 1.0);
        text += &arc(circle, &name[..1], &name[1..]);
    }
    let loops = r#"[["wo", "os", "se", "ea", "ab", "bc", "cn", "nw"]]"#;
    let plane = "kind = 'plane', origin = [0, 0, 0], normal = [0, 0, 1]";
    text + &face("keyhole", plane, loops) + &solid("'keyhole'")
}

/// The face itself, from its description.
fn in_keyhole([x, y, _]: Vector) -> bool {
    let inside = x * x + y * y < 1.0;
    if x < 0.0 {
        y > 0.0 && inside
    } else {
        x < 3.0 && y < 2.0 && (y > 0.0 || inside)
    }
}

#[test]
fn one_operator_for_a_pair_of_neighbours_is_not_enough() {
    let part = list::part(&keyhole(), 0.0);
    let oracle = Oracle::new(&part.model, &part.model.faces[0]);
    let (mut and_wrong, mut or_wrong, mut points) = (0, 0, 0);
    for i in 0..200 {
        for j in 0..150 {
            let (x, y) = (-1.7 + 0.0249 * f64::from(i), -1.3 + 0.0241 * f64::from(j));
            let p = [x, y, 0.0];
            if oracle.distance_to_edge(p) < 2.0 * oracle.coarseness() {
                continue;
            }
            let face = in_keyhole(p);
            assert_eq!(oracle.has(p), face, "{p:?}");
            assert_eq!(kept(&part, p), face, "{p:?}");
            // What the other neighbours say is granted; the pair A, B is joined by one operator.
            let (above, inside) = (y > 0.0, x * x + y * y < 1.0);
            let box_of_others = x > -1.0 && x < 3.0 && y < 2.0 && y > -1.0;
            and_wrong += usize::from((box_of_others && above && inside) != face);
            or_wrong += usize::from((box_of_others && (above || inside)) != face);
            points += 1;
        }
    }
    assert!(points > 25_000);
    // The OR is right at the right and wrong at the left, the AND the other way round.
    let are_wrong = and_wrong > points / 10 && or_wrong > points / 50;
    assert!(are_wrong, "{and_wrong} {or_wrong}");
}

/// A plane face between its outer rim and the foot of a fillet: the torus of the fillet, continued beyond its quarter,
/// comes back up through the plane's solid side, and a sign of the whole torus is wrong where only its circle counts.
#[test]
fn a_neighbour_is_not_trusted_beyond_its_extent() {
    // The chamfer cone r = 12 - y from y = 0, where the fillet ends, up to y = 6, where it cuts through the level of
    // the continued torus.
    let mut text = HEAD.to_owned();
    for (name, y, radius) in [
        ("fillet end", 0.0, 12.0),
        ("top", 6.0, 6.0),
        ("fillet start", -2.0, 17.0),
    ] {
        text += &circle(name, [0.0, y, 0.0], [0.0, 1.0, 0.0], radius);
    }
    let cone = "kind = 'cone', apex = [0, 12, 0], axis = [0, -1, 0], half_angle = 45";
    text += &face("chamfer", cone, "[['fillet end'], ['-top']]");
    let torus = "kind = 'torus', centre = [0, 3, 0], axis = [0, 1, 0], major = 10, minor = 4";
    text += &face("fillet", torus, "[['fillet start'], ['-fillet end']]");
    text += &solid("'chamfer', 'fillet'");
    let part = list::part(&text, 0.0);
    let oracle = Oracle::new(&part.model, &part.model.faces[0]);
    let torus = |[x, y, z]: Vector| (x.hypot(z) - 10.0).powi(2) + (y - 3.0).powi(2) - 16.0;
    let (mut naive_wrong, mut points) = (0, 0);
    for i in 0..120 {
        for j in 0..100 {
            let (u, y) = (0.0123 + 0.0523 * f64::from(i), -5.0 + 0.151 * f64::from(j));
            let r = (12.0 - y).abs();
            let p = [r * u.cos(), y, r * u.sin()];
            // The face itself, from its description.
            let face = y > 0.0 && y < 6.0;
            if oracle.distance_to_edge(p) > 2.0 * oracle.coarseness() {
                assert_eq!(oracle.has(p), face, "{p:?}");
                assert_eq!(kept(&part, p), face, "{p:?}");
                // The side of the torus on which the face begins, just above its border.
                let begins = torus([11.99, 0.01, 0.0]) > 0.0;
                naive_wrong += usize::from(((torus(p) > 0.0) == begins && y < 6.0) != face);
                points += 1;
            }
        }
    }
    assert!(points > 10_000);
    assert!(naive_wrong > points / 20, "{naive_wrong} of {points}");
    let fillet = &faces(&part, 0)[1].verdict;
    assert!(matches!(fillet, Verdict::Rejected(why) if why.contains("a deviation of 0")));
}

/// Four fillets of a rounded rectangle: inside all four of their cylinders there is nothing.
#[test]
fn the_cylinders_of_rounded_corners_are_not_trusted_beyond_their_arcs() {
    let part = list::part(&list::text("parts/curved-plate.faces.toml"), 0.0);
    let mut names = part.model.faces.iter().map(|f| &f.name);
    let index = names.position(|name| name == "top").unwrap();
    let oracle = Oracle::new(&part.model, &part.model.faces[index]);
    let corners = [[30.0, 15.0], [30.0, -15.0], [-30.0, -15.0], [-30.0, 15.0]];
    let mut naive_wrong = 0;
    for i in 0..100 {
        for j in 0..70 {
            let (x, z) = (-44.0 + 0.881 * f64::from(i), -28.0 + 0.801 * f64::from(j));
            let near = |[u, w]: &[f64; 2]| (x - u).hypot(z - w) < 10.0;
            let naive = x.abs() < 40.0 && z.abs() < 25.0 && corners.iter().all(near);
            naive_wrong += usize::from(naive != oracle.has([x, 6.0, z]));
        }
    }
    assert!(naive_wrong > 2000, "{naive_wrong}");
}
