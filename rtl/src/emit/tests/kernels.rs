//! Kernels one operation long and longer: what rust-hdl's simulation computes, the emitted Verilog computes in Icarus Verilog.
//!
//! The first eight are those that rust-hdl's own printer turns into Verilog with other results: sums that keep their carry in a cast or a
//! comparison, operators whose precedence differs, narrowing that is lost.

use super::super::emit_block;
use crate::kernel::*;
use crate::word::bits_signed;
use rust_hdl::core::prelude::{Block, simulate};
use std::fmt::Write;
use std::process::Command;

const VECTORS: usize = 4000;

/// Words of a vector: a, b, n, s, t, w, v, u, h, k, p.
const WIDTHS: [usize; 11] = [8, 8, 3, 8, 8, 40, 40, 40, 16, 16, 1];
const NAMES: [&str; 11] = ["a", "b", "n", "s", "t", "w", "v", "u", "h", "k", "p"];

/// A kernel as a test meets it.
struct Tested {
    module: String,
    width: usize,
    text: String,
    results: Vec<u64>,
}

macro_rules! kernel {
    ($name:ident, $out:ty, { $($update:tt)* }) => {
        struct $name {
            a: Signal<In, Word<8>>,
            b: Signal<In, Word<8>>,
            n: Signal<In, Word<3>>,
            s: Signal<In, Int<8>>,
            t: Signal<In, Int<8>>,
            w: Signal<In, Word<40>>,
            v: Signal<In, Int<40>>,
            u: Signal<In, Int<40>>,
            h: Signal<In, Int<16>>,
            k: Signal<In, Int<16>>,
            p: Signal<In, Bit>,
            result: Signal<Out, $out>,
            one: Constant<Word<8>>,
            limit: Constant<Word<8>>,
            places: Constant<Word<6>>,
            place: Constant<Word<8>>,
            zero: Constant<Int<8>>,
            _asleep: bool,
        }

        block! {
            [] $name []
            inputs { a, b, n, s, t, w, v, u, h, k, p }
            parts { result, one, limit, places, place, zero }
            data { }
        }

        impl Logic for $name {
            $($update)*
        }

        impl $name {
            fn new() -> Self {
                Self {
                    a: Signal::default(),
                    b: Signal::default(),
                    n: Signal::default(),
                    s: Signal::default(),
                    t: Signal::default(),
                    w: Signal::default(),
                    v: Signal::default(),
                    u: Signal::default(),
                    h: Signal::default(),
                    k: Signal::default(),
                    p: Signal::default(),
                    result: Signal::default(),
                    one: constant(1),
                    limit: constant(100),
                    places: constant(5),
                    place: constant(13),
                    zero: signed_constant(0),
                    _asleep: false,
                }
            }

            fn tested(vectors: &[[u64; 11]]) -> Tested {
                let modules = emit_block(Self::new()).expect(stringify!($name));
                assert_eq!(modules.len(), 1, "a kernel is one module");
                let (module, text) = modules.into_iter().next().expect("one module");
                let mut block = Self::new();
                block.connect_all();
                let run = |vector: &[u64; 11]| {
                    let [a, b, n, s, t, w, v, u, h, k, p] = *vector;
                    block.a.next = Word::new(a);
                    block.b.next = Word::new(b);
                    block.n.next = Word::new(n);
                    block.s.next = Int::new(s as i64);
                    block.t.next = Int::new(t as i64);
                    block.w.next = Word::new(w);
                    block.v.next = Int::new(v as i64);
                    block.u.next = Int::new(u as i64);
                    block.h.next = Int::new(h as i64);
                    block.k.next = Int::new(k as i64);
                    block.p.next = p == 1;
                    assert!(simulate(&mut block, 20), "{} oscillates", stringify!($name));
                    block.result.val().word()
                };
                Tested {
                    module,
                    width: <$out as Synth>::BITS,
                    text,
                    results: vectors.iter().map(run).collect(),
                }
            }
        }
    };
}

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

kernel!(Product, Int<32>, {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("product");
        self.result.next = self.h.val() * self.k.val();
    }
});

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

kernel!(MaskedProduct, Int<32>, {
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

kernel!(ProductInABranch, Int<32>, {
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

fn vectors() -> Vec<[u64; 11]> {
    // A multiply-with-carry generator: the same vectors in every run.
    let mut state = 0x1234_5678_9abc_def1_u64;
    let mut next = || {
        state = (state & 0xffff_ffff) * 4_294_957_665 + (state >> 32);
        state & 0xffff_ffff
    };
    let mut word = |width: usize| {
        let ones = u64::MAX >> (64 - width);
        // One word in four is an edge: zero, one, all ones, the sign bit, the greatest positive.
        let edges = [0, 1, ones, 1 << (width - 1), ones >> 1];
        let value = match next() % 20 {
            place @ 0..5 => edges[place as usize],
            _ => next() << 32 | next(),
        };
        value & ones
    };
    (0..VECTORS).map(|_| WIDTHS.map(&mut word)).collect()
}

/// A bench that reads the vectors and prints the results of all kernels.
fn bench(kernels: &[Tested], stimulus: &str) -> String {
    let total: usize = WIDTHS.iter().sum();
    let mut text = format!(
        "module bench;\n  reg [{}:0] vectors [0:{}];\n  reg [{}:0] now;\n",
        total - 1,
        VECTORS - 1,
        total - 1
    );
    let mut high = total;
    let mut inputs = Vec::new();
    for (name, width) in NAMES.iter().zip(WIDTHS) {
        inputs.push(format!(".{name}(now[{}:{}])", high - 1, high - width));
        high -= width;
    }
    for (place, kernel) in kernels.iter().enumerate() {
        let _ = writeln!(
            text,
            "  wire [{}:0] out_{place};\n  {} unit_{place} ({}, .result(out_{place}));",
            kernel.width - 1,
            kernel.module,
            inputs.join(", ")
        );
    }
    let _ = writeln!(
        text,
        "  integer i;\n  initial begin\n    $readmemh(\"{stimulus}\", vectors);\n    for (i = 0; i < {VECTORS}; i = i + 1) begin\n      now = vectors[i]; #1;"
    );
    for place in 0..kernels.len() {
        let _ = writeln!(text, "      $display(\"%h\", out_{place});");
    }
    text + "    end\n  end\nendmodule\n"
}

/// The vectors as hexadecimal words, the first input in the highest bits.
fn stimulus(vectors: &[[u64; 11]]) -> String {
    let mut text = String::new();
    for vector in vectors {
        let words = vector.iter().zip(WIDTHS);
        let (high, low) = words.fold((0_u128, 0_u128), |(high, low), (word, width)| {
            (
                (high << width) | (low >> (128 - width)),
                (low << width) | u128::from(*word),
            )
        });
        let _ = writeln!(text, "{high:x}{low:032x}");
    }
    text
}

fn icarus(kernels: &[Tested], vectors: &[[u64; 11]]) -> Vec<u64> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = |name: &str| {
        folder
            .path()
            .join(name)
            .to_str()
            .expect("a plain path")
            .to_owned()
    };
    std::fs::write(path("stimulus.hex"), stimulus(vectors)).expect("a written file");
    let mut text: String = kernels.iter().map(|kernel| kernel.text.as_str()).collect();
    text += &bench(kernels, &path("stimulus.hex"));
    std::fs::write(path("bench.v"), text).expect("a written file");
    let run = |tool: &str, arguments: &[&str]| {
        let output = Command::new(tool)
            .args(arguments)
            .output()
            .unwrap_or_else(|error| {
                panic!("{tool} cannot be run ({error}); install the package `iverilog`")
            });
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success() && said.is_empty(), "{tool}: {said}");
        String::from_utf8(output.stdout).expect("plain text")
    };
    run(
        "iverilog",
        &[
            "-g2005",
            "-Wall",
            "-Wno-timescale",
            "-o",
            &path("bench.vvp"),
            &path("bench.v"),
        ],
    );
    run("vvp", &["-n", &path("bench.vvp")])
        .lines()
        .map(|line| u64::from_str_radix(line, 16).unwrap_or_else(|_| panic!("no value: {line}")))
        .collect()
}

#[test]
fn every_kernel_computes_the_same_in_simulation_and_in_verilog() {
    let vectors = vectors();
    let kernels = [
        WideSum::tested(&vectors),
        SumIsEqual::tested(&vectors),
        SumIsBelow::tested(&vectors),
        InverseIsEqual::tested(&vectors),
        MaskIsEqual::tested(&vectors),
        NarrowedIsBelow::tested(&vectors),
        DifferenceIsNegative::tested(&vectors),
        LessOneIsAbove::tested(&vectors),
        Sum::tested(&vectors),
        Difference::tested(&vectors),
        BitwiseAnd::tested(&vectors),
        BitwiseOr::tested(&vectors),
        ExclusiveOr::tested(&vectors),
        Inverse::tested(&vectors),
        ShiftedLeft::tested(&vectors),
        ShiftedRight::tested(&vectors),
        ShiftedBeyond::tested(&vectors),
        ShiftedByConstant::tested(&vectors),
        Equal::tested(&vectors),
        Unequal::tested(&vectors),
        Below::tested(&vectors),
        NotAbove::tested(&vectors),
        SignedBelow::tested(&vectors),
        SignedNotBelow::tested(&vectors),
        SignedSum::tested(&vectors),
        SignedDifference::tested(&vectors),
        Negated::tested(&vectors),
        Extended::tested(&vectors),
        ZeroExtended::tested(&vectors),
        Narrowed::tested(&vectors),
        Slice::tested(&vectors),
        OneBit::tested(&vectors),
        Product::tested(&vectors),
        SumOfDifferences::tested(&vectors),
        InverseOfSum::tested(&vectors),
        ShiftedSum::tested(&vectors),
        SumOfShifted::tested(&vectors),
        ShiftedByDifference::tested(&vectors),
        MaskedSum::tested(&vectors),
        ExtendedDifference::tested(&vectors),
        NarrowedSum::tested(&vectors),
        SliceOfSum::tested(&vectors),
        NegatedSum::tested(&vectors),
        ExtendedSignedSum::tested(&vectors),
        NegationIsBelow::tested(&vectors),
        ProductIsBelow::tested(&vectors),
        MaskedProduct::tested(&vectors),
        ReadAsSigned::tested(&vectors),
        ReadAsUnsigned::tested(&vectors),
        SignedReadExtended::tested(&vectors),
        ChainOfTests::tested(&vectors),
        WideSumIsBelow::tested(&vectors),
        ElseIf::tested(&vectors),
        ProductInABranch::tested(&vectors),
        NestedBranches::tested(&vectors),
    ];
    let found = icarus(&kernels, &vectors);
    assert_eq!(found.len(), VECTORS * kernels.len());
    let mut wrong = Vec::new();
    for (place, kernel) in kernels.iter().enumerate() {
        let differs =
            |index: &usize| found[index * kernels.len() + place] != kernel.results[*index];
        let count = (0..VECTORS).filter(differs).count();
        if count > 0 {
            wrong.push(format!(
                "{}: {count} of {VECTORS} vectors differ\n{}",
                kernel.module, kernel.text
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
