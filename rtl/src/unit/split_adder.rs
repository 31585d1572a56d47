//! Adder whose carry can be cut in the middle.

use crate::kernel::*;

/// One sum of `F = 2 W` bits, or two sums of `W` bits side by side.
///
/// | port | direction | format |
/// |---|---|---|
/// | `a`, `b` | in | `F` bits |
/// | `split` | in | cut the carry at bit `W` |
/// | `sum` | out | `F` bits |
///
/// Latency 0: an adder with one AND in its carry chain. Chaillou 1991, IV.1.7.
pub struct SplitAdder<const W: usize, const W1: usize, const F: usize> {
    /// Addend.
    pub a: Signal<In, Word<F>>,
    /// Addend.
    pub b: Signal<In, Word<F>>,
    /// Cut the carry.
    pub split: Signal<In, Bit>,
    /// Sum, or two sums.
    pub sum: Signal<Out, Word<F>>,
    a_low: Signal<Local, Word<W>>,
    b_low: Signal<Local, Word<W>>,
    a_high: Signal<Local, Word<W>>,
    b_high: Signal<Local, Word<W>>,
    high: Signal<Local, Word<W>>,
    a_low_wide: Signal<Local, Word<W1>>,
    b_low_wide: Signal<Local, Word<W1>>,
    low: Signal<Local, Word<W1>>,
    carry: Signal<Local, Bit>,
    high_part: Signal<Local, Word<F>>,
    low_part: Signal<Local, Word<F>>,
    low_sum: Signal<Local, Word<W>>,
    half: Constant<Word<8>>,
    one: Constant<Word<W>>,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const F: usize] SplitAdder [W, W1, F]
    inputs { a, b, split }
    parts { sum, a_low, b_low, a_high, b_high, high, a_low_wide, b_low_wide, low, carry,
        high_part, low_part, low_sum, half, one }
    data { }
}

impl<const W: usize, const W1: usize, const F: usize> SplitAdder<W, W1, F> {
    /// An adder of two halves of `W` bits.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other.
    pub fn new() -> Self {
        assert!(
            W1 == W + 1 && F == 2 * W,
            "a carry has one bit more than a half, the whole two halves"
        );
        fields! {
            [a, b, split, sum, a_low, b_low, a_high, b_high, high, a_low_wide, b_low_wide, low,
                carry, high_part, low_part, low_sum]
            half: constant(W as u64),
            one: constant(1),
        }
    }
}

impl<const W: usize, const W1: usize, const F: usize> Default for SplitAdder<W, W1, F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const W1: usize, const F: usize> Logic for SplitAdder<W, W1, F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("split_adder");
        self.a_low.next = self.a.val().get_bits::<W>(0);
        self.b_low.next = self.b.val().get_bits::<W>(0);
        self.a_high.next = self.a.val().get_bits::<W>(self.half.val().index());
        self.b_high.next = self.b.val().get_bits::<W>(self.half.val().index());
        self.a_low_wide.next = bit_cast::<W1, W>(self.a_low.val());
        self.b_low_wide.next = bit_cast::<W1, W>(self.b_low.val());
        self.low.next = self.a_low_wide.val() + self.b_low_wide.val();
        self.carry.next = self.low.val().get_bit(self.half.val().index()) & !self.split.val();
        if self.carry.val() {
            self.high.next = self.a_high.val() + self.b_high.val() + self.one.val();
        } else {
            self.high.next = self.a_high.val() + self.b_high.val();
        }
        self.low_sum.next = self.low.val().get_bits::<W>(0);
        self.low_part.next = bit_cast::<F, W>(self.low_sum.val());
        self.high_part.next = bit_cast::<F, W>(self.high.val());
        self.sum.next = (self.high_part.val() << self.half.val()) | self.low_part.val();
    }
}
