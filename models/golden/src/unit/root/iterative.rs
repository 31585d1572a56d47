//! The iterative form: one restoring row, used once for each digit (source: 2.3.3).

use super::exact::Root;

/// What the unit shows after a clock edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct IterativeOutputs {
    /// Digits are being found; `start` is ignored.
    pub busy: bool,
    /// This edge found the last digit: root and remainder are complete. High for one clock.
    pub done: bool,
    /// Root, complete while not busy.
    pub root: u64,
    /// Remainder, complete while not busy.
    pub remainder: u64,
}

/// The unit, clock by clock: registers for the pairs left (`2 K` bits), the root (`K`), the remainder (`K + 1`) and the
/// digits left.
///
/// `start` is obeyed when not busy, and its edge finds the first digit already, so that `done` comes with the edge
/// number `K` counted from that one. `busy` is high after the edges before it. A new `start` may stand at the edge
/// after `done`: a result every `K` clocks.
#[derive(Clone, Debug)]
pub struct IterativeRoot {
    root_bits: u32,
    pairs: u128,
    left: u32,
    shown: IterativeOutputs,
}

impl IterativeRoot {
    /// A unit at rest; `root_bits` is 2 to 62.
    pub fn new(root_bits: u32) -> IterativeRoot {
        IterativeRoot {
            root_bits,
            pairs: 0,
            left: 0,
            shown: IterativeOutputs::default(),
        }
    }

    /// One clock edge; what it shows.
    pub fn clock(&mut self, start: bool, radicand: u128) -> IterativeOutputs {
        let begins = start && self.left == 0;
        if begins {
            self.pairs = radicand;
            self.left = self.root_bits;
            (self.shown.root, self.shown.remainder) = (0, 0);
        }
        self.shown.done = self.left == 1;
        if self.left > 0 {
            self.left -= 1;
            self.row();
        }
        self.shown.busy = self.left > 0;
        self.shown
    }

    fn row(&mut self) {
        let pair = (self.pairs >> (2 * self.left)) as u64 & 3;
        let partial = 4 * self.shown.remainder + pair;
        let divisor = 4 * self.shown.root + 1;
        let digit = partial >= divisor;
        self.shown.remainder = partial - if digit { divisor } else { 0 };
        self.shown.root = 2 * self.shown.root + u64::from(digit);
    }
}

/// A radicand of `2 root_bits` bits through the unit; `root_bits` is 1 to 61.
pub fn iterative_root(radicand: u128, root_bits: u32) -> Root {
    let mut unit = IterativeRoot::new(root_bits);
    let mut shown = unit.clock(true, radicand);
    while !shown.done {
        shown = unit.clock(false, 0);
    }
    Root {
        root: shown.root,
        remainder: shown.remainder,
    }
}
