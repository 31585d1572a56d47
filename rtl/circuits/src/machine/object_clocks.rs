//! When the processors of a machine begin, and how long they take.

use super::slot::slot_clocks;
use super::{Objects, decider_clocks, lag, product_clocks};
use crate::raster::lanes_latency;
use imogene_contract::object::ProductSlots;
use imogene_contract::slots::FittedSlot;

impl Objects {
    /// Clocks from the flags of a pixel to what is seen: those of the longest processor and the decider.
    pub fn clocks(&self) -> u32 {
        let (start, (lag, after)) = (self.starts()[0], self.waits()[0]);
        let seen = start + self.slot_clocks(&self.slots[0]) + after - lag as u32;
        lanes_latency(self.lanes) + seen + decider_clocks(self.decider, self.choices())
    }

    /// Clocks from the flags of a pixel to what the processor of a slot sees.
    pub(super) fn slot_clocks(&self, slot: &FittedSlot) -> u32 {
        slot_clocks(slot, &self.of_slot(slot).1)
    }

    /// Objects and products that the decider chooses from.
    fn choices(&self) -> usize {
        self.alone() + self.products.len()
    }

    /// Slots of objects that are in no solid.
    pub(super) fn alone(&self) -> usize {
        let members: usize = self.products.iter().map(ProductSlots::count).sum();
        self.slots.len() - members
    }

    /// Clocks that the processor of each slot begins later than it would to answer with the first candidate of the
    /// decider, and those from what it sees to what is seen of its object or product.
    fn waits(&self) -> Vec<(i64, u32)> {
        let lag = |choice| i64::from(lag(self.decider, choice, self.choices()));
        let alone = (0..self.alone()).map(|choice| (lag(choice), 0));
        let products = (self.alone()..).zip(&self.products);
        let members = products.flat_map(|(choice, product)| {
            let after = product_clocks(product).into_iter();
            after.map(move |after| (lag(choice), after))
        });
        alone.chain(members).collect()
    }

    /// Clocks from the flags of a pixel until the processor of each slot begins: those with fewer stages begin later,
    /// so that all answer when the decider takes them.
    pub(super) fn starts(&self) -> Vec<u32> {
        let slots = self.slots.iter().zip(self.waits());
        let waits =
            slots.map(|(slot, (lag, after))| lag - i64::from(self.slot_clocks(slot) + after));
        let waits: Vec<i64> = waits.collect();
        let least = waits.iter().copied().min().unwrap_or(0);
        waits.iter().map(|wait| (wait - least) as u32).collect()
    }
}
