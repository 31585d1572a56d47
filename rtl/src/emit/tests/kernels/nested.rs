//! Kernels of several operations and branches.

use super::*;
use crate::word::bits_signed;

kernel!(SumOfDifferences, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sum_of_differences");
        self.result.next = (self.a.val() - self.b.val()) + (self.b.val() - self.one.val());
    }
});

kernel!(InverseOfSum, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("inverse_of_sum");
        self.result.next = !(self.a.val() + self.b.val());
    }
});

kernel!(ShiftedSum, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("shifted_sum");
        self.result.next = (self.a.val() + self.b.val()) >> self.n.val();
    }
});

kernel!(SumOfShifted, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sum_of_shifted");
        self.result.next = (self.a.val() << self.n.val()) + (self.b.val() >> self.n.val());
    }
});

kernel!(ShiftedByDifference, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("shifted_by_difference");
        self.result.next = self.a.val() >> (self.b.val() - self.a.val());
    }
});

kernel!(MaskedSum, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("masked_sum");
        self.result.next = (self.a.val() + self.b.val()) & self.b.val();
    }
});

kernel!(ExtendedDifference, Word<9>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("extended_difference");
        self.result.next = bit_cast::<9, 8>(self.a.val() - self.b.val());
    }
});

kernel!(NarrowedSum, Word<4>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("narrowed_sum");
        self.result.next = bit_cast::<4, 8>(self.a.val() + self.b.val());
    }
});

kernel!(SliceOfSum, Word<3>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("slice_of_sum");
        self.result.next = (self.a.val() + self.b.val()).get_bits::<3>(5);
    }
});

kernel!(NegatedSum, Int<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("negated_sum");
        self.result.next = -(self.s.val() + self.t.val());
    }
});

kernel!(ExtendedSignedSum, Int<10>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("extended_signed_sum");
        self.result.next = bits_signed::<10, 8>(self.s.val() + self.t.val());
    }
});

kernel!(NegationIsBelow, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("negation_is_below");
        self.result.next = -self.s.val() < self.t.val();
    }
});

kernel!(ProductIsBelow, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("product_is_below");
        self.result.next = (self.h.val() * self.k.val()) < (self.k.val() * self.k.val());
    }
});

kernel!(MaskedProduct, Doubled<16>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("masked_product");
        self.result.next = (self.h.val() * self.k.val()) & (self.k.val() * self.k.val());
    }
});

kernel!(ReadAsSigned, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("read_as_signed");
        self.result.next = signed_cast(self.a.val()) < self.s.val();
    }
});

kernel!(ReadAsUnsigned, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("read_as_unsigned");
        self.result.next = unsigned_cast(self.s.val()) < self.a.val();
    }
});

kernel!(SignedReadExtended, Int<12>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("signed_read_extended");
        self.result.next = bits_signed::<12, 8>(signed_cast(self.a.val()));
    }
});

kernel!(ChainOfTests, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("chain_of_tests");
        self.result.next =
            ((self.a.val() < self.b.val()) & (self.s.val() < self.t.val())) | !self.p.val();
    }
});

kernel!(WideSumIsBelow, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("wide_sum_is_below");
        self.result.next = (self.v.val() + self.u.val()) < self.u.val();
    }
});

kernel!(ElseIf, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("else_if");
        if self.s.val() < self.zero.val() {
            self.result.next = !self.a.val();
        } else if (self.a.val() - self.b.val()) < self.limit.val() {
            self.result.next = self.one.val();
        } else {
            self.result.next = (self.a.val() + self.b.val()) >> self.n.val();
        }
    }
});

kernel!(ProductInABranch, Doubled<16>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("product_in_a_branch");
        self.result.next = self.h.val() * self.h.val();
        if self.p.val() {
            self.result.next = self.h.val() * self.k.val();
        }
    }
});

kernel!(NestedBranches, Word<9>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("nested_branches");
        if self.p.val() {
            if self.a.val() + self.one.val() == self.b.val() {
                self.result.next = bit_cast::<9, 8>(self.a.val() + self.b.val());
            } else {
                self.result.next = bit_cast::<9, 8>(self.a.val());
            }
        } else {
            self.result.next = bit_cast::<9, 8>(self.b.val() - self.one.val());
        }
    }
});

/// All kernels of this file, simulated on the vectors.
pub(super) fn all(vectors: &[[u64; 11]]) -> Vec<Tested> {
    vec![
        SumOfDifferences::tested(vectors),
        InverseOfSum::tested(vectors),
        ShiftedSum::tested(vectors),
        SumOfShifted::tested(vectors),
        ShiftedByDifference::tested(vectors),
        MaskedSum::tested(vectors),
        ExtendedDifference::tested(vectors),
        NarrowedSum::tested(vectors),
        SliceOfSum::tested(vectors),
        NegatedSum::tested(vectors),
        ExtendedSignedSum::tested(vectors),
        NegationIsBelow::tested(vectors),
        ProductIsBelow::tested(vectors),
        MaskedProduct::tested(vectors),
        ReadAsSigned::tested(vectors),
        ReadAsUnsigned::tested(vectors),
        SignedReadExtended::tested(vectors),
        ChainOfTests::tested(vectors),
        WideSumIsBelow::tested(vectors),
        ElseIf::tested(vectors),
        ProductInABranch::tested(vectors),
        NestedBranches::tested(vectors),
    ]
}
