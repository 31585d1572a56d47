use imogene_scene::Mesh;
use imogene_studies::primitives::tessellate::{cylinder, sphere};
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Six times the volume inside, positive if the corners go round counter-clockwise.
fn sixfold_volume(mesh: &Mesh) -> f64 {
    let corner = |k: usize| mesh.vertices[k];
    let triangle = |[p, q, r]: [[f64; 3]; 3]| {
        p[0] * (q[1] * r[2] - q[2] * r[1])
            + p[1] * (q[2] * r[0] - q[0] * r[2])
            + p[2] * (q[0] * r[1] - q[1] * r[0])
    };
    let face = |face: &Vec<usize>| -> f64 {
        let pairs = face[1..].windows(2);
        pairs
            .map(|pair| triangle([face[0], pair[0], pair[1]].map(corner)))
            .sum()
    };
    mesh.faces.iter().map(face).sum()
}

/// Every side of a face is that of one other, the other way round.
fn assert_closed(mesh: &Mesh) {
    let mut sides: HashMap<[String; 2], i32> = HashMap::new();
    for face in &mesh.faces {
        for k in 0..face.len() {
            // Corners of the wall and of the ends are different vertices at the same place.
            let place = |k: usize| format!("{:?}", mesh.vertices[face[k % face.len()]]);
            let (from, to) = (place(k), place(k + 1));
            assert_ne!(from, to);
            *sides.entry([from.clone(), to.clone()]).or_default() += 1;
            *sides.entry([to, from]).or_default() -= 1;
        }
    }
    assert!(sides.values().all(|&count| count == 0));
}

#[test]
fn meshes_are_closed_turned_outwards_and_nearly_as_large() {
    for sides in [3, 4, 7, 8, 20, 25] {
        let ball = sphere(2.0, sides);
        assert_closed(&ball);
        let full = 6.0 * 4.0 / 3.0 * 0.5 * TAU * 8.0;
        let volume = sixfold_volume(&ball);
        assert!(volume > 0.0 && volume < full, "{sides}: {volume} of {full}");
        let near = sides < 20 || volume > 0.95 * full;
        assert!(near, "{sides}: {volume} of {full}");

        let rod = cylinder([2.0, 2.0], [-1.5, 1.0], sides);
        assert_closed(&rod);
        // A prism over a regular polygon.
        let n = sides as f64;
        let prism = 6.0 * 2.5 * 0.5 * n * 4.0 * (TAU / n).sin();
        let off = (sixfold_volume(&rod) - prism).abs();
        assert!(off < 1e-6 * prism, "{sides}");
    }
}
