use imogene_studies::evaluate::work::pixel::{FACET, ball, facet, patch, solid};
use imogene_studies::evaluate::work::quadric::Kind;

fn at([a, b, c]: [f64; 3], x: f64, y: f64) -> f64 {
    a * x + b * y + c
}

/// Every pixel by direct evaluation and intersection of half-spaces, without differences and without a chain. The
/// numbers are whole or quarters and below 2^20, so that differences and values are the same.
#[test]
fn scans_find_what_direct_evaluation_finds() {
    let side = 40;
    let object = ball(side, 4);
    let solid = solid(side, &object);
    let patch = patch(side, &object);
    assert!(patch.pixels.iter().all(|&count| count > 300));
    for (index, (solid, patch)) in solid.depths.iter().zip(&patch.depths).enumerate() {
        let (x, y) = ((index as u64 % side) as f64, (index as u64 / side) as f64);
        let terms = [x * x, y * y, x * y, x, y, 1.0];
        let f2: f64 = object.f2.iter().zip(terms).map(|(v, t)| v * t).sum();
        let faces = [-1.0, 1.0].map(|sign| at(object.f1, x, y) + sign * f2.sqrt());
        let sides = |kind: Kind| {
            let planes = object.planes.iter().filter(move |(k, _)| *k == kind);
            planes.map(move |(_, e)| at(*e, x, y))
        };
        let open = f2 >= 0.0 && sides(Kind::Perpendicular).all(|v| v >= 0.0);
        let near = sides(Kind::Front).fold(f64::NEG_INFINITY, f64::max);
        let far = sides(Kind::Back).fold(f64::INFINITY, f64::min);
        let (front, back) = (faces[0].max(near), faces[1].min(far));
        let expected = (open && front <= back).then_some(front);
        assert_eq!(*solid, expected, "{x} {y}");
        let face = faces.into_iter().find(|&z| open && near <= z && z <= far);
        assert_eq!(*patch, face, "{x} {y}");
    }
}

#[test]
fn a_facet_covers_the_pixels_within_its_sides() {
    let found = facet(20, FACET);
    // Half of the box with the diagonal.
    assert_eq!(found.pixels, [190, 210]);
    for (index, depth) in found.depths.iter().enumerate() {
        let (x, y) = ((index % 20) as f64, (index / 20) as f64);
        let expected = (x + y <= 19.0).then(|| at(FACET[3], x, y));
        assert_eq!(*depth, expected);
    }
}
