//! How far lit-sphere shading is from the shading processor and from its own formula, on the pictures of a scene.

use imogene_algebra::vector::{Vector, dot, length};
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::machine::shader::{ShaderWords, shade_picture};
use imogene_prepare::PreparedScene;
use imogene_prepare::lit_sphere::{SphereForm, far_colour, shadowed_lights, sphere_words};
use imogene_prepare::shader::{ShaderError, material_numbers, shader_words};
use imogene_scene::FramedScene;
use serde::Serialize;

const PLACES: [u32; 4] = [4, 5, 6, 7];

/// Differences of the pixels that show an object, each the greatest of its three levels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct LevelErrors {
    /// Mean.
    pub mean: f64,
    /// What 999 of 1000 pixels stay within.
    pub most_of_1000: u8,
    /// The greatest.
    pub greatest: u8,
}

/// Errors of tables of one size; the keys are stable.
#[derive(Clone, Debug, Serialize)]
pub struct SphereErrors {
    /// Entries along each side.
    pub side: u32,
    /// The nearest entry is the colour.
    pub nearest: bool,
    /// Of the table, against the formula with viewer and lights infinitely far.
    pub table: LevelErrors,
    /// Of all, against the shading processor.
    pub all: LevelErrors,
}

/// The errors of tables of every size, between entries or of the nearest one, on the picture of a scene, with its
/// shadows.
/// Fails when the scene has no words for the shading processor.
pub fn sphere_errors(
    scene: &FramedScene,
    prepared: &PreparedScene,
    nearest: bool,
) -> Result<Vec<SphereErrors>, ShaderError> {
    let format = &prepared.format;
    let mut frame = prepared.frame(|| ());
    frame.layers.clear();
    let materials = material_numbers(scene);
    let lighting = prepared.light(&frame, || ());
    let lights = shadowed_lights(prepared) as u32;
    let picture = |words: &ShaderWords| shade_picture(&frame, &lighting, &materials, words);
    let exact = picture(&shader_words(scene, format)?);
    let far = far_picture(&frame, &lighting, scene, format.z_max());
    let errors = |places| {
        let form = SphereForm { places, nearest };
        let own = picture(&sphere_words(scene, format, form, lights)?);
        Ok(SphereErrors {
            side: 1 << places,
            nearest,
            table: differences(&frame, &own, &far),
            all: differences(&frame, &own, &exact),
        })
    };
    PLACES.into_iter().map(errors).collect()
}

/// The picture by the formula in real numbers, viewer and lights infinitely far.
fn far_picture(frame: &Frame, lighting: &Lighting, scene: &FramedScene, z_max: i64) -> Vec<u8> {
    let scale = scene.projection.full_depth() / z_max as f64;
    let pixel = |index: usize| {
        let Ok(object) = usize::try_from(frame.id[index]) else {
            return scene.background;
        };
        let at = scene.pixel_centre(index % frame.width, index / frame.width);
        let depth = frame.depth[index] as f64 * scale;
        let point = scene.projection.antecedent(at, depth);
        let normal: Vector = frame.normal[index].map(f64::from);
        let turn = dot(normal, scene.projection.towards_viewer(point)).signum();
        let long = length(normal).max(f64::MIN_POSITIVE);
        let normal = normal.map(|part| turn * part / long);
        let material = &scene.materials[scene.objects[object].material()];
        let reaches = |light: usize| lighting.flags[index] >> light & 1 == 1;
        far_colour(scene, material, normal, reaches)
            .map(|level| (level.clamp(0.0, 1.0) * 255.0).round() as u8)
    };
    (0..frame.depth.len()).flat_map(pixel).collect()
}

fn differences(frame: &Frame, own: &[u8], other: &[u8]) -> LevelErrors {
    let pixels = own.chunks_exact(3).zip(other.chunks_exact(3));
    let shown = pixels.zip(&frame.id).filter(|(_, id)| **id >= 0);
    let greatest = |((own, other), _): ((&[u8], &[u8]), _)| {
        let levels = own.iter().zip(other);
        let levels = levels.map(|(own, other)| own.abs_diff(*other));
        levels.max().unwrap_or(0)
    };
    let mut all: Vec<u8> = shown.map(greatest).collect();
    all.sort_unstable();
    let Some(greatest) = all.last().copied() else {
        return LevelErrors::default();
    };
    let sum: u64 = all.iter().map(|level| u64::from(*level)).sum();
    LevelErrors {
        mean: sum as f64 / all.len() as f64,
        most_of_1000: all[(all.len() - 1) * 999 / 1000],
        greatest,
    }
}
