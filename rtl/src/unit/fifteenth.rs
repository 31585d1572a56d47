//! Division by fifteen.

use crate::kernel::*;

/// Gives `quotient = floor(value / 15)` without error, by additions alone.
///
/// `value` is below `2^39`. With its low 16 bits l and the rest h, `2^16 = 15 * 0x1111 + 1` gives the quotient
/// `0x1111 h + floor((h + l) / 15)`, and the floor is `((h + l + 1) * 0x111111) >> 24`. Both factors are sums of shifts: eight additions in all.
///
/// | port | direction | format |
/// |---|---|---|
/// | `value` | in | `P` bits, unsigned |
/// | `quotient` | out | `K1` bits, unsigned |
///
/// Without registers.
pub struct Fifteenth<const P: usize, const K1: usize> {
    /// The dividend.
    pub value: Signal<In, Word<P>>,
    /// A fifteenth of it, rounded down.
    pub quotient: Signal<Out, Word<K1>>,
    wide: Signal<Local, Word<48>>,
    high: Signal<Local, Word<48>>,
    low_bits: Signal<Local, Word<16>>,
    low: Signal<Local, Word<48>>,
    parts: Signal<Local, Word<48>>,
    more: Signal<Local, Word<48>>,
    more_4: Signal<Local, Word<48>>,
    ones_2: Signal<Local, Word<48>>,
    ones_2_8: Signal<Local, Word<48>>,
    ones_2_16: Signal<Local, Word<48>>,
    ones_4: Signal<Local, Word<48>>,
    ones_6: Signal<Local, Word<48>>,
    low_quotient: Signal<Local, Word<48>>,
    high_4: Signal<Local, Word<48>>,
    high_2: Signal<Local, Word<48>>,
    high_2_8: Signal<Local, Word<48>>,
    high_quotient: Signal<Local, Word<48>>,
    sum: Signal<Local, Word<48>>,
    one: Constant<Word<48>>,
    by_4: Constant<Word<8>>,
    by_8: Constant<Word<8>>,
    by_16: Constant<Word<8>>,
    by_24: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const P: usize, const K1: usize] Fifteenth [P, K1]
    inputs { value }
    parts { quotient, wide, high, low_bits, low, parts, more, more_4, ones_2, ones_2_8,
        ones_2_16, ones_4, ones_6, low_quotient, high_4, high_2, high_2_8, high_quotient,
        sum, one, by_4, by_8, by_16, by_24 }
    data {  }
}

impl<const P: usize, const K1: usize> Fifteenth<P, K1> {
    pub(super) fn new() -> Self {
        Self {
            value: Signal::default(),
            quotient: Signal::default(),
            wide: Signal::default(),
            high: Signal::default(),
            low_bits: Signal::default(),
            low: Signal::default(),
            parts: Signal::default(),
            more: Signal::default(),
            more_4: Signal::default(),
            ones_2: Signal::default(),
            ones_2_8: Signal::default(),
            ones_2_16: Signal::default(),
            ones_4: Signal::default(),
            ones_6: Signal::default(),
            low_quotient: Signal::default(),
            high_4: Signal::default(),
            high_2: Signal::default(),
            high_2_8: Signal::default(),
            high_quotient: Signal::default(),
            sum: Signal::default(),
            one: constant(1),
            by_4: constant(4),
            by_8: constant(8),
            by_16: constant(16),
            by_24: constant(24),
            _asleep: false,
        }
    }
}

impl<const P: usize, const K1: usize> Logic for Fifteenth<P, K1> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("fifteenth");
        self.wide.next = bit_cast::<48, P>(self.value.val());
        self.high.next = self.wide.val() >> self.by_16.val();
        self.low_bits.next = self.wide.val().get_bits::<16>(0);
        self.low.next = bit_cast::<48, 16>(self.low_bits.val());
        self.parts.next = self.high.val() + self.low.val();
        self.more.next = self.parts.val() + self.one.val();
        self.more_4.next = self.more.val() << self.by_4.val();
        self.ones_2.next = self.more.val() + self.more_4.val();
        self.ones_2_8.next = self.ones_2.val() << self.by_8.val();
        self.ones_2_16.next = self.ones_2.val() << self.by_16.val();
        self.ones_4.next = self.ones_2.val() + self.ones_2_8.val();
        self.ones_6.next = self.ones_4.val() + self.ones_2_16.val();
        self.low_quotient.next = self.ones_6.val() >> self.by_24.val();
        self.high_4.next = self.high.val() << self.by_4.val();
        self.high_2.next = self.high.val() + self.high_4.val();
        self.high_2_8.next = self.high_2.val() << self.by_8.val();
        self.high_quotient.next = self.high_2.val() + self.high_2_8.val();
        self.sum.next = self.high_quotient.val() + self.low_quotient.val();
        self.quotient.next = bit_cast::<K1, 48>(self.sum.val());
    }
}
