//! Kernels that rust-hdl's own printer turns into Verilog that computes something else, and what becomes of them here.

use super::collect::collect;
use super::merge::modules;
use crate::kernel::*;
use crate::word::bits_signed;

macro_rules! kernel {
    ($name:ident, $out:ty) => {
        struct $name {
            a: Signal<In, Word<8>>,
            b: Signal<In, Word<8>>,
            s: Signal<In, Int<8>>,
            out: Signal<Out, $out>,
            sum: Signal<Local, Word<8>>,
            one: Constant<Word<8>>,
            limit: Constant<Word<8>>,
            zero: Constant<Int<8>>,
            _asleep: bool,
        }

        block! {
            [] $name []
            inputs { a, b, s }
            parts { out, sum, one, limit, zero }
            data { }
        }

        impl $name {
            fn emitted() -> Result<String, String> {
                let block = Self {
                    a: Signal::default(),
                    b: Signal::default(),
                    s: Signal::default(),
                    out: Signal::default(),
                    sum: Signal::default(),
                    one: constant(1),
                    limit: constant(100),
                    zero: signed_constant(0),
                    _asleep: false,
                };
                let scope = collect(block).map_err(|error| error.to_string())?;
                let modules = modules(&scope).map_err(|error| error.to_string())?;
                Ok(modules.into_iter().map(|(_, text)| text).collect())
            }
        }
    };
}

kernel!(WideSum, Word<9>);

impl Logic for WideSum {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("wide_sum");
        self.sum.next = self.a.val();
        self.out.next = bit_cast::<9, 8>(self.a.val() + self.b.val());
    }
}

kernel!(SumIsZero, Bit);

impl Logic for SumIsZero {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sum_is_zero");
        self.sum.next = self.a.val();
        self.out.next = (self.a.val() + self.one.val()) == self.b.val();
    }
}

kernel!(SumIsBelow, Bit);

impl Logic for SumIsBelow {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sum_is_below");
        self.sum.next = self.a.val();
        self.out.next = (self.a.val() + self.b.val()) < self.limit.val();
    }
}

kernel!(InverseIsEqual, Bit);

impl Logic for InverseIsEqual {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("inverse_is_equal");
        self.sum.next = self.a.val();
        self.out.next = !self.a.val() == self.b.val();
    }
}

kernel!(MaskIsEqual, Bit);

impl Logic for MaskIsEqual {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("mask_is_equal");
        self.sum.next = self.a.val();
        self.out.next = self.a.val() & self.b.val() == self.b.val();
    }
}

kernel!(NarrowedIsBelow, Bit);

impl Logic for NarrowedIsBelow {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("narrowed_is_below");
        self.sum.next = self.a.val();
        self.out.next = self.s.val().get_bits::<4>(0) < self.s.val().get_bits::<4>(4);
    }
}

kernel!(DifferenceIsNegative, Bit);

impl Logic for DifferenceIsNegative {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("difference_is_negative");
        self.sum.next = self.a.val();
        self.out.next = (self.s.val() - self.s.val()) < self.zero.val();
    }
}

kernel!(LessOneIsAbove, Bit);

impl Logic for LessOneIsAbove {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("less_one_is_above");
        self.sum.next = self.a.val();
        self.out.next = self.a.val() - self.one.val() > self.b.val();
    }
}

#[test]
fn mismatching_forms_are_refused() {
    for emitted in [
        WideSum::emitted(),
        SumIsZero::emitted(),
        SumIsBelow::emitted(),
        InverseIsEqual::emitted(),
        MaskIsEqual::emitted(),
        NarrowedIsBelow::emitted(),
        DifferenceIsNegative::emitted(),
        LessOneIsAbove::emitted(),
    ] {
        let error = emitted.unwrap_err();
        let expected = ["has operands", "only a name may stand"];
        assert!(
            expected.iter().any(|reason| error.contains(reason)),
            "{error}"
        );
    }
}

kernel!(Latch, Word<8>);

impl Logic for Latch {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("latch");
        self.sum.next = self.a.val();
        if self.a.val() == self.b.val() {
            self.out.next = self.sum.val();
        }
    }
}

kernel!(AssignedLate, Word<8>);

impl Logic for AssignedLate {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("assigned_late");
        self.sum.next = self.a.val();
        self.out.next = self.sum.val() + self.one.val();
        self.sum.next = self.b.val();
    }
}

#[test]
fn latches_and_late_assignments_are_refused() {
    assert!(Latch::emitted().unwrap_err().contains("latch"));
    assert!(
        AssignedLate::emitted()
            .unwrap_err()
            .contains("after it was read")
    );
}

kernel!(Extended, Int<12>);

impl Logic for Extended {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("extended");
        self.sum.next = self.a.val();
        self.out.next = bits_signed::<12, 8>(self.s.val());
    }
}

kernel!(Chosen, Word<8>);

impl Logic for Chosen {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("chosen");
        self.sum.next = self.a.val() + self.b.val();
        if self.s.val() < self.zero.val() {
            self.out.next = !self.sum.val();
        } else if self.a.val() == self.limit.val() {
            self.out.next = self.one.val();
        } else {
            self.out.next = self.sum.val() - self.one.val();
        }
    }
}

#[test]
fn legal_forms_are_printed_with_their_widths() {
    let text = Extended::emitted().unwrap();
    assert!(text.contains("assign out = {{4{s[7]}}, s};"), "{text}");
    let text = Chosen::emitted().unwrap();
    assert!(text.contains("localparam [7:0] limit = 8'd100;"), "{text}");
    assert!(text.contains("assign sum = a + b;"), "{text}");
    assert!(
        text.contains("assign out = (s < zero) ? ~sum :\n        (a == limit) ? one : sum - one;"),
        "{text}"
    );
}
