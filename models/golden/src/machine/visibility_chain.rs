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
