//! Object processors side by side, with their words and the decider.

use super::slot::{Lanes, Place, bus, processor};
use super::{Candidate, Extent, LoadBus, decided, products};
use crate::arith::Network;
use crate::object::{Normal, Widths};
use crate::raster::{Scan, lane_scans, lanes_latency};
use crate::rows::{PerLane, in_lane};
use imogene_contract::object::ProductSlots;
use imogene_contract::slots::FittedSlot;
use imogene_contract::{DeciderForm, MachineWords};
use imogene_hdl::{Bits, Bundle, Int, Value, bundle, bundles, module};

/// Bits of the id of an object.
pub const ID: u32 = 12;

bundle! {
    /// The load bus of objects.
    Load(width) {
        valid: Bits(1), "write a coefficient word";
        object: Bits(8), "slot of the word";
        address: Bits(8), "address of the word within its slot (table of the load bus)";
        data: Bits(width), "the word; a narrower one sits in the low bits";
    }
}

impl Load {
    /// The load bus of one slot.
    pub(super) fn of(&self, slot: u64) -> LoadBus {
        LoadBus {
            write: self.valid & self.object.is(slot),
            address: self.address,
            data: self.data,
        }
    }
}

bundles! {
    /// The surface that is seen at a pixel.
    #[derive(Copy)]
    Surface {
        depth: Int as "depth", "depth, the far end where there is none";
        id: Bits as "id", "its object";
        /// Its normal.
        normal: Normal as "";
    }
}

/// What object processors side by side are built for.
#[derive(Clone, Debug)]
pub struct Objects {
    /// Bits of the words of an object, in slots that have not fewer of their own.
    pub words: MachineWords,
    /// Rows of the root networks between registers.
    pub rows_per_stage: u32,
    /// Slots, at least one.
    pub slots: Vec<FittedSlot>,
    /// Products of solids, whose slots are the last, product by product.
    pub products: Vec<ProductSlots>,
    /// How the nearest is chosen.
    pub decider: DeciderForm,
    /// Pixels of a line that are drawn at once, a power of two.
    pub lanes: u32,
}

impl Objects {
    /// The longest words of an object.
    pub fn widths(&self) -> Widths {
        Widths::of(&self.words)
    }

    /// Bits of the load bus: those of the widest word.
    pub fn bus(&self) -> u32 {
        self.bus_of(&self.slots)
    }

    /// The same of other slots.
    pub fn bus_of(&self, slots: &[FittedSlot]) -> u32 {
        bus(slots, &self.widths())
    }

    /// Words and root of a slot.
    pub(super) fn of_slot(&self, slot: &FittedSlot) -> (Widths, Network) {
        let words = slot.words(&self.words);
        (Widths::of(&words), Network::of(&words, self.rows_per_stage))
    }

    /// The nearest of the objects at every pixel of each lane, each loaded by its bus, with ids of so many bits. Where
    /// words are held, `take` says when they and the loaded ids are taken over; else the id of an object is its place.
    pub(super) fn nearest(
        &self,
        scan: Scan,
        buses: impl Fn(u64) -> LoadBus,
        id_bits: u32,
        take: Option<Bits>,
    ) -> PerLane<(Bits, Candidate)> {
        let (starts, wait) = (self.starts(), lanes_latency(self.lanes));
        let mut late = vec![scan];
        for _ in 0..wait + starts.iter().copied().max().unwrap_or(0) {
            late.push(late[late.len() - 1].delayed(1));
        }
        let name = |of: &str, index: usize| format!("{of}_{index}");
        let place = |index: usize| Place {
            at: name("processors", index),
            store: name("stores", index),
            bus: buses(index as u64),
            hold: take.map(|take| (name("holds", index), take)),
        };
        // All stores, then all processors: equal modules stand one after the other.
        let slots = self.slots.iter().enumerate().map(|(index, slot)| {
            let (place, words) = (place(index), self.of_slot(slot));
            let stored = place.stored(slot, words.0);
            (slot, place, stored, words)
        });
        let slots: Vec<_> = slots.collect();
        let slots = slots.into_iter().zip(&starts).enumerate();
        let seen = slots.map(|(index, ((slot, place, stored, words), start))| {
            let lanes = Lanes {
                raster: late[*start as usize],
                scans: &lane_scans(late[(*start + wait) as usize], self.lanes),
            };
            let (seen, held) = processor(slot, (&place, stored), &lanes, words);
            let id = held.unwrap_or(Bits::new(index as u64, id_bits));
            let seen = seen.into_iter();
            seen.map(|seen| (seen.front.out_valid, Extent::of(seen, id)))
                .collect()
        });
        let seen: Vec<Vec<(Bits, Extent)>> = seen.collect();
        let before = wait + starts[0] + self.slot_clocks(&self.slots[0]);
        PerLane::of(self.lanes, |lane| {
            let seen = seen.iter().map(|slot| slot[lane as usize]);
            let (valid, extents): (Vec<Bits>, Vec<Extent>) = seen.unzip();
            let valid = valid[0].delayed_as("valid_late", self.clocks() - before);
            let at = in_lane("decider", lane, self.lanes);
            let candidates = self.candidates(extents, lane);
            (valid, decided(&at, candidates, self.decider))
        })
    }

    /// What is seen of the objects that are in no solid, and of the products.
    fn candidates(&self, extents: Vec<Extent>, lane: u32) -> Vec<Candidate> {
        let (alone, members) = extents.split_at(self.alone());
        let alone = alone.iter().map(|extent| extent.face);
        let at = in_lane("products", lane, self.lanes);
        let products = products(&at, members, &self.products);
        alone.chain(products).collect()
    }
}

/// What is seen of the objects at every pixel of each lane, and whether there is a pixel: of surfaces at equal depths
/// that of the smaller id. Latency [`Objects::clocks`].
///
/// If the words are held (a machine that shares its processors in time), `take` comes before the first flags of a
/// pass, the next words may be loaded once all processors have started, and an object that was not loaded since the
/// last `take` is absent. Otherwise the words act as they are loaded, the id of an object is its slot, and `take` does
/// nothing.
pub fn object_array(
    at: &str,
    scan: Scan,
    (take, load): (Bits, Load),
    objects: &Objects,
    is_held: bool,
) -> PerLane<(Bits, Surface)> {
    let inputs = (scan, ("take", take), ("load", load));
    module("object_array", at, inputs, |(scan, take, load)| {
        // The bus reaches every slot through a register of its own.
        let buses = |slot| load.of(slot).registered();
        let nearest = objects.nearest(scan, buses, ID, is_held.then_some(take));
        nearest.map(|(valid, nearest)| {
            let Candidate {
                depth, id, normal, ..
            } = nearest;
            (("out_valid", valid), Surface { depth, id, normal })
        })
    })
}
