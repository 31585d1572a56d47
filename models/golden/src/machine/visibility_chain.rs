//! The decider as a chain past the processors (source: Chaillou, IV.3.2): each hands on the nearer of its own object
//! and what comes to it.

use super::decider::{Visible, visibility_node};
use super::skew::Skewed;

/// Clocks after input 0 at which input i of the same pixel is taken: one for each cell that stands before it.
pub fn starts(inputs: usize) -> Vec<usize> {
    (0..inputs).collect()
}

/// Latency in clocks from input 0: one for each cell.
pub const fn latency(inputs: usize) -> u32 {
    inputs as u32
}

/// The chain, cell by cell; a cell is empty until something comes to it.
#[derive(Clone, Debug)]
pub struct VisibilityChain {
    cells: Vec<Option<Visible>>,
}

impl VisibilityChain {
    /// A chain past so many processors.
    pub fn new(inputs: usize) -> VisibilityChain {
        VisibilityChain {
            cells: vec![None; inputs],
        }
    }

    /// One clock: what the processors hand on in it; what the last cell holds after it, if a pixel came all the way.
    pub fn clock(&mut self, inputs: &[Visible]) -> Option<Visible> {
        for i in (1..self.cells.len()).rev() {
            self.cells[i] = self.cells[i - 1].map(|nearest| visibility_node(nearest, inputs[i]));
        }
        self.cells[0] = inputs.first().copied();
        *self.cells.last()?
    }
}

/// The inputs of whole pixels from those of a chain.
pub fn pixels(inputs: usize) -> Skewed<Visible> {
    Skewed::new(starts(inputs))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::card_decider;
    use crate::machine::card_decider::CardDecider;
    use crate::machine::decider::decide;
    use proptest::prelude::*;

    /// Clocks of inputs `starts[i]` late each for the pixels; what is between holds the last object.
    fn skewed(pixels: &[Vec<Visible>], starts: &[usize]) -> Vec<Vec<Visible>> {
        let clocks = pixels.len() + starts.iter().max().unwrap();
        let input = |clock: usize, i: usize| {
            let pixel = clock.saturating_sub(starts[i]).min(pixels.len() - 1);
            pixels[pixel][i]
        };
        (0..clocks)
            .map(|clock| (0..starts.len()).map(|i| input(clock, i)).collect())
            .collect()
    }

    /// Objects with different ids and few depths, in some order and in another.
    fn orders(count: usize) -> impl Strategy<Value = (Vec<Visible>, Vec<Visible>)> {
        let depths = proptest::collection::vec((-2i64..2, any::<[i16; 3]>()), count);
        depths.prop_flat_map(|fields| {
            let objects: Vec<Visible> = fields
                .iter()
                .enumerate()
                .map(|(id, &(depth, normal))| Visible {
                    depth,
                    id: id as u8,
                    number: (id % 16) as u8,
                    normal,
                })
                .collect();
            (
                Just(objects.clone()).prop_shuffle(),
                Just(objects).prop_shuffle(),
            )
        })
    }

    #[test]
    fn a_chain_of_one_is_a_register() {
        let one = Visible {
            depth: 3,
            id: 1,
            number: 2,
            normal: [1, 2, 3],
        };
        assert_eq!(VisibilityChain::new(1).clock(&[one]), Some(one));
        assert_eq!([1, 2, 9].map(latency), [1, 2, 9]);
    }

    proptest! {
        /// Tree, chain and cards give the same object whichever way the objects are spread over the inputs.
        #[test]
        fn every_decider_decides_alike_in_any_order(
            pixels in proptest::collection::vec(orders(12), 1..8),
            cards in prop_oneof![Just(1usize), Just(2), Just(3), Just(4), Just(6), Just(12)],
        ) {
            let (some, other): (Vec<_>, Vec<_>) = pixels.into_iter().unzip();
            let expected: Vec<Visible> = some.iter().map(|objects| decide(objects)).collect();
            for order in [&some, &other] {
                let tree: Vec<Visible> = order.iter().map(|objects| decide(objects)).collect();
                prop_assert_eq!(&tree, &expected);

                let mut chain = VisibilityChain::new(12);
                let rows = skewed(order, &starts(12));
                let found: Vec<_> = rows.iter().map(|row| chain.clock(row)).collect();
                let aligned: Vec<_> = found[latency(12) as usize - 1..].iter().copied().flatten().collect();
                prop_assert_eq!(&aligned, &expected);
                prop_assert!(found[..latency(12) as usize - 1].iter().all(Option::is_none));

                let processors = 12 / cards;
                let mut hybrid = CardDecider::new(processors, cards);
                let rows = skewed(order, &card_decider::starts(processors, cards));
                let found: Vec<_> = rows.iter().map(|row| hybrid.clock(row)).collect();
                let aligned: Vec<_> = found[processors - 1..].iter().copied().flatten().collect();
                prop_assert_eq!(&aligned, &expected);

                // The rule for the skew is what puts whole pixels together.
                let mut whole = super::pixels(12);
                let rows = skewed(order, &starts(12));
                let together: Vec<_> = rows.into_iter().filter_map(|row| whole.push(row)).collect();
                prop_assert_eq!(&together, order);
            }
        }
    }
}
