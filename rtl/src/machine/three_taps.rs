//! Weighted sum of three neighbours.

use crate::kernel::*;

/// Gives four times the weighted mean of a value and its neighbours, `M = N + 2` bits.
///
/// | port | direction | format |
/// |---|---|---|
/// | `earlier`, `here`, `later` | in | `N` bits |
/// | `kernel` | in | 2 bits: 0 `4 here`, 1 `2 earlier + 2 here`, 2 and 3 `earlier + 2 here + later` |
/// | `sum` | out | `M` bits |
///
/// Without registers. The weights of every kernel have the same sum, so all are rounded alike.
pub struct ThreeTaps<const N: usize, const M: usize> {
    /// Neighbour on the left or above.
    pub earlier: Signal<In, Word<N>>,
    /// The value.
    pub here: Signal<In, Word<N>>,
    /// Neighbour on the right or below.
    pub later: Signal<In, Word<N>>,
    /// Which weights.
    pub kernel: Signal<In, Word<2>>,
    /// The sum.
    pub sum: Signal<Out, Word<M>>,
    first: Signal<Local, Word<N>>,
    third: Signal<Local, Word<N>>,
    wide_first: Signal<Local, Word<M>>,
    wide_here: Signal<Local, Word<M>>,
    wide_third: Signal<Local, Word<M>>,
    doubled: Signal<Local, Word<M>>,
    outer: Signal<Local, Word<M>>,
    one: Constant<Word<2>>,
    _asleep: bool,
}

block! {
    [const N: usize, const M: usize] ThreeTaps [N, M]
    inputs { earlier, here, later, kernel }
    parts { sum, first, third, wide_first, wide_here, wide_third, doubled, outer, one }
    data { }
}

impl<const N: usize, const M: usize> ThreeTaps<N, M> {
    pub(super) fn new() -> Self {
        assert!(M == N + 2, "M = N + 2");
        fields! {
            [earlier, here, later, kernel, sum, first, third, wide_first, wide_here, wide_third,
                doubled, outer]
            one: constant(1),
        }
    }
}

impl<const N: usize, const M: usize> Logic for ThreeTaps<N, M> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("three_taps");
        self.first.next = self.here.val();
        self.third.next = self.here.val();
        if self.kernel.val().get_bit(1) {
            self.first.next = self.earlier.val();
            self.third.next = self.later.val();
        } else if self.kernel.val().get_bit(0) {
            self.first.next = self.earlier.val();
            self.third.next = self.earlier.val();
        }
        self.wide_first.next = bit_cast::<M, N>(self.first.val());
        self.wide_here.next = bit_cast::<M, N>(self.here.val());
        self.wide_third.next = bit_cast::<M, N>(self.third.val());
        self.doubled.next = self.wide_here.val() << self.one.val();
        self.outer.next = self.wide_first.val() + self.wide_third.val();
        self.sum.next = self.outer.val() + self.doubled.val();
    }
}
