//! Which slot of the machine draws a part of a scene, and in which pass over a zone.

use super::error::{PlanError, Result};
use crate::culling::{Planes, all_planes};
use imogene_contract::object::Kind;
use imogene_contract::slots::{self, FittedSlot};
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::object::as_quadric::AsQuadricError;
use imogene_golden::object::quadric::{MAX_PLANES, QuadricWords};
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::slots::{own_kind, required};
use imogene_prepare::PreparedScene;

/// What one object processor draws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Index of its object in the scene, the id of its pixels; the parts of a mesh have the same.
    pub object: usize,
    /// Words for the whole screen, those of the kind of its slots.
    pub words: ProcessorWords,
    /// What its slot has to have.
    pub needed: FittedSlot,
    /// Of a transparent one its part of what is seen, in 255ths.
    pub weight: Option<u8>,
}

impl Part {
    pub(crate) fn of(scene: &PreparedScene, slot: &Slot, words: ProcessorWords) -> Part {
        let needed = required(&words).expect("a kind that has slots");
        Part {
            object: slot.object,
            needed: scene.in_needed(needed, slot.object, &words),
            words,
            weight: slot.weight,
        }
    }

    /// The words of a quadric processor; none of a part for another kind.
    pub fn quadric(&self) -> Option<&QuadricWords> {
        match &self.words {
            ProcessorWords::Quadric(words) => Some(words),
            _ => None,
        }
    }

    /// All its planes: of another kind than quadrics every one is always sent.
    pub(super) fn all_planes(&self) -> Planes {
        let words = self.quadric();
        words.map_or(Planes::MAX, |words| all_planes(words.planes.len()))
    }
}

/// Object and words of every part of a scene. A part that is in no solid is of its own kind where the machine has a
/// slot for that, and else a quadric's.
pub(super) fn parts(scene: &PreparedScene, machine: &ZoneMachine) -> Result<Vec<Part>> {
    let (alone_slots, members) = machine.slots.split_at(machine.alone());
    let alone = scene.slots_alone().into_iter();
    let alone = alone.map(|slot| part_of(scene, slot, alone_slots));
    // Any of the slots may be given any of the members.
    let planes = members.iter().map(|slot| slot.planes).min().unwrap_or(0);
    let members = scene.solids.slots.iter().map(|slot| {
        let words = &slot.words;
        let words = words.on_quadric_processor(&scene.format, planes as usize);
        let words = words.map_err(|why| refused(scene, slot, why))?;
        Ok(Part::of(scene, slot, ProcessorWords::Quadric(words)))
    });
    alone.chain(members).collect()
}

/// The transparent objects of a scene, each for a slot of its own; the first is the farthest.
pub(super) fn layers(scene: &PreparedScene, machine: &ZoneMachine) -> Result<Vec<Part>> {
    if scene.layers.len() > machine.layers.len() {
        let (needed, given) = (scene.layers.len(), machine.layers.len());
        return Err(PlanError::Layers(needed, given));
    }
    let layers = scene.layers.iter().zip(&machine.layers);
    let layers = layers.map(|(slot, own)| part_of(scene, slot.clone(), &[*own]));
    layers.collect()
}

fn refused(scene: &PreparedScene, slot: &Slot, why: AsQuadricError) -> PlanError {
    PlanError::Object(scene.objects[slot.object].name().to_owned(), why)
}

/// A part that is in no solid, for one of the slots of a machine.
fn part_of(scene: &PreparedScene, slot: Slot, slots: &[FittedSlot]) -> Result<Part> {
    let own = own_kind(slot.words.clone());
    let needed = required(&own);
    let has_place = |needed: &FittedSlot| slots.iter().any(|slot| slot.holds(needed));
    if needed.is_some_and(|needed| needed.kind != Kind::Quadric) {
        let part = Part::of(scene, &slot, own);
        if has_place(&part.needed) {
            return Ok(part);
        }
    }
    let quadrics = slots.iter().filter(|slot| slot.kind == Kind::Quadric);
    let planes = quadrics.map(|slot| slot.planes as usize).max();
    let most = planes.unwrap_or(MAX_PLANES);
    let words = slot.words.on_quadric_processor(&scene.format, most);
    let no_slot = |needed| {
        let object = scene.objects[slot.object].name().to_owned();
        PlanError::NoSlot(object, needed, slots::print(slots))
    };
    match (words, needed) {
        (Ok(words), _) if planes.is_some() => {
            let part = Part::of(scene, &slot, ProcessorWords::Quadric(words));
            match has_place(&part.needed) {
                true => Ok(part),
                false => Err(no_slot(part.needed)),
            }
        }
        (Ok(_), needed) => Err(no_slot(needed.unwrap_or(FittedSlot::NONE))),
        (Err(AsQuadricError::Processor(_)), Some(needed)) => Err(no_slot(needed)),
        (Err(why), _) => Err(refused(scene, &slot, why)),
    }
}

/// The processors and parts of one draw pass after another, until all parts that are in no solid are drawn: each
/// part goes to the free slot that is for it and has the fewest planes, and of these the fewest bits. Parts of one
/// object keep their order, in the slots of a pass too, because of two that are equally deep the first is seen.
pub(super) fn shared_out(
    all: &[Part],
    parts: &[u32],
    machine: &ZoneMachine,
) -> Vec<Vec<(usize, u32)>> {
    let slots = &machine.slots[..machine.alone()];
    let mut left = parts.to_vec();
    let mut passes = vec![];
    while !left.is_empty() {
        let mut pass: Vec<(usize, u32)> = vec![];
        let (mut free, mut waits) = (vec![true; slots.len()], None);
        left.retain(|&index| {
            let part = &all[index as usize];
            let after = match pass.last() {
                _ if waits == Some(part.object) => return true,
                Some(&(slot, last)) if all[last as usize].object == part.object => slot + 1,
                _ => 0,
            };
            let places = after..slots.len();
            let places = places.filter(|&place| free[place] && slots[place].holds(&part.needed));
            let size = |slot: &FittedSlot| (slot.planes, slot.bits());
            let Some(place) = places.min_by_key(|&place| size(&slots[place])) else {
                waits = Some(part.object);
                return true;
            };
            free[place] = false;
            pass.push((place, index));
            false
        });
        passes.push(pass);
    }
    passes
}
