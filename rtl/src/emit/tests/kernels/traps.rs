//! Kernels that rust-hdl's own printer gets wrong when they are written with its bit types and plain numbers.

use super::*;

kernel!(WideSum, Word<9>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("wide_sum");
        self.result.next = bit_cast::<9, 8>(self.a.val() + self.b.val());
    }
});

kernel!(SumIsEqual, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sum_is_equal");
        self.result.next = (self.a.val() + self.one.val()) == self.b.val();
    }
});

kernel!(SumIsBelow, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sum_is_below");
        self.result.next = (self.a.val() + self.b.val()) < self.limit.val();
    }
});

kernel!(InverseIsEqual, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("inverse_is_equal");
        self.result.next = !self.a.val() == self.b.val();
    }
});

kernel!(MaskIsEqual, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("mask_is_equal");
        self.result.next = self.a.val() & self.b.val() == self.b.val();
    }
});

kernel!(NarrowedIsBelow, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("narrowed_is_below");
        self.result.next = self.s.val().get_bits::<4>(0) < self.t.val().get_bits::<4>(4);
    }
});

kernel!(DifferenceIsNegative, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("difference_is_negative");
        self.result.next = (self.s.val() - self.t.val()) < self.zero.val();
    }
});

kernel!(LessOneIsAbove, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("less_one_is_above");
        self.result.next = self.a.val() - self.one.val() > self.b.val();
    }
});

/// All kernels of this file, simulated on the vectors.
pub(super) fn all(vectors: &[[u64; 11]]) -> Vec<Tested> {
    vec![
        WideSum::tested(vectors),
        SumIsEqual::tested(vectors),
        SumIsBelow::tested(vectors),
        InverseIsEqual::tested(vectors),
        MaskIsEqual::tested(vectors),
        NarrowedIsBelow::tested(vectors),
        DifferenceIsNegative::tested(vectors),
        LessOneIsAbove::tested(vectors),
    ]
}
