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
    places
        .map(|(place, member)| (place, member.clone()))
        .collect()
}

/// The processors and parts of one draw pass after another, until all products are drawn: each pass takes those that
/// find a product of the machine which is free and large enough, of such the smallest. All are large enough for one.
pub(crate) fn in_passes(machine: &ZoneMachine, products: &[ZoneProduct]) -> Vec<Vec<(usize, u32)>> {
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
    let mut first = machine.object_processors;
    let place = |slots: &ProductSlots| {
        let own = first;
        first += slots.count();
        (own, *slots)
    };
    machine.products.iter().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two alone, then products of 2 - 1 and 1 - 3.
    fn machine() -> ZoneMachine {
        let products = [(2, 1), (1, 3)].map(|(intersected, subtracted)| ProductSlots {
            intersected,
            subtracted,
        });
        ZoneMachine {
            object_processors: 2,
            products: products.to_vec(),
            planes: 3,
            volume_processors: 0,
            volume_planes: 0,
            zone_width: 8,
            zone_height: 8,
            samples: 1,
        }
    }

    fn product(intersected: &[u32], subtracted: &[u32]) -> ZoneProduct {
        ZoneProduct {
            intersected: intersected.to_vec(),
            subtracted: subtracted.to_vec(),
        }
    }

    #[test]
    fn a_product_takes_the_smallest_slots_that_are_free_and_enough() {
        let products = [
            // Either would do, the smaller one is taken.
            product(&[10], &[11]),
            // Both want the larger one: one has to wait.
            product(&[12], &[13, 14]),
            product(&[15], &[16, 17, 18]),
            product(&[19, 20], &[]),
        ];
        let first = vec![(2, 10), (3, 10), (4, 11), (5, 12), (6, 13), (7, 14)];
        let second = vec![(5, 15), (6, 16), (7, 17), (8, 18), (2, 19), (3, 20)];
        assert_eq!(in_passes(&machine(), &products), [first, second]);
        assert!(in_passes(&machine(), &[]).is_empty());
    }
}
