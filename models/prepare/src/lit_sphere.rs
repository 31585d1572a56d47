//! Words of lit-sphere shading from a scene (`docs/architecture.md`, section 8.4).

use crate::scene::PreparedScene;
use crate::shader::{ShaderError, shader_words};
use imogene_algebra::vector::{Vector, dot, unit};
use imogene_contract::shading::{MOST_TABLES, TABLE_BITS};
use imogene_golden::format::Format;
use imogene_golden::machine::shader::{ShaderWords, SphereTables};
use imogene_scene::{FramedScene, Material};
use std::fmt;

/// Towards the viewer, who is infinitely far.
const VIEWER: Vector = [0.0, 0.0, -1.0];

/// The form of tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SphereForm {
    /// Bits of a coordinate: a table has `2^places` by `2^places` entries.
    pub places: u32,
    /// The nearest entry is the colour; otherwise colours stand between entries.
    pub nearest: bool,
}

impl SphereForm {
    /// A full level, in quarters between entries.
    fn white(&self) -> f64 {
        match self.nearest {
            true => 255.0,
            false => 1020.0,
        }
    }
}

impl fmt::Display for SphereForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let side = 1 << self.places;
        let nearest = if self.nearest { ":nearest" } else { "" };
        write!(f, "{side}{nearest}")
    }
}

/// Tables at most with so many bits of a coordinate.
pub fn most_tables(places: u32) -> u32 {
    MOST_TABLES.min(1 << (TABLE_BITS - 2 * places))
}

/// The lights from the first to the last that has a volume: what is behind them reaches everything.
pub fn shadowed_lights(prepared: &PreparedScene) -> usize {
    let sources = prepared.volumes.iter().map(|volume| volume.words.source);
    sources.max().map_or(0, |last| usize::from(last) + 1)
}

/// The words of a scene for a machine with tables, one for every way in which the first `lights` of the scene can reach
/// a material or be in shadow. A light at a point counts as one in its direction
/// from the middle of the picture in the screen plane.
pub fn sphere_words(
    scene: &FramedScene,
    format: &Format,
    form: SphereForm,
    lights: u32,
) -> Result<ShaderWords, ShaderError> {
    if scene.attenuation.is_some() {
        return Err(ShaderError::NoDistance);
    }
    let words = shader_words(scene, format)?;
    let materials = scene.materials.len() as u32;
    let places = form.places;
    let mut tables = SphereTables {
        nearest: form.nearest,
        ..SphereTables::dark(places, materials.max(1), lights)
    };
    let of_one = tables.entries.chunks_exact_mut(1 << (2 * places));
    let looks = scene.materials.iter();
    let looks =
        looks.flat_map(|material| (0..1usize << lights).map(move |flags| (material, flags)));
    for ((material, flags), table) in looks.zip(of_one) {
        let reaches = |light: usize| light >= lights as usize || flags >> light & 1 == 1;
        for (place, entry) in table.iter_mut().enumerate() {
            let normal = direction(place as u32, form);
            let level = |level: f64| (level.clamp(0.0, 1.0) * form.white()).round() as u16;
            *entry = far_colour(scene, material, normal, reaches).map(level);
        }
    }
    Ok(ShaderWords {
        lights: vec![],
        materials: vec![],
        sphere: Some(tables),
        ..words
    })
}

/// The normal of an entry: the octahedral map of the half sphere before the viewer, its axes turned by an eighth, so
/// that it fills a square.
fn direction(entry: u32, form: SphereForm) -> Vector {
    let last = (1u32 << form.places) - 1;
    let [sum, difference] = [entry & last, entry >> form.places].map(|place| {
        let (place, last) = (f64::from(place), f64::from(last));
        // Entries stand in the middle of their squares, or at the corners of cells.
        match form.nearest {
            true => (2.0 * place + 1.0) / (last + 1.0) - 1.0,
            false => 2.0 * place / last - 1.0,
        }
    });
    let [x, y] = [(sum + difference) / 2.0, (sum - difference) / 2.0];
    unit([x, y, x.abs() + y.abs() - 1.0])
}

/// What a material sends back of each colour, 1 a full level, where viewer and lights are infinitely far and the lights
/// with these numbers reach it. The normal has the length 1 and looks towards the viewer.
pub fn far_colour(
    scene: &FramedScene,
    material: &Material,
    normal: Vector,
    reaches: impl Fn(usize) -> bool,
) -> Vector {
    let ambient = |k: usize| material.ambient * scene.ambient[k] * material.colour[k];
    let mut sum: Vector = std::array::from_fn(ambient);
    let lights = scene.lights.iter().enumerate();
    for (_, light) in lights.filter(|(number, _)| reaches(*number)) {
        let towards = light.towards([0.0; 3]);
        let lambert = dot(normal, towards);
        if lambert <= 0.0 {
            continue;
        }
        let mirrored: Vector = std::array::from_fn(|k| 2.0 * lambert * normal[k] - towards[k]);
        let highlight = dot(mirrored, VIEWER)
            .max(0.0)
            .powi(material.exponent as i32);
        for (k, sum) in sum.iter_mut().enumerate() {
            let diffused = material.diffuse * material.colour[k] * lambert;
            *sum += light.colour[k] * (diffused + material.specular * highlight);
        }
    }
    sum
}
