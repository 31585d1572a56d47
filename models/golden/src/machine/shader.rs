//! Golden model of the shading processor (`docs/architecture.md`, section 8): Phong shading of one pixel in integers.

mod curve;
mod light;
mod view;
mod widths;
mod words;

use super::frame::Frame;
use super::lighting::Lighting;
use curve::Curve;
use imogene_contract::shading;
use light::Light;
use rayon::prelude::*;
use std::sync::Arc;
use view::Sight;
pub use widths::ShaderWidths;
pub use words::{
    LIGHT_ADDRESS, LightWords, MATERIAL_ADDRESS, MOST_LIGHTS, MOST_MATERIALS, MaterialWords,
    ShaderWords,
};

/// Clocks from a pixel to its colour.
pub const LATENCY: u32 = shading::LATENCY as u32;

/// Bits after the point of a level before it is rounded.
pub const LEVEL_FRACTION: u32 = shading::LEVEL_FRACTION as u32;

/// What is asked of the shading processor at one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// Column.
    pub x: u16,
    /// Line.
    pub y: u16,
    /// Depth word.
    pub depth: i64,
    /// Number of the material.
    pub material: u8,
    /// Normal of any length, towards the viewer or away.
    pub normal: [i16; 3],
    /// Bit i: source i reaches the point.
    pub flags: u16,
}

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
        match self.levels(pixel) {
            None => self.words.background,
            Some(levels) => levels.map(|v| ((v + half) >> LEVEL_FRACTION).min(255) as u8),
        }
    }

    /// Levels of a pixel, [`LEVEL_FRACTION`] bits after the point, neither rounded nor clamped; none where nothing is seen.
    pub fn levels(&self, pixel: &Pixel) -> Option<[i64; 3]> {
        if pixel.depth == (1 << (self.words.depth - 1)) - 1 {
            return None;
        }
        let unlit = MaterialWords::default();
        let material = self.words.materials.get(usize::from(pixel.material));
        let material = material.unwrap_or(&unlit);
        let sight = Sight::new(&self.words, &self.curves, pixel);
        let mut levels = material
            .ambient
            .map(|v| i64::from(v) << (LEVEL_FRACTION - 8));
        for words in &self.words.lights {
            if pixel.flags >> words.source & 1 == 0 {
                continue;
            }
            let light = Light::new(words, &sight, &self.curves);
            if !light.is_lit() {
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

/// The picture of a frame: 8-bit red, green, blue of every pixel, row-major; `materials` are the numbers of the objects' materials.
pub fn shade_picture(
    frame: &Frame,
    lighting: &Lighting,
    materials: &[u8],
    words: &ShaderWords,
) -> Vec<u8> {
    let shader = Shader::new(words);
    let pixel = |index: usize| -> [u8; 3] {
        let Ok(id) = usize::try_from(frame.id[index]) else {
            return words.background;
        };
        shader.pixel(&Pixel {
            x: (index % frame.width) as u16,
            y: (index / frame.width) as u16,
            depth: frame.depth[index],
            material: materials[id],
            normal: frame.normal[index],
            flags: lighting.flags[index],
        })
    };
    (0..frame.depth.len())
        .into_par_iter()
        .flat_map_iter(pixel)
        .collect()
}

/// The functions that are tabulated, and the widths they work at. A *loss* is the negative logarithm to base 2 of a factor, with
/// one bit more after the point than a logarithm.
struct Curves {
    widths: ShaderWidths,
    logarithm: Curve,
    power: Curve,
    fall: Curve,
}

/// Bits of the number of a segment, for each curve.
const LOGARITHM_SEGMENTS: u32 = 5;
const POWER_SEGMENTS: u32 = 3;
const FALL_SEGMENTS: u32 = 6;
/// Bits after the point of the attenuation's curve, and of its argument before the point.
const FALL_FRACTION: u32 = 18;
const FALL_RANGE: u32 = 4;
/// Bits of a loss before its point: 32 octaves leave nothing.
const LOSS_RANGE: u32 = 5;

impl Curves {
    fn new(widths: &ShaderWidths) -> Curves {
        let place = widths.place;
        let power_length = (-f64::from(POWER_SEGMENTS)).exp2();
        let logarithm_length = (-f64::from(LOGARITHM_SEGMENTS)).exp2();
        Curves {
            widths: *widths,
            logarithm: Curve::new(
                |t| (1.0 + t).log2(),
                LOGARITHM_SEGMENTS,
                logarithm_length,
                place,
                widths.logarithm,
            ),
            power: Curve::new(
                |t| (-t).exp2(),
                POWER_SEGMENTS,
                power_length,
                place,
                widths.power,
            ),
            fall: Curve::new(
                |t| (1.0 + (-t).exp2()).log2(),
                FALL_SEGMENTS,
                0.25,
                place,
                FALL_FRACTION,
            ),
        }
    }

    /// Bits after the point of a loss.
    fn loss_fraction(&self) -> u32 {
        self.widths.logarithm + 1
    }

    /// The greatest loss.
    fn most(&self) -> i64 {
        (1 << (LOSS_RANGE + self.loss_fraction())) - 1
    }

    /// `log2` of a number; that of 0 is that of 1.
    fn log2(&self, number: i64) -> i64 {
        let number = number.max(1);
        let octave = number.ilog2();
        let bits = LOGARITHM_SEGMENTS + self.widths.place;
        let fraction = (number as u64) << (63 - octave) << 1 >> (64 - bits);
        (i64::from(octave) << self.widths.logarithm) + self.logarithm.value(fraction)
    }

    /// The factor of a loss, below 1.
    fn factor(&self, loss: i64) -> i64 {
        let point = self.loss_fraction();
        let bits = POWER_SEGMENTS + self.widths.place;
        let octaves = (loss >> point).min(63);
        let fraction = loss & ((1 << point) - 1);
        let value = self.power.value((fraction >> (point - bits)) as u64);
        let factor = value << self.widths.factor >> self.widths.power >> octaves;
        factor.min((1 << self.widths.factor) - 1)
    }

    /// The loss of `1 / (1 + 2^e)`, with `e` in the units of a loss.
    fn attenuation(&self, e: i64) -> i64 {
        let bits = FALL_SEGMENTS + self.widths.place;
        let argument = e.abs() >> (self.loss_fraction() + FALL_RANGE - bits);
        let fall = if argument >> bits == 0 {
            self.fall.value(argument as u64) << self.loss_fraction() >> FALL_FRACTION
        } else {
            0
        };
        (fall + e.max(0)).min(self.most())
    }
}

/// A vector shifted to the left until its longest component fills `bits` bits, by `bits - 2` at most, and the places it was shifted.
fn normalised(vector: [i64; 3], bits: u32) -> ([i64; 3], u32) {
    let magnitude = vector.iter().fold(1, |all, v| all | (v ^ (v >> 63)));
    let length = 64 - magnitude.leading_zeros();
    let places = bits - 1 - length;
    (vector.map(|v| v << places), places)
}

fn dot(a: [i64; 3], b: [i64; 3]) -> i64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
