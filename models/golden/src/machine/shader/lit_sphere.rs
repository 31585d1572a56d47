//! Lit-sphere shading: a table of the direction of the normal (`docs/architecture.md`, section 8.4).

use super::curve::Curve;
use super::curves::dot;
use super::view;
use super::words::{Pixel, ShaderWords};
use imogene_contract::shading::{ENTRY_LEVEL, TABLE, TABLE_BITS};
use std::sync::LazyLock;

/// The tables of a lit-sphere processor.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SphereTables {
    /// Bits of a coordinate: a table has `2^places` by `2^places` entries.
    pub places: u32,
    /// The first lights, whose flags number the `2^lights` tables of a material; the others reach everything.
    pub lights: u32,
    /// Entries, the first table first, line by line: red, green, blue in quarters of a level, 10 bits.
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
            entries: vec![[0; 3]; tables << (2 * places)],
        }
    }

    /// An entry in one word.
    pub fn word(entry: [u16; 3]) -> u32 {
        let [red, green, blue] = entry.map(u32::from);
        red | green << ENTRY_LEVEL | blue << (2 * ENTRY_LEVEL)
    }

    /// Every address with its word, in the order of loading.
    pub fn load_words(&self) -> impl Iterator<Item = (u16, u32)> {
        let entries = self.entries.iter();
        (TABLE as u16..=u16::MAX).zip(entries.map(|entry| SphereTables::word(*entry)))
    }

    /// Writes an entry; addresses beyond the tables mean nothing.
    pub(super) fn load(&mut self, address: u16, word: u32) {
        let place = usize::from(address) & ((1 << TABLE_BITS) - 1);
        if let Some(entry) = self.entries.get_mut(place) {
            let level =
                |index: u32| (word >> (index * ENTRY_LEVEL)) as u16 & ((1 << ENTRY_LEVEL) - 1);
            *entry = [0, 1, 2].map(level);
        }
    }

    /// Red, green, blue of a pixel that shows an object.
    pub fn colour(&self, words: &ShaderWords, pixel: &Pixel) -> [u8; 3] {
        let [column, line] = coordinates(words, pixel).map(|at| at * ((1 << self.places) - 1));
        let [across, down] = [column, line].map(|at| at >> 9 & 127);
        let (more, less) = (across.max(down), across.min(down));
        let reaching = usize::from(pixel.flags) & ((1 << self.lights) - 1);
        let table = usize::from(pixel.material) << self.lights | reaching;
        let own = table << (2 * self.places) & (self.entries.len() - 1);
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

/// The direction of the normal on the map, both coordinates with 16 bits.
pub fn coordinates(words: &ShaderWords, pixel: &Pixel) -> [i64; 2] {
    let normal = pixel.normal.map(i64::from);
    let is_turned = dot(normal, view::ray(words, view::place(words, pixel))) > 0;
    let [x, y, z] = if is_turned {
        normal.map(|part| -part)
    } else {
        normal
    };
    let length = x.abs() + y.abs() + (-z).max(0);
    // Its first one of 17 bits; nothing is without length but what has no direction.
    let places = 16 - length.max(1).ilog2();
    let part = RECIPROCAL.value((((length << places) & 0xffff) << 2) as u64);
    [x + y, x - y].map(|number| {
        let moved = (((number << places) * part) >> 17) + (1 << 15);
        moved.clamp(0, 0xffff)
    })
}
