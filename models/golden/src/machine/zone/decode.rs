//! Coefficient registers as a processor holds them, and what their bits mean.

use super::beat::OBJECT_ID;
use crate::format::Format;
use crate::object::slot::ProcessorWords;
use crate::object::volume::VolumeWords;
use crate::object::{load_slot, load_volume};
use imogene_contract::shading::MOST_MATERIALS;
use imogene_contract::slots::FittedSlot;
use imogene_contract::volume;

/// Address of the word that says that there is an object in a slot, or, without one, a volume.
pub fn presence(slot: Option<&FittedSlot>) -> u16 {
    slot.map_or(volume::CONTROL, |slot| slot.kind.presence()) as u16
}

/// Words of one processor; they hold until written again.
#[derive(Clone, Debug)]
pub struct Registers {
    /// The slot of an object processor; a volume processor has none.
    slot: Option<FittedSlot>,
    words: Vec<u64>,
    id: u64,
    /// The word that says that there is an object or a volume was written since the last pass that took it.
    present: bool,
}

impl Registers {
    /// Of an object processor.
    pub fn of_object(slot: &FittedSlot) -> Registers {
        Registers::new(Some(*slot), slot.kind.words(slot.planes as usize))
    }

    /// Of a volume processor.
    pub fn of_volume(planes: usize) -> Registers {
        Registers::new(None, volume::words(planes))
    }

    fn new(slot: Option<FittedSlot>, words: usize) -> Registers {
        Registers {
            slot,
            words: vec![0; words],
            id: 0,
            present: false,
        }
    }

    /// Writes a word; false if there is none at this address.
    pub fn write(&mut self, address: u16, data: u64) -> bool {
        if self.slot.is_some() && address == OBJECT_ID {
            self.id = data;
            return true;
        }
        let Some(word) = self.words.get_mut(usize::from(address)) else {
            return false;
        };
        *word = data;
        self.present |= address == presence(self.slot.as_ref());
        true
    }

    /// Was there an object or a volume since this was asked last?
    pub fn take(&mut self) -> bool {
        std::mem::take(&mut self.present)
    }

    /// Id of the object.
    pub fn id(&self) -> u16 {
        (self.id & ((1 << super::ID_BITS) - 1)) as u16
    }

    /// Of a transparent object its part of what is seen, in 255ths, which stands above id and material.
    pub fn weight(&self) -> u8 {
        (self.id >> (super::ID_BITS + MOST_MATERIALS.ilog2())) as u8
    }

    /// The object.
    /// Panics when it is a volume processor.
    pub fn object(&self, format: &Format) -> ProcessorWords {
        let slot = self.slot.expect("the slot of an object");
        load_slot::held(&self.words, format, &slot)
    }

    /// The volume.
    pub fn volume(&self, format: &Format) -> VolumeWords {
        load_volume::held(&self.words, format)
    }
}
