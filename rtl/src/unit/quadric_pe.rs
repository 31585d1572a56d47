//! The two depths of a quadric.

use super::delay::{FlagDelay, WordDelay};
use super::pe1::Pe1;
use super::pe2::Pe2;
use super::square_root::SquareRoot;
use crate::kernel::*;

/// Gives `f1 - r` and `f1 + r` with `r = floor(sqrt(f2))`: a PE2, the root network behind it, and a PE1 started late enough
/// to meet the root.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `f1_a`, `f1_b`, `f1_c` | in | `S = W + 2` bits |
/// | `f2_a2`, `f2_b2`, `f2_c`, `f2_i0`, `f2_p0`, `f2_f` | in | `F = 2W` bits, preconditioned as for the PE2 |
/// | `near_sum`, `far_sum` | out | `S` bits, wrapped |
/// | `root` | out | `W` bits, unsigned |
/// | `is_inside` | out | `f2 >= 0`; the other outputs mean nothing where it is low |
/// | `late_valid`, `late_start`, `late_line` | out | the flags, `ceil(W / rows_per_stage)` clocks later |
///
/// Latency `ceil(W / rows_per_stage) + 2`. Section 2.4.2.
///
/// A machine fitted to a scene may have other words. The root network has `W` rows of a root of `K` bits, whose last `K - W` digits are
/// zero; the PE1 has `E1 = S + g1` bits and the PE2 `E2 = 2 K + g2`, and their guard bits are dropped here.
/// `W1 = W + 1` and `W2 = W + 2` are widths within the network, `F = 2 W` is its radicand. In the formats of the catalogue `K = W`, and there are no guard bits.
pub struct QuadricPe<
    const W: usize,
    const W1: usize,
    const W2: usize,
    const F: usize,
    const S: usize = W2,
    const E1: usize = W2,
    const E2: usize = F,
    const K: usize = W,
> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Linear part: increment along the line.
    pub f1_a: Signal<In, Int<E1>>,
    /// Linear part: increment from line to line.
    pub f1_b: Signal<In, Int<E1>>,
    /// Linear part: value of the first pixel.
    pub f1_c: Signal<In, Int<E1>>,
    /// Quadratic: second difference along the line.
    pub f2_a2: Signal<In, Int<E2>>,
    /// Quadratic: second difference from line to line.
    pub f2_b2: Signal<In, Int<E2>>,
    /// Quadratic: mixed difference.
    pub f2_c: Signal<In, Int<E2>>,
    /// Quadratic: increment from the first line to the second.
    pub f2_i0: Signal<In, Int<E2>>,
    /// Quadratic: increment from the first pixel to the second.
    pub f2_p0: Signal<In, Int<E2>>,
    /// Quadratic: value of the first pixel.
    pub f2_f: Signal<In, Int<E2>>,
    /// Depth of the near root.
    pub near_sum: Signal<Out, Int<S>>,
    /// Depth of the far root.
    pub far_sum: Signal<Out, Int<S>>,
    /// Root, beside the sums.
    pub root: Signal<Out, Word<K>>,
    /// The discriminant is not negative.
    pub is_inside: Signal<Out, Bit>,
    /// `valid`, beside the root network's output less one clock.
    pub late_valid: Signal<Out, Bit>,
    /// `start`, likewise.
    pub late_start: Signal<Out, Bit>,
    /// `line`, likewise.
    pub late_line: Signal<Out, Bit>,
    /// The quadratic, one clock after the flags.
    pub f2: Pe2<E2>,
    /// The flags on their way to the linear part.
    pub flags: FlagDelay,
    /// The linear part, beside the output of the root network.
    pub f1: Pe1<E1>,
    /// The root network.
    pub square_root: SquareRoot<F, W, W1, W2>,
    f2_is_negative: WordDelay<Bit>,
    wide_root: Signal<Local, Word<S>>,
    step: Signal<Local, Int<S>>,
    kept_near_sum: DFF<Int<S>>,
    kept_far_sum: DFF<Int<S>>,
    kept_root: DFF<Word<K>>,
    sign: Constant<Word<8>>,
    guards: Constant<Word<8>>,
    linear_guards: Constant<Word<8>>,
    missing_rows: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const W2: usize, const F: usize, const S: usize, const E1: usize, const E2: usize, const K: usize]
    QuadricPe [W, W1, W2, F, S, E1, E2, K]
    inputs { clock, valid, start, line, f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0, f2_p0, f2_f }
    parts { near_sum, far_sum, root, is_inside, late_valid, late_start, late_line, f2, flags, f1,
        square_root, f2_is_negative, wide_root, step, kept_near_sum, kept_far_sum, kept_root, sign,
        guards, linear_guards, missing_rows }
    data { }
}

impl<
    const W: usize,
    const W1: usize,
    const W2: usize,
    const F: usize,
    const S: usize,
    const E1: usize,
    const E2: usize,
    const K: usize,
> QuadricPe<W, W1, W2, F, S, E1, E2, K>
{
    /// A processor whose root network has `rows_per_stage` rows between registers.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or `rows_per_stage` is not in `1..=W`.
    pub fn new(rows_per_stage: usize) -> Self {
        assert!(
            S <= E1 && F <= E2 && W <= K,
            "guard bits and missing rows are not negative"
        );
        let root = SquareRoot::<F, W, W1, W2>::latency(rows_per_stage);
        Self {
            clock: Signal::default(),
            valid: Signal::default(),
            start: Signal::default(),
            line: Signal::default(),
            f1_a: Signal::default(),
            f1_b: Signal::default(),
            f1_c: Signal::default(),
            f2_a2: Signal::default(),
            f2_b2: Signal::default(),
            f2_c: Signal::default(),
            f2_i0: Signal::default(),
            f2_p0: Signal::default(),
            f2_f: Signal::default(),
            near_sum: Signal::default(),
            far_sum: Signal::default(),
            root: Signal::default(),
            is_inside: Signal::default(),
            late_valid: Signal::default(),
            late_start: Signal::default(),
            late_line: Signal::default(),
            f2: Pe2::default(),
            flags: FlagDelay::new(root),
            f1: Pe1::default(),
            square_root: SquareRoot::new(rows_per_stage),
            f2_is_negative: WordDelay::new(root + 1),
            wide_root: Signal::default(),
            step: Signal::default(),
            kept_near_sum: DFF::default(),
            kept_far_sum: DFF::default(),
            kept_root: DFF::default(),
            sign: constant(E2 as u64 - 1),
            guards: constant((E2 - F) as u64),
            linear_guards: constant((E1 - S) as u64),
            missing_rows: constant((K - W) as u64),
            _asleep: false,
        }
    }

    /// Clocks from the flags to the sums.
    pub const fn latency(rows_per_stage: usize) -> usize {
        Pe2::<F>::latency() + SquareRoot::<F, W, W1, W2>::latency(rows_per_stage) + 1
    }
}

impl<
    const W: usize,
    const W1: usize,
    const W2: usize,
    const F: usize,
    const S: usize,
    const E1: usize,
    const E2: usize,
    const K: usize,
> Logic for QuadricPe<W, W1, W2, F, S, E1, E2, K>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("quadric_pe");
        clock!(
            self,
            clock,
            f2,
            flags,
            f1,
            square_root,
            f2_is_negative,
            kept_near_sum,
            kept_far_sum,
            kept_root
        );
        self.f2.valid.next = self.valid.val();
        self.f2.start.next = self.start.val();
        self.f2.line.next = self.line.val();
        self.f2.a2.next = self.f2_a2.val();
        self.f2.b2.next = self.f2_b2.val();
        self.f2.c.next = self.f2_c.val();
        self.f2.i0.next = self.f2_i0.val();
        self.f2.p0.next = self.f2_p0.val();
        self.f2.f.next = self.f2_f.val();
        self.square_root.radicand.next =
            unsigned_cast(self.f2.value.val().get_bits::<F>(self.guards.val().index()));
        self.f2_is_negative.word.next = self.f2.value.val().get_bit(self.sign.val().index());
        self.flags.valid.next = self.valid.val();
        self.flags.start.next = self.start.val();
        self.flags.line.next = self.line.val();
        self.f1.valid.next = self.flags.late_valid.val();
        self.f1.start.next = self.flags.late_start.val();
        self.f1.line.next = self.flags.late_line.val();
        self.f1.a.next = self.f1_a.val();
        self.f1.b.next = self.f1_b.val();
        self.f1.c.next = self.f1_c.val();
        self.wide_root.next =
            bit_cast::<S, W>(self.square_root.root.val()) << self.missing_rows.val();
        self.step.next = signed_cast(self.wide_root.val());
        self.kept_near_sum.d.next = self
            .f1
            .value
            .val()
            .get_bits::<S>(self.linear_guards.val().index())
            - self.step.val();
        self.kept_far_sum.d.next = self
            .f1
            .value
            .val()
            .get_bits::<S>(self.linear_guards.val().index())
            + self.step.val();
        self.kept_root.d.next =
            bit_cast::<K, W>(self.square_root.root.val()) << self.missing_rows.val();
        self.near_sum.next = self.kept_near_sum.q.val();
        self.far_sum.next = self.kept_far_sum.q.val();
        self.root.next = self.kept_root.q.val();
        self.is_inside.next = !self.f2_is_negative.late.val();
        self.late_valid.next = self.flags.late_valid.val();
        self.late_start.next = self.flags.late_start.val();
        self.late_line.next = self.flags.late_line.val();
    }
}

clocked!(QuadricPe<const W: usize, const W1: usize, const W2: usize, const F: usize, const S: usize, const E1: usize, const E2: usize, const K: usize>);
