//! Words of the shading processor and their addresses.

use super::tables::SphereTables;
use imogene_contract::shading;

/// Lights at most.
pub const MOST_LIGHTS: usize = imogene_contract::words::MOST_LIGHTS as usize;
/// Materials at most.
pub const MOST_MATERIALS: usize = shading::MOST_MATERIALS as usize;
/// Address of the first word of light 0; the next light begins 16 further on.
pub const LIGHT_ADDRESS: u16 = shading::LIGHT as u16;
/// Address of the first word of material 0; the next material begins 4 further on.
pub const MATERIAL_ADDRESS: u16 = shading::MATERIAL as u16;

const TABLE: u16 = shading::TABLE as u16;

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

/// All that a shading processor is loaded with.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ShaderWords {
    /// Depth word `W` of the machine: 8 to 32 bits.
    pub depth: u32,
    /// Columns and lines of the picture, at most 4096: the point (0, 0) of the camera frame is in the middle.
    pub size: [u16; 2],
    /// A pixel's line is that of a field: the lines of the picture count by two.
    pub is_field: bool,
    /// Lines of sight meet in the eye; otherwise they are parallel.
    pub perspective: bool,
    /// Places that pixel coordinates, in 1/64 pixels, are shifted to the right in a line of sight, 0 to 15.
    pub view_shift: u8,
    /// Distance of the eye from the screen in units of the shifted coordinates, 17 bits.
    pub distance: u32,
    /// The attenuation's `log2(unit / k)`, 22 bits after the point, 30 bits; none if it is off.
    pub attenuation: Option<i32>,
    /// Word of an attenuation that is off.
    pub offset_when_on: i32,
    /// Colour of the background.
    pub background: [u8; 3],
    /// The lights.
    pub lights: Vec<LightWords>,
    /// The materials.
    pub materials: Vec<MaterialWords>,
    /// The tables of lit-sphere shading, in the place of lights and materials.
    pub sphere: Option<SphereTables>,
}

/// Words of one light: `L = base - (pixel coordinates) - slope * depth`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LightWords {
    /// Bit of the flags that says whether the light reaches the point, 0 to 15.
    pub source: u8,
    /// Pixel coordinates count: a point light.
    pub point: bool,
    /// Places that half pixels are shifted to the left, 0 to 14.
    pub shift: u8,
    /// The constant part, 28 bits.
    pub base: [i32; 3],
    /// The part that goes with depth, 28 bits.
    pub slope: [i32; 3],
    /// Colour times intensity in levels of 8 bits, 5 bits after the point, 17 bits.
    pub colour: [u32; 3],
}

/// Words of one material.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MaterialWords {
    /// Share of ambient light in levels of 8 bits, 8 bits after the point.
    pub ambient: [u16; 3],
    /// Share of diffused light, 16 bits after the point.
    pub diffuse: [u16; 3],
    /// Share of mirrored light, 16 bits after the point.
    pub specular: u16,
    /// Sharpness of the highlight.
    pub exponent: u8,
}

impl ShaderWords {
    /// Unloaded words of a processor with so many lights: all are zero.
    pub fn unloaded(depth: u32, lights: usize) -> ShaderWords {
        ShaderWords {
            depth,
            lights: vec![LightWords::default(); lights],
            materials: vec![MaterialWords::default(); MOST_MATERIALS],
            ..ShaderWords::default()
        }
    }

    /// The words for the lines `first, first + 2, ..` of the picture alone. A machine whose lines are further apart
    /// counts them by twos before it shades them.
    pub fn on_lines(self, first: u16) -> ShaderWords {
        let [columns, lines] = self.size;
        ShaderWords {
            // Half pixels in 13 bits, as places are counted.
            size: [columns, lines.wrapping_sub(2 * first) & 0x1fff],
            is_field: true,
            ..self
        }
    }

    pub(super) fn far_end(&self) -> i64 {
        (1 << (self.depth - 1)) - 1
    }

    /// Writes one word; what a word has beyond its fields, and addresses that are not in use, mean nothing.
    pub fn load(&mut self, address: u16, word: u32) {
        let bits = |low: u32, width: u32| word >> low & ((1 << width) - 1);
        match address {
            0 => self.size = [bits(0, 13) as u16, bits(16, 13) as u16],
            1 => {
                self.perspective = bits(0, 1) == 1;
                self.is_field = bits(2, 1) == 1;
                self.view_shift = bits(4, 4) as u8;
                let offset = self.attenuation.unwrap_or(self.offset_when_on);
                self.attenuation = (bits(1, 1) == 1).then_some(offset);
            }
            2 => self.distance = bits(0, 17),
            3 => {
                self.offset_when_on = signed(word, 30);
                self.attenuation = self.attenuation.map(|_| self.offset_when_on);
            }
            4 => self.background = [0, 8, 16].map(|low| bits(low, 8) as u8),
            LIGHT_ADDRESS.. if address < MATERIAL_ADDRESS => {
                let light = usize::from(address / 16) - 1;
                if let Some(light) = self.lights.get_mut(light) {
                    light.load(address % 16, word);
                }
            }
            TABLE.. => {
                if let Some(sphere) = &mut self.sphere {
                    sphere.load(address, word);
                }
            }
            _ => {
                let material = usize::from(address.wrapping_sub(MATERIAL_ADDRESS) / 4);
                if let Some(material) = self.materials.get_mut(material) {
                    material.load(address % 4, word);
                }
            }
        }
    }

    /// Every address with its word, in the order of loading.
    pub fn load_words(&self) -> Vec<(u16, u32)> {
        let [columns, lines] = self.size.map(u32::from);
        let [red, green, blue] = self.background.map(u32::from);
        let offset = self.attenuation.unwrap_or(self.offset_when_on);
        let attenuation = offset as u32 & 0x3fff_ffff;
        let view = u32::from(self.perspective)
            | u32::from(self.attenuation.is_some()) << 1
            | u32::from(self.is_field) << 2
            | u32::from(self.view_shift) << 4;
        let mut words = vec![
            (0, columns | lines << 16),
            (1, view),
            (2, self.distance),
            (3, attenuation),
            (4, red | green << 8 | blue << 16),
        ];
        for (light, address) in self.lights.iter().zip((LIGHT_ADDRESS..).step_by(16)) {
            words.extend((address..).zip(light.load_words()));
        }
        for (material, address) in self.materials.iter().zip((MATERIAL_ADDRESS..).step_by(4)) {
            words.extend((address..).zip(material.load_words()));
        }
        words
    }
}

/// The low bits of a word as a number.
fn signed(word: u32, width: u32) -> i32 {
    (word << (32 - width)) as i32 >> (32 - width)
}

impl LightWords {
    fn load(&mut self, at: u16, word: u32) {
        match at {
            0 => {
                self.point = word & 1 == 1;
                self.source = (word >> 4 & 15) as u8;
                self.shift = (word >> 8 & 15) as u8;
            }
            1..=3 => self.base[usize::from(at) - 1] = signed(word, 28),
            4..=6 => self.slope[usize::from(at) - 4] = signed(word, 28),
            7..=9 => self.colour[usize::from(at) - 7] = word & 0x1_ffff,
            _ => {}
        }
    }

    fn load_words(&self) -> [u32; 10] {
        let control =
            u32::from(self.point) | u32::from(self.source) << 4 | u32::from(self.shift) << 8;
        let [bx, by, bz] = self.base.map(|v| v as u32 & 0x0fff_ffff);
        let [sx, sy, sz] = self.slope.map(|v| v as u32 & 0x0fff_ffff);
        let [red, green, blue] = self.colour;
        [control, bx, by, bz, sx, sy, sz, red, green, blue]
    }
}

impl MaterialWords {
    fn load(&mut self, at: u16, word: u32) {
        let (low, high) = (word as u16, (word >> 16) as u16);
        match at {
            0 => [self.ambient[0], self.ambient[1]] = [low, high],
            1 => (self.ambient[2], self.specular) = (low, high),
            2 => [self.diffuse[0], self.diffuse[1]] = [low, high],
            _ => (self.diffuse[2], self.exponent) = (low, high as u8),
        }
    }

    fn load_words(&self) -> [u32; 4] {
        let pair = |low: u16, high: u16| u32::from(low) | u32::from(high) << 16;
        [
            pair(self.ambient[0], self.ambient[1]),
            pair(self.ambient[2], self.specular),
            pair(self.diffuse[0], self.diffuse[1]),
            pair(self.diffuse[2], self.exponent.into()),
        ]
    }
}
