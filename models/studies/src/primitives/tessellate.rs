//! Spheres and cylinders as meshes with Phong's normals.

use imogene_scene::{FramedObject, FramedScene, Mesh, Object, Shape};
use num_rational::BigRational;
use num_traits::Signed;
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
        Shape::EllipticCylinder(radii) => {
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

/// A sphere about the origin with `sides` facets around and half as many, rounded up, from pole to pole.
pub fn sphere(radius: f64, sides: usize) -> Mesh {
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

/// A cylinder along y from `low` to `high`, with these radii along x and z and `sides` rectangles around.
pub fn cylinder(radii: [f64; 2], [low, high]: [f64; 2], sides: usize) -> Mesh {
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
            let vertex = [short(radii[0] * x), y, short(radii[1] * z)];
            mesh.vertices.push(vertex);
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
            let vertices = &mesh.vertices;
            // Seen are corners that go round counter-clockwise on the screen, whose y is downwards.
            mesh.facets.retain(|facet| {
                let corners = facet.corners.iter().map(|&k| &vertices[k]);
                let next = corners.clone().cycle().skip(1);
                let turn =
                    |([x, y, _], [u, v, _]): (&[BigRational; 3], &[BigRational; 3])| x * v - u * y;
                let area: BigRational = corners.zip(next).map(turn).sum();
                area.is_negative()
            });
        }
    }
    faces
}
