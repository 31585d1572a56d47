//! Inputs of one pixel that do not arrive together: where a decider runs past its processors, a later processor starts
//! later.

use std::collections::VecDeque;

/// Puts the inputs of a pixel together: input i of a pixel is taken `starts[i]` clocks after its first.
#[derive(Clone, Debug)]
pub struct Skewed<T> {
    starts: Vec<usize>,
    rows: VecDeque<Vec<T>>,
}

impl<T: Clone> Skewed<T> {
    /// Nothing was taken yet.
    /// Panics without inputs.
    pub fn new(starts: Vec<usize>) -> Skewed<T> {
        assert!(!starts.is_empty(), "a pixel has an input at least");
        Skewed {
            starts,
            rows: VecDeque::new(),
        }
    }

    /// Clocks from the first input of a pixel to its last.
    pub fn span(&self) -> usize {
        self.starts.iter().copied().max().unwrap_or(0)
    }

    /// One clock: what all inputs carry. Gives the inputs of the pixel whose last one this is, if the first ones were
    /// seen.
    pub fn push(&mut self, row: Vec<T>) -> Option<Vec<T>> {
        assert_eq!(row.len(), self.starts.len(), "an input for each start");
        self.rows.push_back(row);
        if self.rows.len() <= self.span() {
            return None;
        }
        let starts = self.starts.iter().enumerate();
        let pixel = starts.map(|(i, &start)| self.rows[start][i].clone());
        let pixel = pixel.collect();
        self.rows.pop_front();
        Some(pixel)
    }
}
