use imogene_import::faces::courses::{pieces, refine, trace};
use imogene_import::faces::vector::*;
use imogene_import::faces::{Curve, Form, Surface};

/// Viviani's curve: the sphere of radius 2 and the cylinder of radius 1 through its centre; (1 + cos t, sin t, 2
/// sin t/2).
fn viviani(count: usize) -> (Vec<Vector>, [Surface; 2]) {
    let point = |k: usize| {
        let t = 0.3 + 2.0 * k as f64 / count as f64;
        [1.0 + t.cos(), t.sin(), 2.0 * (0.5 * t).sin()]
    };
    let points = (0..count).map(point).collect();
    let axis = [0.0, 0.0, 1.0];
    let sphere = Surface::new([0.0; 3], axis, Form::Sphere(2.0));
    let cylinder = Surface::new([1.0, 0.0, 0.0], axis, Form::Cylinder(1.0));
    (points, [sphere, cylinder])
}

#[test]
fn pieces_keep_within_what_they_say_and_grow_as_the_square_root() {
    let (points, surfaces) = viviani(200);
    let surfaces: Vec<&Surface> = surfaces.iter().collect();
    let Curve::Points(line) = Curve::through(points, false, 0.0) else {
        unreachable!("a curve through points")
    };
    let refined = refine(&line, &surfaces);
    let mut counts = vec![];
    for asked in [3e-2, 1e-2, 3e-3, 1e-3] {
        let course = pieces(&refined, &surfaces, asked).unwrap();
        assert!(course.deviation <= asked && course.deviation > 0.0);
        counts.push(course.pieces.len());
        // Against the formula of the curve, at ten places between any two of the points.
        for k in 0..2000 {
            let t = 0.3 + 1.989 * f64::from(k) / 2000.0;
            let q = [1.0 + t.cos(), t.sin(), 2.0 * (0.5 * t).sin()];
            for surface in &surfaces {
                let off = course.pieces.iter().filter_map(|piece| {
                    let (origin, normal) = piece.plane().unwrap();
                    let p = trace(q, surface, origin, normal)?;
                    piece.direction_at(p, 0.0).map(|_| distance(p, q))
                });
                let off = off.fold(f64::INFINITY, f64::min);
                // Beside a joint the nearest piece may count as ended.
                let mut ends = course.pieces.iter().flat_map(Curve::ends);
                let joint = ends.any(|end| distance(end, q) < 1e-3);
                assert!(off <= course.deviation || joint, "{off} at {t} for {asked}");
            }
        }
    }
    // The sagitta of a piece goes with the square of its length: sqrt(10) = 3.16 times the pieces for a tenth of
    // the deviation.
    let growth = (counts[3] as f64 / counts[0] as f64).powf(1.0 / 30.0_f64.log10());
    assert!((2.4..=3.9).contains(&growth), "{counts:?}");
}
