//! Words of the shading processor from a scene.

use imogene_algebra::rational::to_f64;
use imogene_golden::format::Format;
use imogene_golden::machine::shader::{
    LightWords, MOST_LIGHTS, MOST_MATERIALS, MaterialWords, ShaderWords,
};
use imogene_scene::{FramedLight, FramedScene, Material, Projection};
use thiserror::Error;

/// Why a scene has no words for the shading processor.
#[derive(Debug, Error, PartialEq)]
pub enum ShaderError {
    /// More light sources than lights.
    #[error(
        "{0} lights: the shading processor has at most {MOST_LIGHTS}; take lights out of the scene, or draw it with imogene render, which shades in software"
    )]
    Lights(usize),
    /// More materials than the table holds.
    #[error("{0} materials: the table of the shading processor holds at most {MOST_MATERIALS}")]
    Materials(usize),
    /// A picture beyond the coordinates of 12 bits.
    #[error("a picture of {0} by {1} pixels: the shading processor takes at most 4096 by 4096")]
    Picture(u32, u32),
    /// Attenuation in tables of colours.
    #[error(
        "attenuation: the viewer of a table of colours is infinitely far; take it out of the scene, or draw with a shading processor"
    )]
    NoDistance,
    /// Not a distance.
    #[error(
        "attenuation {0}: the distance at which light is halved, in pixels, is from {SHORTEST} to {LONGEST}"
    )]
    Attenuation(f64),
}

/// Largest word of 28 bits.
const MOST_WORD: f64 = ((1 << 27) - 1) as f64;
/// Largest distance of the eye in units of a line of sight.
const MOST_DISTANCE: f64 = 131_071.0;
/// Distances at which light may be halved, in pixels.
const SHORTEST: f64 = 1e-3;
const LONGEST: f64 = 1e12;

/// The words of a scene.
/// Fails when the scene has more lights, materials or pixels than the processor, or an attenuation beyond the words.
pub fn shader_words(scene: &FramedScene, format: &Format) -> Result<ShaderWords, ShaderError> {
    check(scene)?;
    let view = View::new(&scene.projection);
    // A depth word counts 1 / ZMAX of the way, the hardware 1 / 2^(W-1).
    let full = (f64::from(format.depth) - 1.0).exp2();
    let stretch = full / format.z_max() as f64;
    // A machine may have some last lights that are directional alone.
    let mut lights: Vec<(usize, &FramedLight)> = scene.lights.iter().enumerate().collect();
    lights.sort_by_key(|(_, light)| !light.is_at_a_point);
    let light = |(source, light): (usize, &FramedLight)| LightWords {
        source: source as u8,
        colour: light.colour.map(light_level),
        ..match light.is_at_a_point {
            true => point(light.at, &scene.projection, stretch),
            false => directional(light.at),
        }
    };
    let materials = scene.materials.iter().map(|m| material(m, scene.ambient));
    Ok(ShaderWords {
        depth: format.depth,
        size: [scene.width as u16, scene.height as u16],
        is_field: false,
        perspective: view.perspective,
        view_shift: view.shift,
        distance: view.distance,
        attenuation: scene.attenuation.map(|k| view.attenuation(k, stretch)),
        offset_when_on: 0,
        background: scene.background,
        lights: lights.into_iter().map(light).collect(),
        materials: materials.collect(),
        sphere: None,
    })
}

/// The words of a scene for a machine without lights: every object has the colour of its material, which stands in the
/// place of the ambient light.
pub fn flat_words(scene: &FramedScene, format: &Format) -> Result<ShaderWords, ShaderError> {
    let words = shader_words(scene, format)?;
    let plain = |m: &Material| MaterialWords {
        ambient: m.colour.map(|level| (level * 65280.0).round() as u16),
        ..MaterialWords::default()
    };
    Ok(ShaderWords {
        attenuation: None,
        lights: vec![],
        materials: scene.materials.iter().map(plain).collect(),
        ..words
    })
}

/// The number of the material of every object, as the shading processor wants it beside the pixels.
pub fn material_numbers(scene: &FramedScene) -> Vec<u8> {
    let objects = scene.objects.iter();
    objects.map(|object| object.material() as u8).collect()
}

fn check(scene: &FramedScene) -> Result<(), ShaderError> {
    let (lights, materials) = (scene.lights.len(), scene.materials.len());
    if lights > MOST_LIGHTS {
        return Err(ShaderError::Lights(lights));
    }
    if materials > MOST_MATERIALS {
        return Err(ShaderError::Materials(materials));
    }
    if scene.width.max(scene.height) > 4096 {
        return Err(ShaderError::Picture(scene.width, scene.height));
    }
    match scene.attenuation {
        Some(k) if !(SHORTEST..=LONGEST).contains(&k) => Err(ShaderError::Attenuation(k)),
        _ => Ok(()),
    }
}

struct View {
    perspective: bool,
    shift: u8,
    distance: u32,
    /// Pixels of one unit of a line of sight.
    unit: f64,
}

impl View {
    fn new(projection: &Projection) -> View {
        let parallel = View {
            perspective: false,
            shift: 0,
            distance: 1,
            unit: 1.0,
        };
        let Projection::Perspective { distance } = projection else {
            return parallel;
        };
        let distance = to_f64(distance);
        let unit = |shift: u8| f64::from(shift).exp2() / 64.0;
        match (0..16).find(|&shift| distance / unit(shift) <= MOST_DISTANCE) {
            Some(shift) => View {
                perspective: true,
                shift,
                distance: (distance / unit(shift)).round().max(1.0) as u32,
                unit: unit(shift),
            },
            // From so far away, lines of sight differ by less than a unit.
            None => View {
                distance: MOST_DISTANCE as u32,
                unit: distance / MOST_DISTANCE,
                ..parallel
            },
        }
    }

    /// The word of a distance `k` in pixels: the machine divides the ray to the screen by what is left of the way, 31
    /// bits after the point.
    fn attenuation(&self, k: f64, stretch: f64) -> i32 {
        let offset = (self.unit / k / stretch).log2() + 31.0;
        (offset * f64::from(1 << 22)).round() as i32
    }
}

fn directional(towards: [f64; 3]) -> LightWords {
    let most = greatest(&towards);
    LightWords {
        base: towards.map(|v| (v / most * MOST_WORD).round() as i32),
        ..LightWords::default()
    }
}

/// `S (1 - t) - (x, y, t D)` in perspective and `S - (x, y, t H)` along parallel lines, `t` the part of the way to the
/// far end.
fn point(position: [f64; 3], projection: &Projection, stretch: f64) -> LightWords {
    let [x, y, z] = position;
    let slope = match projection {
        Projection::Perspective { distance } => [x, y, z + to_f64(distance)],
        Projection::Orthographic { half_depth } => [0.0, 0.0, to_f64(half_depth)],
    }
    .map(|v| v * stretch);
    let most = greatest(&position).max(greatest(&slope));
    let per_pixel = |shift: u8| (f64::from(shift) + 1.0).exp2();
    let shift = (0..=14)
        .rev()
        .find(|&shift| most * per_pixel(shift) <= MOST_WORD);
    // Beyond all shifts the light is so far that the place on the screen is less than a unit in sixteen thousand of the
    // way.
    let scale = shift.map_or(MOST_WORD / most, per_pixel);
    let word = |v: f64| (v * scale).round() as i32;
    LightWords {
        point: shift.is_some(),
        shift: shift.unwrap_or(0),
        base: position.map(word),
        slope: slope.map(word),
        ..LightWords::default()
    }
}

fn greatest(vector: &[f64; 3]) -> f64 {
    vector.iter().fold(0.0, |most, v| most.max(v.abs()))
}

fn light_level(intensity: f64) -> u32 {
    (intensity * 255.0 * 32.0).round() as u32
}

fn material(material: &Material, ambient: [f64; 3]) -> MaterialWords {
    let share = |v: f64| (v * 65536.0).round().min(65535.0) as u16;
    MaterialWords {
        ambient: std::array::from_fn(|k| {
            (material.ambient * ambient[k] * material.colour[k] * 65280.0).round() as u16
        }),
        diffuse: material.colour.map(|v| share(material.diffuse * v)),
        specular: share(material.specular),
        exponent: material.exponent as u8,
    }
}
