//! Piecewise linear square root with corrections.

use super::root_correction::RootCorrection;
use super::root_length::RootLength;
use crate::kernel::*;

/// Gives an approximate root: two straight lines per pair of octaves, joined, and corrections behind them.
///
/// `F = 2 K`, `K1 = K + 1`. A radicand of `2m` bits gets `X / 2^(m+1) + 2^(m-1)`, one of `2m - 1` bits `X / 2^m + 2^(m-1) - 2^(m-2)`: a shift
/// and an addition. The greatest error is 6.07, 1.65 and 0.47 % after 0, 1 and 2 corrections, besides the floors; the root is
/// monotone in the radicand.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `radicand` | in | `F` bits, unsigned |
/// | `root` | out | `K + 1` bits, unsigned; `2^K` at most |
///
/// Free running; latency `1 + 2 corrections`. Section 2.3.3.
pub struct SquareRootLinear<const F: usize, const K: usize, const K1: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The number whose root is taken.
    pub radicand: Signal<In, Word<F>>,
    /// The approximate root.
    pub root: Signal<Out, Word<K1>>,
    length: Signal<Local, Word<6>>,
    power: Signal<Local, Word<K1>>,
    half: Signal<Local, Word<K1>>,
    quarter: Signal<Local, Word<K1>>,
    rest: Signal<Local, Word<K1>>,
    shifted: Signal<Local, Word<F>>,
    scaled: Signal<Local, Word<K1>>,
    half_scaled: Signal<Local, Word<K1>>,
    top_digit: Signal<Local, Word<K1>>,
    is_even: Signal<Local, Bit>,
    slope: Signal<Local, Word<K1>>,
    offset: Signal<Local, Word<K1>>,
    measured: RootLength<F>,
    kept_radicand: DFF<Word<F>>,
    kept_length: DFF<Word<6>>,
    kept_root: DFF<Word<K1>>,
    corrections: Vec<RootCorrection<F, K1>>,
    one: Constant<Word<K1>>,
    none: Constant<Word<K1>>,
    by_one: Constant<Word<2>>,
    by_two: Constant<Word<2>>,
    _first: usize,
    _count: usize,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize] SquareRootLinear [F, K, K1]
    inputs { clock, radicand }
    parts { root, length, power, half, quarter, rest, shifted, scaled, half_scaled,
        top_digit, is_even, slope, offset, measured, kept_radicand, kept_length,
        kept_root, corrections, one, none, by_one, by_two }
    data { _first, _count }
}

impl<const F: usize, const K: usize, const K1: usize> SquareRootLinear<F, K, K1> {
    /// A unit with a number of corrections behind the estimate, which may be 0.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other.
    pub fn new(corrections: usize) -> Self {
        assert!(F == 2 * K && K1 == K + 1, "widths of the root network");
        Self {
            clock: Signal::default(),
            radicand: Signal::default(),
            root: Signal::default(),
            length: Signal::default(),
            power: Signal::default(),
            half: Signal::default(),
            quarter: Signal::default(),
            rest: Signal::default(),
            shifted: Signal::default(),
            scaled: Signal::default(),
            half_scaled: Signal::default(),
            top_digit: Signal::default(),
            is_even: Signal::default(),
            slope: Signal::default(),
            offset: Signal::default(),
            measured: RootLength::new(),
            kept_radicand: DFF::default(),
            kept_length: DFF::default(),
            kept_root: DFF::default(),
            corrections: repeat(corrections, RootCorrection::new),
            one: constant(1),
            none: constant(0),
            by_one: constant(1),
            by_two: constant(2),
            _first: corrections.min(1),
            _count: corrections,
            _asleep: false,
        }
    }

    /// Clocks from the radicand to the root.
    pub const fn latency(corrections: usize) -> usize {
        1 + 2 * corrections
    }
}

impl<const F: usize, const K: usize, const K1: usize> Logic for SquareRootLinear<F, K, K1> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("square_root_linear");
        clock!(self, clock, kept_radicand, kept_length, kept_root);
        self.measured.radicand.next = self.radicand.val();
        self.length.next = self.measured.length.val();
        self.power.next = self.one.val() << self.length.val();
        self.half.next = self.power.val() >> self.by_one.val();
        self.quarter.next = self.power.val() >> self.by_two.val();
        self.rest.next = self.half.val() - self.quarter.val();
        self.shifted.next = self.radicand.val() >> self.length.val();
        self.scaled.next = bit_cast::<K1, F>(self.shifted.val());
        self.half_scaled.next = self.scaled.val() >> self.by_one.val();
        self.top_digit.next = self.scaled.val() & self.half.val();
        self.is_even.next = self.top_digit.val() != self.none.val();
        if self.is_even.val() {
            self.slope.next = self.half_scaled.val();
            self.offset.next = self.half.val();
        } else {
            self.slope.next = self.scaled.val();
            self.offset.next = self.rest.val();
        }
        self.kept_root.d.next = self.slope.val() + self.offset.val();
        self.kept_radicand.d.next = self.radicand.val();
        self.kept_length.d.next = self.length.val();
        for i in 0..self._first {
            self.corrections[i].radicand.next = self.kept_radicand.q.val();
            self.corrections[i].length.next = self.kept_length.q.val();
            self.corrections[i].root.next = self.kept_root.q.val();
        }
        for i in 1..self._count {
            self.corrections[i].radicand.next = self.corrections[i - 1].late_radicand.val();
            self.corrections[i].length.next = self.corrections[i - 1].late_length.val();
            self.corrections[i].root.next = self.corrections[i - 1].next_root.val();
        }
        self.root.next = self.kept_root.q.val();
        for i in 0..self._count {
            self.corrections[i].clock.next = self.clock.val();
            self.root.next = self.corrections[i].next_root.val();
        }
    }
}

clocked!(SquareRootLinear<const F: usize, const K: usize, const K1: usize>);
