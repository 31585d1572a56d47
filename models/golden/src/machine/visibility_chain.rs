//! The decider as a chain past the processors (source: Chaillou, IV.3.2): each hands on the nearer of its own object
//! and what comes to it.

/// Clocks after input 0 at which input i of the same pixel is taken: one for each cell that stands before it.
pub fn starts(inputs: usize) -> Vec<usize> {
    (0..inputs).collect()
}

/// Latency in clocks from input 0: one for each cell.
pub const fn latency(inputs: usize) -> u32 {
    inputs as u32
}
