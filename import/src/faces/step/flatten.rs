//! Splines that border a plane face are in its plane.

use crate::faces::assemble::users;
use crate::faces::curve::Curve;
use crate::faces::model::{COINCIDENT, Edge, Face};
use crate::faces::surface::Surface;
use crate::faces::vector::{distance, dot, length, minus, onto_plane};

/// Brings splines that border a plane face into its plane, within what the file takes for the same place.
pub fn flatten(edges: &mut [Edge], faces: &[Face], uncertainty: f64) {
    let users = users(edges.len(), faces);
    for (edge, users) in edges.iter_mut().zip(users) {
        let Curve::Points {
            points,
            plane: plane @ None,
            ..
        } = &mut edge.curve
        else {
            continue;
        };
        let size = points
            .iter()
            .map(|p| length(*p).max(distance(*p, points[0])))
            .fold(0.0, f64::max);
        let tolerance = uncertainty.max(COINCIDENT * size);
        let flat = users.iter().find_map(|face| match faces[*face].surface {
            Surface::Plane { origin, normal } => points
                .iter()
                .all(|p| dot(minus(*p, origin), normal).abs() <= tolerance)
                .then_some((origin, normal)),
            _ => None,
        });
        if let Some((origin, normal)) = flat {
            for p in points {
                *p = onto_plane(*p, origin, normal);
            }
            *plane = Some((origin, normal));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::faces::model::EdgeUse;

    /// A wave in the plane z = 2, off by up to 1e-5, as the border of a face in that plane.
    fn wave(surface: Surface) -> (Vec<Edge>, Vec<Face>) {
        let point = |k: i32| {
            let x = f64::from(k) / 10.0;
            [x, x.sin(), 2.0 + 1e-5 * (7.0 * x).cos()]
        };
        let curve = Curve::through((0..=30).map(point).collect(), false, 1e-9);
        assert!(curve.plane().is_none());
        let edge = Edge {
            name: "#1".into(),
            kind: "points",
            curve,
            vertices: Some([0, 1]),
        };
        let edge_use = EdgeUse {
            edge: 0,
            forward: true,
        };
        let face = Face {
            name: "#2".into(),
            surface,
            loops: vec![vec![edge_use]],
            reversed: false,
            refused: None,
        };
        (vec![edge], vec![face])
    }

    #[test]
    fn what_the_file_takes_for_in_the_plane_is_in_the_plane() {
        let plane = Surface::Plane {
            origin: [0.0, 0.0, 2.0],
            normal: [0.0, 0.0, -1.0],
        };
        for (uncertainty, flat) in [(1e-4, true), (1e-6, false)] {
            let (mut edges, faces) = wave(plane.clone());
            flatten(&mut edges, &faces, uncertainty);
            assert_eq!(edges[0].curve.plane().is_some(), flat);
            let heights = edges[0].curve.sampled(1).into_iter().map(|p| p[2]);
            assert_eq!(heights.into_iter().all(|z| z == 2.0), flat);
        }
        let ball = Surface::Sphere {
            centre: [0.0; 3],
            radius: 2.0,
        };
        let (mut edges, faces) = wave(ball);
        flatten(&mut edges, &faces, 1.0);
        assert!(edges[0].curve.plane().is_none());
    }
}
