//! The command stream of a plan, beat by beat.

use super::plan::{Part, Pass, Zone, ZonePlan};
use crate::culling::Planes;
use crate::culling::part::with_planes;
use crate::culling::volume::volume_with_planes;
use imogene_contract::shading::MOST_MATERIALS;
use imogene_contract::slots::FittedSlot;
use imogene_golden::machine::zone::ID_BITS;
use imogene_golden::machine::zone::beat::{Beat, OBJECT_ID, command, kind};
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

    fn zone_beats(&self, zone: &Zone, last: bool) -> Vec<Beat> {
        let mut beats = vec![];
        for (index, pass) in self.passes(zone, last).enumerate() {
            beats.extend(self.words_of(&pass, zone));
            if index == 0 {
                let pair = |[a, b]: [i64; 2]| a as u64 | (b as u64) << 12;
                let first = [zone.window.x0, zone.window.y0];
                beats.push(Beat::command(command::ORIGIN, pair(first)));
                beats.push(Beat::command(command::SIZE, pair(zone.window.size())));
            }
            beats.push(command_of(&pass, zone));
        }
        if let Some(beat) = beats.last_mut() {
            beat.last = last;
        }
        beats
    }

    /// The beats that load the processors for a pass over a zone.
    pub fn words_of(&self, pass: &Pass, zone: &Zone) -> Vec<Beat> {
        let mut beats = vec![];
        match pass {
            Pass::Draw { parts, .. } => {
                for &(unit, index) in parts {
                    let part = &self.parts[index as usize];
                    let slot = (unit, &self.machine.slots[unit]);
                    let own = self.words_of_part((part, zone.planes_of_part(index)), slot, zone);
                    beats.extend(own);
                    beats.push(id(unit, part.object as u64));
                }
            }
            Pass::Light { volumes, .. } => {
                for (unit, &index) in volumes.iter().enumerate() {
                    let planes = zone.planes_of_volume(index);
                    let words = volume_with_planes(&self.volumes[index as usize], planes);
                    let words = zone.moved(&words);
                    let list = load_volume(&words, &self.format, words.planes.len());
                    let unused = words.planes.len()..self.machine.volume_planes;
                    let list = list.into_iter().chain(unused.map(unused::volume_plane));
                    beats.extend(list.map(beat(kind::VOLUME, unit)));
                }
            }
            Pass::Show { layers, .. } => {
                for &index in *layers {
                    let part = &self.layers[index];
                    let unit = self.machine.slots.len() + index;
                    let slot = (unit, &self.machine.layers[index]);
                    beats.extend(self.words_of_part((part, Planes::MAX), slot, zone));
                    beats.push(id(unit, self.look(part)));
                }
            }
        }
        beats
    }

    /// Words of a part with some of its planes, for a slot.
    fn words_of_part(
        &self,
        (part, planes): (&Part, Planes),
        (unit, slot): (usize, &FittedSlot),
        zone: &Zone,
    ) -> impl Iterator<Item = Beat> + use<> {
        let (list, unused) = match part.quadric() {
            Some(words) => {
                let words = zone.moved(&with_planes(words, planes));
                let used = words.planes.len();
                let list = load_words(&words, &self.format, used);
                (list, used..slot.planes as usize)
            }
            None => (
                load_slot(&zone.moved(&part.words), &self.format, slot),
                0..0,
            ),
        };
        let list = list.into_iter().chain(unused.map(unused::object_plane));
        list.map(beat(kind::OBJECT, unit))
    }

    /// The word that says how a transparent object looks: its id, above it its material and its part of what is seen.
    fn look(&self, part: &Part) -> u64 {
        let material = self.materials.get(part.object);
        let material = u64::from(material.copied().unwrap_or(0));
        let weight = u64::from(part.weight.unwrap_or(0)) << MOST_MATERIALS.ilog2();
        part.object as u64 | (material | weight) << ID_BITS
    }
}

fn beat(kind: u8, unit: usize) -> impl Fn(LoadWord) -> Beat {
    move |word| Beat::new(kind, unit as u8, word.address.into(), word.bits)
}

fn id(unit: usize, id: u64) -> Beat {
    Beat::new(kind::OBJECT, unit as u8, OBJECT_ID, id)
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
