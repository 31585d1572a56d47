//! Words of lit-sphere shading and their addresses.

use imogene_contract::shading::{ENTRY_LEVEL, NEAREST_LEVEL, TABLE, TABLE_BITS};

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
}
