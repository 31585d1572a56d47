//! Products of solids in the slots of a machine.

use imogene_contract::object::ProductSlots;
use imogene_golden::machine::zone::ZoneMachine;

/// A product in a zone, by the indices of its parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ZoneProduct {
    /// Objects intersected.
    pub intersected: Vec<u32>,
    /// Objects taken away, of which there is something in the zone.
    pub subtracted: Vec<u32>,
}

impl ZoneProduct {
    /// All its parts.
    pub fn parts(&self) -> impl Iterator<Item = u32> + '_ {
        self.intersected.iter().chain(&self.subtracted).copied()
    }

    fn size(&self) -> [usize; 2] {
        [self.intersected.len(), self.subtracted.len()]
    }
}

/// The members of a product in slots that are enough for it, each with its place. The first of those intersected
/// stands again where there is a slot too many; one to take away too many stays empty.
pub(crate) fn in_slots<T: Clone>(
    slots: &ProductSlots,
    [intersected, subtracted]: [&[T]; 2],
) -> Vec<(usize, T)> {
    let again = std::iter::repeat_n(&intersected[0], slots.intersected - intersected.len());
    let kept = intersected.iter().chain(again).enumerate();
    let taken_away = (slots.intersected..).zip(subtracted);
    let places = kept.chain(taken_away);
    let members = places.map(|(place, member)| (place, member.clone()));
    members.collect()
}

/// The processors and parts of one draw pass after another, until all products are drawn: each pass takes those that
/// find a product of the machine which is free and large enough, of such the smallest. All are large enough for one.
pub fn in_passes(machine: &ZoneMachine, products: &[ZoneProduct]) -> Vec<Vec<(usize, u32)>> {
    let mut left: Vec<&ZoneProduct> = products.iter().collect();
    let mut passes = vec![];
    while !left.is_empty() {
        let (mut pass, mut free) = (vec![], places(machine));
        left.retain(|product| {
            let large = free.iter().enumerate();
            let large = large.filter(|(_, (_, slots))| slots.hold(product.size()));
            let Some((place, _)) = large.min_by_key(|(_, (_, slots))| slots.count()) else {
                return true;
            };
            let (first, slots) = free.remove(place);
            let members = [&product.intersected[..], &product.subtracted];
            let members = in_slots(&slots, members).into_iter();
            pass.extend(members.map(|(place, part)| (first + place, part)));
            false
        });
        passes.push(pass);
    }
    passes
}

/// The products of a machine, each with its first processor.
fn places(machine: &ZoneMachine) -> Vec<(usize, ProductSlots)> {
    let mut first = machine.alone();
    let place = |slots: &ProductSlots| {
        let own = first;
        first += slots.count();
        (own, *slots)
    };
    machine.products.iter().map(place).collect()
}
