//! The load bus of a volume processor with a quadric: a volume's coefficient words as addresses and bits
//! (`docs/zone-machine.md`).

use super::load::{Bus, LoadWord, class};
use super::volume::{VolumeKind, VolumePlane, VolumeQuadric, VolumeWords};
use crate::format::Format;
use imogene_contract::volume;

/// Width of the control word: class, shift, kind, source.
pub const CONTROL_WIDTH: u32 = 11;

/// All words of a volume for one zone, by ascending address; absent planes up to `planes` are written as kind none. A
/// volume of planes alone gets a quadric that is everywhere.
pub fn load_volume(words: &VolumeWords, format: &Format, planes: usize) -> Vec<LoadWord> {
    let mut words = words.clone();
    words.planes.resize(planes, VolumePlane::default());
    let mut bus = Bus::sending(format);
    bus.volume(&mut words);
    bus.words
}

/// The volume whose words a processor holds, one for each address.
pub fn held(words: &[u64], format: &Format) -> VolumeWords {
    let planes = (words.len() - volume::PLANES as usize) / volume::PLANE_WORDS as usize;
    let mut volume = VolumeWords {
        planes: vec![VolumePlane::default(); planes],
        ..VolumeWords::default()
    };
    Bus::receiving(format, words).volume(&mut volume);
    volume
}

impl Bus<'_> {
    fn volume(&mut self, words: &mut VolumeWords) {
        let quadric = words.quadric.get_or_insert(VolumeQuadric::EVERYWHERE);
        self.depths(&mut quadric.f1, &mut quadric.f2);
        self.window(&mut words.screen_box);
        let control = quadric.class as i128
            | i128::from(quadric.shift) << 2
            | (words.kind as i128) << 6
            | i128::from(words.source) << 7;
        let control = self.bits(control, CONTROL_WIDTH);
        quadric.class = class(control);
        quadric.shift = (control >> 2 & 15) as u8;
        words.kind = [VolumeKind::Shadow, VolumeKind::Light][(control >> 6 & 1) as usize];
        words.source = (control >> 7) as u8;
        words.margin = self.bits(words.margin.into(), self.format.depth) as u32;
        for plane in &mut words.planes {
            self.plane(&mut plane.kind, &mut plane.depth);
        }
    }
}
