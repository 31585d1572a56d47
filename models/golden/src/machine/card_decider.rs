//! The decider of a machine of cards: a chain on each card, a tree between the cards (source: Chaillou, IV.3.6, as it
//! was being built).

use super::{decider, visibility_chain};

/// Clocks after input 0 at which input `processors * card + place` of the same pixel is taken: the cards start
/// together.
pub fn starts(processors: usize, cards: usize) -> Vec<usize> {
    (0..processors * cards).map(|i| i % processors).collect()
}

/// Latency in clocks from input 0.
pub fn latency(processors: usize, cards: usize) -> u32 {
    visibility_chain::latency(processors) + decider::latency(cards)
}
