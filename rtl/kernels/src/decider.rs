//! The visible object of a pixel.

use crate::{Candidate, Nearest, VisibilityNode};
use rust_hdl::prelude::*;

/// The nearest of four candidates by a tree of nodes. Latency 2.
#[derive(LogicBlock, Default)]
pub struct Decider<const D: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// First candidate.
    pub input_0: Candidate<D, N>,
    /// Second candidate.
    pub input_1: Candidate<D, N>,
    /// Third candidate.
    pub input_2: Candidate<D, N>,
    /// Fourth candidate.
    pub input_3: Candidate<D, N>,
    /// The nearest.
    pub nearest: Nearest<D, N>,
    first: VisibilityNode<D, N>,
    second: VisibilityNode<D, N>,
    last: VisibilityNode<D, N>,
}

impl<const D: usize, const N: usize> Logic for Decider<D, N> {
    #[hdl_gen]
    fn update(&mut self) {
        clock!(self, clock, first, second, last);
        Candidate::<D, N>::link(&mut self.input_0, &mut self.first.a);
        Candidate::<D, N>::link(&mut self.input_1, &mut self.first.b);
        Candidate::<D, N>::link(&mut self.input_2, &mut self.second.a);
        Candidate::<D, N>::link(&mut self.input_3, &mut self.second.b);
        Nearest::<D, N>::join(&mut self.first.nearest, &mut self.last.a);
        Nearest::<D, N>::join(&mut self.second.nearest, &mut self.last.b);
        Nearest::<D, N>::link(&mut self.nearest, &mut self.last.nearest);
    }
}
