//! Lit-sphere shading: a table of the direction of the normal (`docs/architecture.md`, section 8.4).

use super::curve::Curve;
use super::curves::dot;
use super::view;
use super::words::{Pixel, ShaderWords};
use imogene_contract::shading::{ENTRY_LEVEL, NEAREST_DROPPED, NEAREST_LEVEL, TABLE, TABLE_BITS};
use std::sync::LazyLock;

/// The tables of a lit-sphere processor.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SphereTables {
    /// Bits of a coordinate: a table has `2^places` by `2^places` entries.
    pub places: u32,
    /// The first lights, whose flags number the `2^lights` tables of a material; the others reach everything.
    pub lights: u32,
    /// The nearest entry is the colour; otherwise colours stand between entries.
    pub nearest: bool,
    /// Entries, the first table first, line by line: red, green, blue in quarters of a level, 10 bits; in levels where
    /// the nearest one is taken.
    pub entries: Vec<[u16; 3]>,
}

/// `1 / (1 + t)`, 16 bits after the point.
static RECIPROCAL: LazyLock<Curve> =
    LazyLock::new(|| Curve::new(|t| 1.0 / (1.0 + t), 4, 1.0 / 16.0, 14, 16));

impl SphereTables {
    /// Tables of so many materials whose entries are all 0.
    pub fn dark(places: u32, materials: u32, lights: u32) -> SphereTables {
        let tables = (materials.next_power_of_two() as usize) << lights;
        SphereTables {
            places,
            lights,
            nearest: false,
            entries: vec![[0; 3]; tables << (2 * places)],
        }
    }

    fn level_bits(&self) -> u32 {
        match self.nearest {
            true => NEAREST_LEVEL,
            false => ENTRY_LEVEL,
        }
    }

    /// An entry in one word.
    pub fn word(&self, entry: [u16; 3]) -> u32 {
        let [red, green, blue] = entry.map(u32::from);
        let bits = self.level_bits();
        red | green << bits | blue << (2 * bits)
    }

    /// Every address with its word, in the order of loading.
    pub fn load_words(&self) -> impl Iterator<Item = (u16, u32)> {
        let entries = self.entries.iter();
        (TABLE as u16..=u16::MAX).zip(entries.map(|entry| self.word(*entry)))
    }

    /// Writes an entry; addresses beyond the tables mean nothing.
    pub(super) fn load(&mut self, address: u16, word: u32) {
        let place = usize::from(address) & ((1 << TABLE_BITS) - 1);
        let bits = self.level_bits();
        if let Some(entry) = self.entries.get_mut(place) {
            let level = |index: u32| (word >> (index * bits)) as u16 & ((1 << bits) - 1);
            *entry = [0, 1, 2].map(level);
        }
    }

    /// Red, green, blue of a pixel that shows an object.
    pub fn colour(&self, words: &ShaderWords, pixel: &Pixel) -> [u8; 3] {
        let reaching = usize::from(pixel.flags) & ((1 << self.lights) - 1);
        let table = usize::from(pixel.material) << self.lights | reaching;
        let own = table << (2 * self.places) & (self.entries.len() - 1);
        if self.nearest {
            let [column, line] = nearest(words, pixel, self.places);
            return self.entries[own + (line << self.places) + column].map(|level| level as u8);
        }
        let [column, line] = coordinates(words, pixel).map(|at| at * ((1 << self.places) - 1));
        let [across, down] = [column, line].map(|at| at >> 9 & 127);
        let (more, less) = (across.max(down), across.min(down));
        let entry = |right: i64, below: i64| {
            let [column, line] = [(column >> 16) + right, (line >> 16) + below];
            self.entries[own + ((line as usize) << self.places) + column as usize].map(i64::from)
        };
        let near = entry(0, 0);
        let middle = if across >= down {
            entry(1, 0)
        } else {
            entry(0, 1)
        };
        let far = entry(1, 1);
        std::array::from_fn(|k| {
            let rise = more * (middle[k] - near[k]) + less * (far[k] - middle[k]);
            ((near[k] * 128 + rise + 256) >> 9) as u8
        })
    }
}

/// The sum and the difference of x and y of the normal that looks towards the viewer along a line of sight, and its
/// length on the map.
fn direction(pixel: &Pixel, ray: [i64; 3]) -> ([i64; 2], i64) {
    let normal = pixel.normal.map(i64::from);
    let is_turned = dot(normal, ray) > 0;
    let [x, y, z] = if is_turned {
        normal.map(|part| -part)
    } else {
        normal
    };
    ([x + y, x - y], x.abs() + y.abs() + (-z).max(0))
}

/// Column and line of the entry in whose square the direction of the normal is.
pub fn nearest(words: &ShaderWords, pixel: &Pixel, places: u32) -> [usize; 2] {
    let ray = match words.perspective {
        true => view::ray(words, view::place(words, pixel)).map(|part| part >> NEAREST_DROPPED),
        false => [0, 0, 1],
    };
    let (numbers, length) = direction(pixel, ray);
    let last = (1 << places) - 1;
    numbers.map(|number| match length {
        0 => last,
        _ => last.min((((number + length) << places) / (2 * length)) as usize),
    })
}

/// The direction of the normal on the map, both coordinates with 16 bits.
pub fn coordinates(words: &ShaderWords, pixel: &Pixel) -> [i64; 2] {
    let ray = view::ray(words, view::place(words, pixel));
    let (numbers, length) = direction(pixel, ray);
    // Its first one of 17 bits; nothing is without length but what has no direction.
    let places = 16 - length.max(1).ilog2();
    let part = RECIPROCAL.value((((length << places) & 0xffff) << 2) as u64);
    numbers.map(|number| {
        let moved = (((number << places) * part) >> 17) + (1 << 15);
        moved.clamp(0, 0xffff)
    })
}
