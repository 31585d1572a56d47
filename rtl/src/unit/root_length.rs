//! Length of a root, before the root is known.

use crate::kernel::*;

/// Gives `length = m`, the bits of the root of a radicand, which has `2m` or `2m - 1` significant bits; 0 for radicand 0.
///
/// | port | direction | format |
/// |---|---|---|
/// | `radicand` | in | `F` bits, unsigned |
/// | `length` | out | 6 bits, 0 to `F / 2` |
///
/// Without registers.
pub struct RootLength<const F: usize> {
    /// The number whose root is taken.
    pub radicand: Signal<In, Word<F>>,
    /// Bits of the root.
    pub length: Signal<Out, Word<6>>,
    zero: Constant<Word<6>>,
    low: Vec<Constant<Word<8>>>,
    high: Vec<Constant<Word<8>>>,
    bits: Vec<Constant<Word<6>>>,
    _pairs: usize,
    _asleep: bool,
}

block! {
    [const F: usize] RootLength [F]
    inputs { radicand }
    parts { length, zero, low, high, bits }
    data { _pairs }
}

impl<const F: usize> RootLength<F> {
    pub(super) fn new() -> Self {
        let pairs = F as u64 / 2;
        Self {
            radicand: Signal::default(),
            length: Signal::default(),
            zero: constant(0),
            low: (0..pairs).map(|pair| constant(2 * pair)).collect(),
            high: (0..pairs).map(|pair| constant(2 * pair + 1)).collect(),
            bits: (0..pairs).map(|pair| constant(pair + 1)).collect(),
            _pairs: F / 2,
            _asleep: false,
        }
    }
}

impl<const F: usize> Logic for RootLength<F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("root_length");
        self.length.next = self.zero.val();
        // The last assignment is the one that holds: the highest pair that is not zero.
        for i in 0..self._pairs {
            if self.radicand.val().get_bit(self.low[i].val().index())
                | self.radicand.val().get_bit(self.high[i].val().index())
            {
                self.length.next = self.bits[i].val();
            }
        }
    }
}
