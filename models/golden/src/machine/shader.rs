//! Golden model of the shading processor (`docs/architecture.md`, section 8): Phong shading of one pixel in integers.

pub mod curves;
pub mod lit_sphere;
mod tables;
mod view;
mod widths;
mod words;

use super::frame::Frame;
use super::lighting::{ALL_SOURCES, Lighting};
use super::transparency::{Layer, Seen, stage};
use curves::Curves;
use imogene_contract::shading;
use rayon::prelude::*;
use std::sync::Arc;
pub use tables::SphereTables;
use view::{Light, Sight};
pub use widths::ShaderWidths;
pub use words::{
    LIGHT_ADDRESS, LightWords, MATERIAL_ADDRESS, MOST_LIGHTS, MOST_MATERIALS, MaterialWords, Pixel,
    ShaderWords,
};

/// Clocks from a pixel to its colour.
pub const LATENCY: u32 = shading::LATENCY as u32;

/// Bits after the point of a level before it is rounded.
pub const LEVEL_FRACTION: u32 = shading::LEVEL_FRACTION as u32;

/// A loaded shading processor.
pub struct Shader {
    words: ShaderWords,
    curves: Arc<Curves>,
}

impl Shader {
    /// The processor of the hardware, loaded.
    pub fn new(words: &ShaderWords) -> Shader {
        Shader::with_widths(words, &ShaderWidths::default())
    }

    /// A processor of other widths, loaded.
    pub fn with_widths(words: &ShaderWords, widths: &ShaderWidths) -> Shader {
        Shader {
            words: words.clone(),
            curves: Arc::new(Curves::new(widths)),
        }
    }

    /// A processor of the same widths with other words.
    pub fn reloaded(&self, words: &ShaderWords) -> Shader {
        Shader {
            words: words.clone(),
            curves: self.curves.clone(),
        }
    }

    /// Red, green, blue of a pixel.
    pub fn pixel(&self, pixel: &Pixel) -> [u8; 3] {
        let half = 1 << (LEVEL_FRACTION - 1);
        if let Some(sphere) = &self.words.sphere {
            return match pixel.depth == self.words.far_end() {
                true => self.words.background,
                false => sphere.colour(&self.words, pixel),
            };
        }
        match self.levels(pixel) {
            None => self.words.background,
            Some(levels) => levels.map(|v| ((v + half) >> LEVEL_FRACTION).min(255) as u8),
        }
    }

    /// Levels of a pixel, [`LEVEL_FRACTION`] bits after the point, neither rounded nor clamped; none where nothing is
    /// seen.
    pub fn levels(&self, pixel: &Pixel) -> Option<[i64; 3]> {
        if pixel.depth == self.words.far_end() {
            return None;
        }
        let unlit = MaterialWords::default();
        let material = self.words.materials.get(usize::from(pixel.material));
        let material = material.unwrap_or(&unlit);
        let sight = Sight::new(&self.words, &self.curves, pixel);
        let ambient = |v: u16| i64::from(v) << (LEVEL_FRACTION - 8);
        let mut levels = material.ambient.map(ambient);
        for words in &self.words.lights {
            if pixel.flags >> words.source & 1 == 0 {
                continue;
            }
            let light = Light::new(words, &sight, &self.curves);
            if !light.is_lit {
                continue;
            }
            let diffuse = light.diffuse(&self.curves);
            let specular =
                light.specular(&self.curves, material.exponent) * i64::from(material.specular);
            let widths = &self.curves.widths;
            let dropped = 17 + widths.factor - widths.reflected;
            for (k, level) in levels.iter_mut().enumerate() {
                let sent = i64::from(material.diffuse[k]) * diffuse + specular;
                let product = (sent >> dropped) * i64::from(words.colour[k]);
                // Colours have 5 bits after the point, what is sent one less than its width.
                *level += product << (LEVEL_FRACTION - 5) >> (widths.reflected - 1);
            }
        }
        Some(levels)
    }
}

/// The picture of a frame: 8-bit red, green, blue of every pixel, row-major; `materials` are the numbers of the
/// objects' materials. All sources reach transparent objects.
pub fn shade_picture(
    frame: &Frame,
    lighting: &Lighting,
    materials: &[u8],
    words: &ShaderWords,
) -> Vec<u8> {
    let shader = Shader::new(words);
    let at = |index: usize, object: usize, depth: i64, normal: [i16; 3], flags: u16| {
        shader.pixel(&Pixel {
            x: (index % frame.width) as u16,
            y: (index / frame.width) as u16,
            depth,
            material: materials[object],
            normal,
            flags,
        })
    };
    let pixel = |index: usize| -> [u8; 3] {
        let (depth, normal) = (frame.depth[index], frame.normal[index]);
        let colour = match usize::try_from(frame.id[index]) {
            Ok(id) => at(index, id, depth, normal, lighting.flags[index]),
            Err(_) => words.background,
        };
        let layers = frame.layers.iter().map(|layer| Layer {
            depth: layer.depth[index],
            colour: {
                let (depth, normal) = (layer.depth[index], layer.normal[index]);
                at(index, layer.object, depth, normal, ALL_SOURCES)
            },
            weight: layer.weight,
        });
        layers.fold(Seen { depth, colour }, stage).colour
    };
    let pixels = (0..frame.depth.len()).into_par_iter();
    pixels.flat_map_iter(pixel).collect()
}
