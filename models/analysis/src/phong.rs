//! Phong shading of a decided frame, in software (source: 1.2.4).
//!
//! `I = ka Ia C + F sum_j Ij (kd C (N.L_j) + ks (R_j.V)^n)` with unit vectors in the camera frame, at the point before
//! perspective. `F = k / (d + k)` where light is halved at a distance k from the eye, else 1. Surfaces are two-sided:
//! the normal is turned towards the viewer.

use imogene_algebra::vector::{Vector, dot, length, unit};
use imogene_golden::format::Format;
use imogene_golden::machine::frame::{Frame, FrameLayer};
use imogene_golden::machine::lighting::{ALL_SOURCES, Lighting};
use imogene_scene::FramedScene;
use rayon::prelude::*;

/// The picture of a frame: 8-bit red, green, blue of every pixel, row-major. A source that does not reach a pixel adds
/// nothing there. Transparent objects are blended over it in the order of their depths.
pub fn shade(frame: &Frame, lighting: &Lighting, scene: &FramedScene, format: &Format) -> Vec<u8> {
    let scale = scene.projection.full_depth() / format.z_max() as f64;
    let pixel = |index: usize| -> [u8; 3] {
        let [x, y] = scene.pixel_centre(index % frame.width, index / frame.width);
        let [u, v] = scene.sample_at;
        let at = |object: usize, depth: i64, normal: [i16; 3], flags: u16| -> Vector {
            let depth = depth as f64 * scale;
            let point = scene.projection.antecedent([x + u, y + v], depth);
            let normal = scene.upright(normal.map(f64::from));
            colour(scene, object, point, normal, flags).map(|v| v.clamp(0.0, 1.0))
        };
        let (normal, flags) = (frame.normal[index], lighting.flags[index]);
        let mut seen = match usize::try_from(frame.id[index]) {
            Ok(id) => at(id, frame.depth[index], normal, flags),
            Err(_) => scene.background.map(|v| f64::from(v) / 255.0),
        };
        for layer in before(frame, index) {
            let (depth, normal) = (layer.depth[index], layer.normal[index]);
            let front = at(layer.object, depth, normal, ALL_SOURCES);
            let weight = f64::from(layer.weight) / 255.0;
            seen = std::array::from_fn(|k| weight * front[k] + (1.0 - weight) * seen[k]);
        }
        seen.map(|v| (v * 255.0).round() as u8)
    };
    let pixels = (0..frame.depth.len()).into_par_iter();
    pixels.flat_map_iter(pixel).collect()
}

/// The transparent objects before what is seen, the farthest first; of two at one depth the earlier is nearer.
fn before(frame: &Frame, index: usize) -> Vec<&FrameLayer> {
    let nearer = |layer: &&FrameLayer| layer.depth[index] < frame.depth[index];
    let mut layers: Vec<&FrameLayer> = frame.layers.iter().filter(nearer).collect();
    layers.sort_by_key(|layer| std::cmp::Reverse((layer.depth[index], layer.object)));
    layers
}

fn colour(scene: &FramedScene, object: usize, point: Vector, normal: Vector, flags: u16) -> Vector {
    let material = &scene.materials[scene.objects[object].material()];
    let to_eye = scene.projection.towards_viewer(point);
    let part = (scene.attenuation).map_or(1.0, |half| half / (length(to_eye) + half));
    let viewer = unit(to_eye);
    // The apex of a cone has no normal.
    let normal = unit(normal);
    let turn = if dot(normal, viewer) < 0.0 { -1.0 } else { 1.0 };
    let normal = normal.map(|v| turn * v);
    let mut sum: Vector =
        std::array::from_fn(|k| material.ambient * scene.ambient[k] * material.colour[k]);
    for (source, light) in scene.lights.iter().enumerate() {
        if flags >> source & 1 == 0 {
            continue;
        }
        let direction = light.towards(point);
        let lambert = dot(normal, direction);
        if lambert <= 0.0 {
            continue;
        }
        let mirrored: Vector = std::array::from_fn(|k| 2.0 * lambert * normal[k] - direction[k]);
        let along = dot(mirrored, viewer).max(0.0);
        let highlight = along.powi(material.exponent as i32);
        for (k, sum) in sum.iter_mut().enumerate() {
            *sum += part
                * light.colour[k]
                * (material.diffuse * material.colour[k] * lambert + material.specular * highlight);
        }
    }
    sum
}
