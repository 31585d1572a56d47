//! The decider of a machine of cards: a chain on each card, a tree between the cards (source: Chaillou, IV.3.6, as it
//! was being built).

use super::decider::{self, Visible, decide};
use super::visibility_chain::{self, VisibilityChain};

/// Clocks after input 0 at which input `processors * card + place` of the same pixel is taken: the cards start
/// together.
pub fn starts(processors: usize, cards: usize) -> Vec<usize> {
    (0..processors * cards).map(|i| i % processors).collect()
}

/// Latency in clocks from input 0.
pub fn latency(processors: usize, cards: usize) -> u32 {
    visibility_chain::latency(processors) + decider::latency(cards)
}

/// The chains of all cards; the tree behind them takes [`decider::latency`] clocks more.
#[derive(Clone, Debug)]
pub struct CardDecider {
    processors: usize,
    chains: Vec<VisibilityChain>,
}

impl CardDecider {
    /// So many cards of so many processors.
    pub fn new(processors: usize, cards: usize) -> CardDecider {
        CardDecider {
            processors,
            chains: vec![VisibilityChain::new(processors); cards],
        }
    }

    /// One clock: what the processors hand on in it; what the tree is given after it, joined.
    pub fn clock(&mut self, inputs: &[Visible]) -> Option<Visible> {
        let cards = self.chains.iter_mut().zip(inputs.chunks(self.processors));
        // Every card has its clock, also when another has nothing to hand on.
        let nearest: Vec<Option<Visible>> = cards.map(|(chain, card)| chain.clock(card)).collect();
        let nearest: Option<Vec<Visible>> = nearest.into_iter().collect();
        nearest.map(|list| decide(&list))
    }
}
