//! Clocking a block by hand.
//!
//! rust-hdl's own `Simulation` meets its test benches over channels at every event; stepping by hand is several times
//! faster and needs no threads.

use rust_hdl::core::prelude::{Block, Clock, In, Signal, simulate};

/// Passes after which a block that has not settled is considered to oscillate. The deepest path of the units, through a
/// decider of 256 objects, settles in well under half of them.
const PASSES: usize = 400;

/// A block with one clock.
pub trait Clocked: Block {
    /// The clock input.
    fn clock_port(&mut self) -> &mut Signal<In, Clock>;
}

/// Lets the inputs settle, then gives one rising edge. The outputs are those after the edge.
///
/// # Panics
///
/// When the block does not settle, which no block of this crate does.
pub fn step<B: Clocked>(block: &mut B) {
    block.clock_port().next = Clock { clk: false };
    assert!(
        simulate(block, PASSES),
        "the block oscillates before the edge"
    );
    block.clock_port().next = Clock { clk: true };
    assert!(
        simulate(block, PASSES),
        "the block oscillates after the edge"
    );
}
