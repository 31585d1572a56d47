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
    pub(super) fn colour(&self, words: &ShaderWords, pixel: &Pixel) -> [u8; 3] {
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
fn coordinates(words: &ShaderWords, pixel: &Pixel) -> [i64; 2] {
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn words() -> ShaderWords {
        ShaderWords {
            depth: 24,
            size: [640, 480],
            distance: 1,
            ..ShaderWords::default()
        }
    }

    proptest! {
        /// Against the map in real numbers: a normal towards the viewer or away from it has one place.
        #[test]
        fn a_direction_has_its_place(normal in any::<[i16; 3]>()) {
            prop_assume!(normal[2] != 0);
            let pixel = Pixel { x: 0, y: 0, depth: 0, material: 0, normal, flags: 0 };
            let found = coordinates(&words(), &pixel);
            let [x, y, z] = normal.map(f64::from);
            let side = if z > 0.0 { -1.0 } else { 1.0 };
            let length = x.abs() + y.abs() + z.abs();
            for (found, exact) in found.into_iter().zip([x + y, x - y]) {
                let exact = 32768.0 * (1.0 + side * exact / length);
                prop_assert!((found as f64 - exact).abs() < 4.0, "{found} {exact}");
            }
        }
    }

    /// Every colour of a table that is of first degree is met exactly, up to its rounding.
    #[test]
    fn between_entries_levels_are_of_first_degree() {
        let mut tables = SphereTables::dark(4, 1, 0);
        for line in 0..16 {
            for column in 0..16 {
                tables.entries[16 * line + column] = [64 * column as u16, 64 * line as u16, 1020];
            }
        }
        for x in (-20_000..20_000i16).step_by(613) {
            for y in (-20_000..20_000i16).step_by(431) {
                let pixel = Pixel {
                    x: 0,
                    y: 0,
                    depth: 0,
                    material: 0,
                    normal: [x, y, -9000],
                    flags: 0,
                };
                let at = coordinates(&words(), &pixel).map(|at| at as f64 / 65536.0 * 15.0 * 16.0);
                let [red, green, blue] = tables.colour(&words(), &pixel);
                assert!((f64::from(red) - at[0]).abs() < 0.65, "{red} {at:?}");
                assert!((f64::from(green) - at[1]).abs() < 0.65, "{green} {at:?}");
                assert_eq!(blue, 255);
            }
        }
    }
}
