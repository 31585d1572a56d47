//! Kernels of one operation.

use super::*;
use crate::word::{bits_signed, signed_bit_cast};

kernel!(Sum, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sum");
        self.result.next = self.a.val() + self.b.val();
    }
});

kernel!(Difference, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("difference");
        self.result.next = self.a.val() - self.b.val();
    }
});

kernel!(BitwiseAnd, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("bitwise_and");
        self.result.next = self.a.val() & self.b.val();
    }
});

kernel!(BitwiseOr, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("bitwise_or");
        self.result.next = self.a.val() | self.b.val();
    }
});

kernel!(ExclusiveOr, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("exclusive_or");
        self.result.next = self.a.val() ^ self.b.val();
    }
});

kernel!(Inverse, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("inverse");
        self.result.next = !self.a.val();
    }
});

kernel!(ShiftedLeft, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("shifted_left");
        self.result.next = self.a.val() << self.n.val();
    }
});

kernel!(ShiftedRight, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("shifted_right");
        self.result.next = self.a.val() >> self.n.val();
    }
});

kernel!(ShiftedBeyond, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("shifted_beyond");
        self.result.next = self.a.val() << self.b.val();
    }
});

kernel!(ShiftedByConstant, Word<40>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("shifted_by_constant");
        self.result.next = self.w.val() << self.places.val();
    }
});

kernel!(Equal, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("equal");
        self.result.next = self.a.val() == self.b.val();
    }
});

kernel!(Unequal, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("unequal");
        self.result.next = self.a.val() != self.b.val();
    }
});

kernel!(Below, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("below");
        self.result.next = self.a.val() < self.b.val();
    }
});

kernel!(NotAbove, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("not_above");
        self.result.next = self.a.val() <= self.b.val();
    }
});

kernel!(SignedBelow, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("signed_below");
        self.result.next = self.s.val() < self.t.val();
    }
});

kernel!(SignedNotBelow, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("signed_not_below");
        self.result.next = self.s.val() >= self.t.val();
    }
});

kernel!(SignedSum, Int<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("signed_sum");
        self.result.next = self.s.val() + self.t.val();
    }
});

kernel!(SignedDifference, Int<40>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("signed_difference");
        self.result.next = self.v.val() - self.u.val();
    }
});

kernel!(Negated, Int<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("negated");
        self.result.next = -self.s.val();
    }
});

kernel!(Extended, Int<12>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("extended");
        self.result.next = bits_signed::<12, 8>(self.s.val());
    }
});

kernel!(Lengthened, Int<12>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("lengthened");
        self.result.next = signed_bit_cast::<12, 8>(self.s.val());
    }
});

kernel!(ZeroExtended, Word<12>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("zero_extended");
        self.result.next = bit_cast::<12, 8>(self.a.val());
    }
});

kernel!(Narrowed, Word<5>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("narrowed");
        self.result.next = bit_cast::<5, 8>(self.a.val());
    }
});

kernel!(Slice, Word<8>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("slice");
        self.result.next = self.w.val().get_bits::<8>(self.place.val().index());
    }
});

kernel!(OneBit, Bit, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("one_bit");
        self.result.next = self.w.val().get_bit(self.place.val().index());
    }
});

kernel!(Product, Doubled<16>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("product");
        self.result.next = self.h.val() * self.k.val();
    }
});

/// All kernels of this file, simulated on the vectors.
pub(super) fn all(vectors: &[[u64; 11]]) -> Vec<Tested> {
    vec![
        Sum::tested(vectors),
        Difference::tested(vectors),
        BitwiseAnd::tested(vectors),
        BitwiseOr::tested(vectors),
        ExclusiveOr::tested(vectors),
        Inverse::tested(vectors),
        ShiftedLeft::tested(vectors),
        ShiftedRight::tested(vectors),
        ShiftedBeyond::tested(vectors),
        ShiftedByConstant::tested(vectors),
        Equal::tested(vectors),
        Unequal::tested(vectors),
        Below::tested(vectors),
        NotAbove::tested(vectors),
        SignedBelow::tested(vectors),
        SignedNotBelow::tested(vectors),
        SignedSum::tested(vectors),
        SignedDifference::tested(vectors),
        Negated::tested(vectors),
        Extended::tested(vectors),
        Lengthened::tested(vectors),
        ZeroExtended::tested(vectors),
        Narrowed::tested(vectors),
        Slice::tested(vectors),
        OneBit::tested(vectors),
        Product::tested(vectors),
    ]
}
