//! Sum of one colour over passes.

use crate::kernel::*;

/// Adds a value to a sum and gives the mean that the sum would be of 4 or of 16 values.
///
/// | port | direction | format |
/// |---|---|---|
/// | `value` | in | 8 bits |
/// | `earlier` | in | 12 bits, the sum of the passes before |
/// | `first` | in | there is none before |
/// | `fine` | in | 16 values, not 4 |
/// | `sum` | out | 12 bits |
/// | `mean` | out | 8 bits, `floor((sum + 8) / 16)` or `floor((sum + 2) / 4)` |
///
/// Without registers.
pub struct PassSum {
    /// The value of this pass.
    pub value: Signal<In, Word<8>>,
    /// The sum of the passes before.
    pub earlier: Signal<In, Word<12>>,
    /// There is none before.
    pub first: Signal<In, Bit>,
    /// 16 values.
    pub fine: Signal<In, Bit>,
    /// The sum.
    pub sum: Signal<Out, Word<12>>,
    /// The mean.
    pub mean: Signal<Out, Word<8>>,
    wide: Signal<Local, Word<12>>,
    total: Signal<Local, Word<12>>,
    fine_sum: Signal<Local, Word<12>>,
    coarse_sum: Signal<Local, Word<12>>,
    fine_half: Constant<Word<12>>,
    coarse_half: Constant<Word<12>>,
    _asleep: bool,
}

block! {
    [] PassSum []
    inputs { value, earlier, first, fine }
    parts { sum, mean, wide, total, fine_sum, coarse_sum, fine_half, coarse_half }
    data { }
}

impl PassSum {
    pub(super) fn new() -> Self {
        fields! {
            [value, earlier, first, fine, sum, mean, wide, total, fine_sum, coarse_sum]
            fine_half: constant(8),
            coarse_half: constant(2),
        }
    }
}

impl Logic for PassSum {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("pass_sum");
        self.wide.next = bit_cast::<12, 8>(self.value.val());
        self.total.next = self.earlier.val() + self.wide.val();
        if self.first.val() {
            self.total.next = self.wide.val();
        }
        self.fine_sum.next = self.total.val() + self.fine_half.val();
        self.coarse_sum.next = self.total.val() + self.coarse_half.val();
        self.sum.next = self.total.val();
        self.mean.next = self.coarse_sum.val().get_bits::<8>(2);
        if self.fine.val() {
            self.mean.next = self.fine_sum.val().get_bits::<8>(4);
        }
    }
}
