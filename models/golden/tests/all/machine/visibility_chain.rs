use imogene_golden::machine::card_decider;
use imogene_golden::machine::decider::{Visible, decide, visibility_node};
use imogene_golden::machine::skew::Skewed;
use imogene_golden::machine::visibility_chain::{latency, starts};
use proptest::prelude::*;

/// The chain, cell by cell; a cell is empty until something comes to it.
#[derive(Clone, Debug)]
struct VisibilityChain {
    cells: Vec<Option<Visible>>,
}

impl VisibilityChain {
    /// A chain past so many processors.
    fn new(inputs: usize) -> VisibilityChain {
        VisibilityChain {
            cells: vec![None; inputs],
        }
    }

    /// One clock: what the processors hand on in it; what the last cell holds after it, if a pixel came all the way.
    fn clock(&mut self, inputs: &[Visible]) -> Option<Visible> {
        for i in (1..self.cells.len()).rev() {
            self.cells[i] = self.cells[i - 1].map(|nearest| visibility_node(nearest, inputs[i]));
        }
        self.cells[0] = inputs.first().copied();
        *self.cells.last()?
    }
}

/// The chains of all cards; the tree behind them takes some clocks more.
#[derive(Clone, Debug)]
struct CardDecider {
    processors: usize,
    chains: Vec<VisibilityChain>,
}

impl CardDecider {
    /// So many cards of so many processors.
    fn new(processors: usize, cards: usize) -> CardDecider {
        CardDecider {
            processors,
            chains: vec![VisibilityChain::new(processors); cards],
        }
    }

    /// One clock: what the processors hand on in it; what the tree is given after it, joined.
    fn clock(&mut self, inputs: &[Visible]) -> Option<Visible> {
        let cards = self.chains.iter_mut().zip(inputs.chunks(self.processors));
        // Every card has its clock, also when another has nothing to hand on.
        let nearest: Vec<Option<Visible>> = cards.map(|(chain, card)| chain.clock(card)).collect();
        let nearest: Option<Vec<Visible>> = nearest.into_iter().collect();
        nearest.map(|list| decide(&list))
    }
}
/// Clocks of inputs `starts[i]` late each for the pixels; what is between holds the last object.
fn skewed(pixels: &[Vec<Visible>], starts: &[usize]) -> Vec<Vec<Visible>> {
    let clocks = pixels.len() + starts.iter().max().unwrap();
    let input = |clock: usize, i: usize| {
        let pixel = clock.saturating_sub(starts[i]).min(pixels.len() - 1);
        pixels[pixel][i]
    };
    let inputs = |clock| (0..starts.len()).map(|i| input(clock, i)).collect();
    (0..clocks).map(inputs).collect()
}

/// Objects with different ids and few depths, in some order and in another.
fn orders(count: usize) -> impl Strategy<Value = (Vec<Visible>, Vec<Visible>)> {
    let depths = proptest::collection::vec((-2i64..2, any::<[i16; 3]>()), count);
    depths.prop_flat_map(|fields| {
        let object = |(id, (depth, normal)): (u8, (i64, [i16; 3]))| Visible {
            depth,
            id,
            number: id % 16,
            normal,
        };
        let objects: Vec<Visible> = (0..).zip(fields).map(object).collect();
        let shuffled = || Just(objects.clone()).prop_shuffle();
        (shuffled(), shuffled())
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
            let mut whole = Skewed::new(starts(12));
            let rows = skewed(order, &starts(12));
            let together: Vec<_> = rows.into_iter().filter_map(|row| whole.push(row)).collect();
            prop_assert_eq!(&together, order);
        }
    }
}
