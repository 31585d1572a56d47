//! Spheres and cylinders as meshes with Phong's normals.

use imogene_scene::{FramedObject, FramedScene, Mesh, Object, Shape};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::f64::consts::TAU;

/// Replaces a sphere, or a circular cylinder along y between two cuts across it, by a mesh with its corners on the
/// surface.
///
/// A sphere has `sides` facets around and half as many, rounded up, from pole to pole. A cylinder has `sides`
/// rectangles, and two ends of triangles with the normal of the end. Corners go round counter-clockwise as seen from
/// outside.
pub fn to_mesh(object: &mut Object, sides: usize) {
    object.shape = Shape::Mesh(match &object.shape {
        Shape::Sphere { radius } => sphere(*radius, sides),
        Shape::EllipticCylinder { radii } => {
            let ends = object.cuts.iter().map(|cut| cut.point[1]);
            let low = ends.clone().fold(f64::INFINITY, f64::min);
            cylinder(*radii, [low, ends.fold(low, f64::max)], sides)
        }
        _ => unreachable!("paraboloids draw spheres and cylinders alone"),
    });
    object.processor = None;
    object.cuts.clear();
}

/// Nine digits after the point: a decimal that is read back as it is written.
fn short(v: f64) -> f64 {
    (v * 1e9).round() / 1e9
}

/// Angle number `k` of `n` around y, from z to x.
fn direction(k: usize, n: usize) -> [f64; 2] {
    let (x, z) = (TAU * k as f64 / n as f64).sin_cos();
    [x, z]
}

fn sphere(radius: f64, sides: usize) -> Mesh {
    let bands = sides.div_ceil(2).max(2);
    let mut mesh = Mesh::default();
    let mut push = |normal: [f64; 3]| {
        mesh.vertices.push(normal.map(|v| short(radius * v)));
        mesh.normals.push(normal.map(short));
    };
    push([0.0, 1.0, 0.0]);
    for band in 1..bands {
        let (across, along) = (0.5 * TAU * band as f64 / bands as f64).sin_cos();
        for k in 0..sides {
            let [x, z] = direction(k, sides);
            push([across * x, along, across * z]);
        }
    }
    push([0.0, -1.0, 0.0]);
    let at = |ring: usize, k: usize| 1 + ring * sides + k % sides;
    let (last_ring, south) = (bands - 2, 1 + (bands - 1) * sides);
    for k in 0..sides {
        mesh.faces.push(vec![0, at(0, k), at(0, k + 1)]);
        for ring in 0..last_ring {
            let below = ring + 1;
            mesh.faces.push(vec![
                at(ring, k),
                at(below, k),
                at(below, k + 1),
                at(ring, k + 1),
            ]);
        }
        mesh.faces
            .push(vec![at(last_ring, k + 1), at(last_ring, k), south]);
    }
    mesh
}

fn cylinder(radii: [f64; 2], [low, high]: [f64; 2], sides: usize) -> Mesh {
    let mut mesh = Mesh::default();
    // The wall with its own normals, then each end.
    for (y, end) in [
        (high, None),
        (low, None),
        (high, Some(1.0)),
        (low, Some(-1.0)),
    ] {
        for k in 0..sides {
            let [x, z] = direction(k, sides);
            mesh.vertices
                .push([short(radii[0] * x), y, short(radii[1] * z)]);
            // Of an ellipse the normal leans to the short axis.
            let wall = [short(x * radii[1] / radii[0]), 0.0, short(z)];
            mesh.normals.push(end.map_or(wall, |up| [0.0, up, 0.0]));
        }
    }
    let at = |ring: usize, k: usize| ring * sides + k % sides;
    for k in 0..sides {
        mesh.faces
            .push(vec![at(0, k), at(1, k), at(1, k + 1), at(0, k + 1)]);
    }
    for k in 1..sides - 1 {
        mesh.faces.push(vec![at(2, 0), at(2, k), at(2, k + 1)]);
        mesh.faces.push(vec![at(3, 0), at(3, k + 1), at(3, k)]);
    }
    mesh
}

/// Leaves out the facets of closed meshes that are turned away from the viewer, or seen edge-on, in a view along z;
/// what is seen stays. The number of facets before.
pub fn drop_turned_away(scene: &mut FramedScene) -> usize {
    let mut faces = 0;
    for object in &mut scene.objects {
        if let FramedObject::Mesh(mesh) = object {
            faces += mesh.facets.len();
            let vertices = std::mem::take(&mut mesh.vertices);
            mesh.facets
                .retain(|facet| is_seen(&vertices, &facet.corners));
            mesh.vertices = vertices;
        }
    }
    faces
}

/// True if the corners go round counter-clockwise on the screen, whose y is downwards.
fn is_seen(vertices: &[[BigRational; 3]], corners: &[usize]) -> bool {
    let place = |k: usize| {
        let [x, y, _] = &vertices[corners[k % corners.len()]];
        (x, y)
    };
    let area = (0..corners.len()).fold(BigRational::zero(), |sum, k| {
        let ((x, y), (u, v)) = (place(k), place(k + 1));
        sum + x * v - u * y
    });
    area.is_negative()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

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
            assert!(
                sides < 20 || volume > 0.95 * full,
                "{sides}: {volume} of {full}"
            );

            let rod = cylinder([2.0, 2.0], [-1.5, 1.0], sides);
            assert_closed(&rod);
            // A prism over a regular polygon.
            let n = sides as f64;
            let prism = 6.0 * 2.5 * 0.5 * n * 4.0 * (TAU / n).sin();
            assert!(
                (sixfold_volume(&rod) - prism).abs() < 1e-6 * prism,
                "{sides}"
            );
        }
    }
}
