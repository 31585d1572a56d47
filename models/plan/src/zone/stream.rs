//! The command stream of a plan, beat by beat.

use super::plan::{Part, Pass, Zone, ZonePlan};
use crate::culling::Planes;
use crate::culling::part::with_planes;
use crate::culling::volume::volume_with_planes;
use imogene_contract::object::Kind;
use imogene_contract::shading::MOST_MATERIALS;
use imogene_contract::slots::FittedSlot;
use imogene_contract::volume;
use imogene_golden::machine::zone::ID_BITS;
use imogene_golden::machine::zone::beat::{Beat, ID_ADDRESS, command, kind};
use imogene_golden::object::load::{LoadWord, load_words};
use imogene_golden::object::load_slot::load_slot;
use imogene_golden::object::load_volume::load_volume;
use imogene_golden::object::unused;

impl ZonePlan {
    /// The beats of the frame. The words of a pass come before the commands of its zone, so that they can be loaded
    /// while the pass before is running.
    pub fn beats(&self) -> impl Iterator<Item = Beat> + '_ {
        let last = self.zones.len() - 1;
        let zones = self.zones.iter().enumerate();
        self.set_up()
            .chain(zones.flat_map(move |(index, zone)| self.zone_beats(zone, index == last)))
    }

    fn set_up(&self) -> impl Iterator<Item = Beat> + '_ {
        let word =
            |&(address, data): &(u16, u32)| Beat::new(kind::SHADING, 0, address, data.into());
        let material =
            |(id, &index): (usize, &u32)| Beat::new(kind::MATERIAL, 0, id as u16, index.into());
        let materials = self.materials.iter().enumerate();
        self.shading.iter().map(word).chain(materials.map(material))
    }

    /// All beats of one zone.
    pub fn zone_beats(&self, zone: &Zone, last: bool) -> Vec<Beat> {
        let mut beats = vec![];
        for (index, pass) in self.passes(zone, last).enumerate() {
            self.words_of(&pass, zone, &mut beats);
            if index == 0 {
                let pair = |a: u32, b: u32| u64::from(a) | u64::from(b) << 12;
                beats.push(Beat::command(command::ORIGIN, pair(zone.x0, zone.y0)));
                beats.push(Beat::command(command::SIZE, pair(zone.width, zone.height)));
            }
            beats.push(command_of(&pass, zone));
        }
        if let Some(beat) = beats.last_mut() {
            beat.last = last;
        }
        beats
    }

    fn words_of(&self, pass: &Pass, zone: &Zone, beats: &mut Vec<Beat>) {
        match pass {
            Pass::Draw { parts, .. } => {
                for &(unit, index) in parts {
                    let part = &self.parts[index as usize];
                    let slot = &self.machine.slots[unit];
                    self.words_of_part(
                        (part, zone.planes_of_part(index)),
                        (unit, slot),
                        zone,
                        beats,
                    );
                    let id = u64::from(part.object);
                    beats.push(Beat::new(kind::OBJECT, unit as u8, ID_ADDRESS, id));
                }
            }
            Pass::Light { volumes, .. } => {
                for (unit, &index) in volumes.iter().enumerate() {
                    let planes = zone.planes_of_volume(index);
                    let words = volume_with_planes(&self.volumes[index as usize], planes);
                    let words = zone.moved(&words);
                    let list = load_volume(&words, &self.format, words.planes.len());
                    let unused = words.planes.len()..self.machine.volume_planes;
                    let unused = unused.map(unused::volume_plane);
                    push(beats, kind::VOLUME, unit, list, unused);
                }
            }
            Pass::Show { layers, .. } => {
                for &index in *layers {
                    let (part, slot) = (&self.layers[index], &self.machine.layers[index]);
                    let unit = self.machine.slots.len() + index;
                    self.words_of_part((part, Planes::MAX), (unit, slot), zone, beats);
                    let look = self.look(part);
                    beats.push(Beat::new(kind::OBJECT, unit as u8, ID_ADDRESS, look));
                }
            }
        }
    }

    /// Words of a part with some of its planes, for a slot.
    fn words_of_part(
        &self,
        (part, planes): (&Part, Planes),
        (unit, slot): (usize, &FittedSlot),
        zone: &Zone,
        beats: &mut Vec<Beat>,
    ) {
        let (list, unused) = match part.quadric() {
            Some(words) => {
                let words = with_planes(words, planes);
                let used = words.planes.len();
                let words = load_words(&zone.moved(&words), &self.format, used);
                (words, used..slot.planes as usize)
            }
            None => {
                let words = zone.moved(&part.words);
                (load_slot(&words, &self.format, slot), 0..0)
            }
        };
        let unused = unused.map(unused::object_plane);
        push(beats, kind::OBJECT, unit, list, unused);
    }

    /// The word that says how a transparent object looks: its id, above it its material and its part of what is seen.
    fn look(&self, part: &Part) -> u64 {
        let object = part.object;
        let material = self.materials.get(usize::from(object));
        let material = u64::from(material.copied().unwrap_or(0));
        let weight = u64::from(part.weight.unwrap_or(0)) << MOST_MATERIALS.ilog2();
        u64::from(object) | (material | weight) << ID_BITS
    }
}

fn push(
    beats: &mut Vec<Beat>,
    kind: u8,
    unit: usize,
    words: Vec<LoadWord>,
    unused: impl Iterator<Item = LoadWord>,
) {
    let words = words.into_iter().chain(unused);
    beats.extend(words.map(|w| Beat::new(kind, unit as u8, w.address.into(), w.bits)));
}

fn command_of(pass: &Pass, zone: &Zone) -> Beat {
    let bit = |set: bool, mask: u64| if set { mask } else { 0 };
    match *pass {
        Pass::Draw { first, .. } => Beat::command(command::DRAW, bit(first, command::FIRST)),
        Pass::Light { first, .. } => Beat::command(command::LIGHT, bit(first, command::FIRST)),
        Pass::Show {
            lit, drawn, last, ..
        } => Beat::command(
            command::SHOW,
            bit(lit, command::LIT)
                | bit(drawn, command::DRAWN)
                | bit(last, command::LAST_ZONE)
                | zone.sample.bits(),
        ),
    }
}

/// Beats of the words of a part in a slot, and of its id. Of a quadric with `used` planes those of the others are not
/// sent, but for their kind; of another kind all are.
pub fn beats_of_part(slot: &FittedSlot, used: usize) -> u64 {
    let planes = slot.planes as usize;
    let words = match slot.kind {
        Kind::Quadric => slot.kind.words(used) + (planes - used),
        other => other.words(planes),
    };
    (words + 1) as u64
}

/// Beats of the words of a volume with `used` planes in a machine of `planes` planes of a volume.
pub fn beats_of_volume(used: usize, planes: usize) -> u64 {
    (volume::words(used) + (planes - used)) as u64
}
