//! Cellular square root network.

use crate::kernel::*;

/// One row of the network: one digit of the root.
///
/// `trial = 4 remainder + next pair - (4 root + 1)`. One subtraction serves both as the comparison, by its sign, and as the
/// new remainder.
///
/// The remainder never exceeds twice the root, so row k (from 0) takes one of `k + 1` bits, leaves one of `k + 2`, and finds its sign
/// at bit `k + 2`. `live` carries these widths from row to row as ones at the live bits: with it a constant at the first row,
/// synthesis trims every row to its cells, and all rows are still one module.
pub struct SquareRootRow<const F: usize, const K: usize, const K1: usize, const K2: usize> {
    /// Pairs not used yet, the next one at the top.
    pub pairs: Signal<In, Word<F>>,
    /// Digits found so far.
    pub root: Signal<In, Word<K>>,
    /// Remainder so far.
    pub remainder: Signal<In, Word<K1>>,
    /// Ones at the bits that the remainder can have.
    pub live: Signal<In, Word<K2>>,
    /// Pairs left.
    pub next_pairs: Signal<Out, Word<F>>,
    /// Root with one more digit.
    pub next_root: Signal<Out, Word<K>>,
    /// Remainder after this digit.
    pub next_remainder: Signal<Out, Word<K1>>,
    /// Ones at the bits that the next remainder can have.
    pub next_live: Signal<Out, Word<K2>>,
    wide_remainder: Signal<Local, Word<K2>>,
    shifted_remainder: Signal<Local, Word<K2>>,
    top_pair: Signal<Local, Word<2>>,
    pair: Signal<Local, Word<K2>>,
    dividend: Signal<Local, Word<K2>>,
    wide_root: Signal<Local, Word<K2>>,
    shifted_root: Signal<Local, Word<K2>>,
    divisor: Signal<Local, Word<K2>>,
    trial: Signal<Local, Word<K2>>,
    shifted_live: Signal<Local, Word<K2>>,
    grown_live: Signal<Local, Word<K2>>,
    sign: Signal<Local, Word<K2>>,
    trial_sign: Signal<Local, Word<K2>>,
    negative: Signal<Local, Bit>,
    kept: Signal<Local, Word<K2>>,
    live_kept: Signal<Local, Word<K2>>,
    doubled_root: Signal<Local, Word<K>>,
    top: Constant<Word<8>>,
    none: Constant<Word<K2>>,
    by_one: Constant<Word<2>>,
    by_two: Constant<Word<2>>,
    digit: Constant<Word<K>>,
    wide_digit: Constant<Word<K2>>,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const K2: usize] SquareRootRow [F, K, K1, K2]
    inputs { pairs, root, remainder, live }
    parts { next_pairs, next_root, next_remainder, next_live, wide_remainder, shifted_remainder,
        top_pair, pair, dividend, wide_root, shifted_root, divisor, trial, shifted_live,
        grown_live, sign, trial_sign, negative, kept, live_kept, doubled_root, top, none, by_one,
        by_two, digit, wide_digit }
    data { }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> SquareRootRow<F, K, K1, K2> {
    pub(super) fn new() -> Self {
        Self {
            pairs: Signal::default(),
            root: Signal::default(),
            remainder: Signal::default(),
            live: Signal::default(),
            next_pairs: Signal::default(),
            next_root: Signal::default(),
            next_remainder: Signal::default(),
            next_live: Signal::default(),
            wide_remainder: Signal::default(),
            shifted_remainder: Signal::default(),
            top_pair: Signal::default(),
            pair: Signal::default(),
            dividend: Signal::default(),
            wide_root: Signal::default(),
            shifted_root: Signal::default(),
            divisor: Signal::default(),
            trial: Signal::default(),
            shifted_live: Signal::default(),
            grown_live: Signal::default(),
            sign: Signal::default(),
            trial_sign: Signal::default(),
            negative: Signal::default(),
            kept: Signal::default(),
            live_kept: Signal::default(),
            doubled_root: Signal::default(),
            top: constant(F as u64 - 2),
            none: constant(0),
            by_one: constant(1),
            by_two: constant(2),
            digit: constant(1),
            wide_digit: constant(1),
            _asleep: false,
        }
    }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> Logic
    for SquareRootRow<F, K, K1, K2>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("square_root_row");
        self.wide_remainder.next = bit_cast::<K2, K1>(self.remainder.val());
        self.shifted_remainder.next = self.wide_remainder.val() << self.by_two.val();
        self.top_pair.next = self.pairs.val().get_bits::<2>(self.top.val().index());
        self.pair.next = bit_cast::<K2, 2>(self.top_pair.val());
        self.dividend.next = self.shifted_remainder.val() | self.pair.val();
        self.wide_root.next = bit_cast::<K2, K>(self.root.val());
        self.shifted_root.next = self.wide_root.val() << self.by_two.val();
        self.divisor.next = self.shifted_root.val() | self.wide_digit.val();
        self.trial.next = self.dividend.val() - self.divisor.val();
        self.shifted_live.next = self.live.val() << self.by_one.val();
        self.grown_live.next = self.shifted_live.val() | self.wide_digit.val();
        self.next_live.next = self.grown_live.val();
        self.sign.next = self.grown_live.val() + self.wide_digit.val();
        self.trial_sign.next = self.trial.val() & self.sign.val();
        self.negative.next = self.trial_sign.val() != self.none.val();
        self.doubled_root.next = self.root.val() << self.by_one.val();
        self.next_pairs.next = self.pairs.val() << self.by_two.val();
        if self.negative.val() {
            self.next_root.next = self.doubled_root.val();
            self.kept.next = self.dividend.val();
        } else {
            self.next_root.next = self.doubled_root.val() | self.digit.val();
            self.kept.next = self.trial.val();
        }
        self.live_kept.next = self.kept.val() & self.grown_live.val();
        self.next_remainder.next = bit_cast::<K1, K2>(self.live_kept.val());
    }
}

/// One register stage: some rows, then registers.
pub struct SquareRootStage<const F: usize, const K: usize, const K1: usize, const K2: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Pairs not used yet.
    pub pairs: Signal<In, Word<F>>,
    /// Digits found so far.
    pub root: Signal<In, Word<K>>,
    /// Remainder so far.
    pub remainder: Signal<In, Word<K1>>,
    /// Ones at the bits that the remainder can have.
    pub live: Signal<In, Word<K2>>,
    /// Pairs left, registered.
    pub next_pairs: Signal<Out, Word<F>>,
    /// Root with the digits of this stage, registered.
    pub next_root: Signal<Out, Word<K>>,
    /// Remainder after this stage, registered.
    pub next_remainder: Signal<Out, Word<K1>>,
    /// Ones at the bits that the remainder after this stage can have.
    pub next_live: Signal<Out, Word<K2>>,
    rows: Vec<SquareRootRow<F, K, K1, K2>>,
    kept_pairs: DFF<Word<F>>,
    kept_root: DFF<Word<K>>,
    kept_remainder: DFF<Word<K1>>,
    _count: usize,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const K2: usize] SquareRootStage [F, K, K1, K2]
    inputs { clock, pairs, root, remainder, live }
    parts { next_pairs, next_root, next_remainder, next_live, rows, kept_pairs, kept_root, kept_remainder }
    data { _count }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize>
    SquareRootStage<F, K, K1, K2>
{
    pub(super) fn new(rows: usize) -> Self {
        Self {
            clock: Signal::default(),
            pairs: Signal::default(),
            root: Signal::default(),
            remainder: Signal::default(),
            live: Signal::default(),
            next_pairs: Signal::default(),
            next_root: Signal::default(),
            next_remainder: Signal::default(),
            next_live: Signal::default(),
            rows: repeat(rows, SquareRootRow::new),
            kept_pairs: DFF::default(),
            kept_root: DFF::default(),
            kept_remainder: DFF::default(),
            _count: rows,
            _asleep: false,
        }
    }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> Logic
    for SquareRootStage<F, K, K1, K2>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("square_root_stage");
        clock!(self, clock, kept_pairs, kept_root, kept_remainder);
        self.rows[0].pairs.next = self.pairs.val();
        self.rows[0].root.next = self.root.val();
        self.rows[0].remainder.next = self.remainder.val();
        self.rows[0].live.next = self.live.val();
        for i in 1..self._count {
            self.rows[i].pairs.next = self.rows[i - 1].next_pairs.val();
            self.rows[i].root.next = self.rows[i - 1].next_root.val();
            self.rows[i].remainder.next = self.rows[i - 1].next_remainder.val();
            self.rows[i].live.next = self.rows[i - 1].next_live.val();
        }
        // The last assignment is the one that holds: rust-hdl has no name for the last element.
        for i in 0..self._count {
            self.kept_pairs.d.next = self.rows[i].next_pairs.val();
            self.kept_root.d.next = self.rows[i].next_root.val();
            self.kept_remainder.d.next = self.rows[i].next_remainder.val();
            self.next_live.next = self.rows[i].next_live.val();
        }
        self.next_pairs.next = self.kept_pairs.q.val();
        self.next_root.next = self.kept_root.q.val();
        self.next_remainder.next = self.kept_remainder.q.val();
    }
}

/// Gives `root = floor(sqrt(radicand))` and `remainder = radicand - root^2`, one result per clock.
///
/// `F = 2 K`, `K1 = K + 1`, `K2 = K + 2`. The `K` rows of the digit recurrence, most significant digit first, are cut into
/// register stages of `rows_per_stage` rows; the last stage may hold fewer.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `radicand` | in | `F` bits, unsigned |
/// | `root` | out | `K` bits, unsigned |
/// | `remainder` | out | `K + 1` bits, unsigned |
///
/// Free running; latency `ceil(K / rows_per_stage)`. Section 2.3.3.
pub struct SquareRoot<const F: usize, const K: usize, const K1: usize, const K2: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The number whose root is taken.
    pub radicand: Signal<In, Word<F>>,
    /// Root, rounded down.
    pub root: Signal<Out, Word<K>>,
    /// Radicand less the square of the root.
    pub remainder: Signal<Out, Word<K1>>,
    stages: Vec<SquareRootStage<F, K, K1, K2>>,
    no_digits: Constant<Word<K>>,
    no_remainder: Constant<Word<K1>>,
    first_live: Constant<Word<K2>>,
    _count: usize,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const K2: usize] SquareRoot [F, K, K1, K2]
    inputs { clock, radicand }
    parts { root, remainder, stages, no_digits, no_remainder, first_live }
    data { _count }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> SquareRoot<F, K, K1, K2> {
    /// A network of all `K` rows, `rows_per_stage` of them between registers.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or `rows_per_stage` is not in `1..=K`.
    pub fn new(rows_per_stage: usize) -> Self {
        Self::of_digits(K, rows_per_stage)
    }

    /// The first `kept` rows: their digits are the low bits of `root`, their remainder is `remainder`.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other, or a count is not in `1..=K`.
    pub fn of_digits(kept: usize, rows_per_stage: usize) -> Self {
        assert!(
            F == 2 * K && K1 == K + 1 && K2 == K + 2,
            "widths of the root network"
        );
        assert!(
            (1..=K).contains(&rows_per_stage),
            "rows per stage are 1 to {K}"
        );
        assert!((1..=K).contains(&kept), "kept digits are 1 to {K}");
        let count = kept.div_ceil(rows_per_stage);
        let rows = |stage: usize| rows_per_stage.min(kept - stage * rows_per_stage);
        Self {
            clock: Signal::default(),
            radicand: Signal::default(),
            root: Signal::default(),
            remainder: Signal::default(),
            stages: (0..count)
                .map(|stage| SquareRootStage::new(rows(stage)))
                .collect(),
            no_digits: constant(0),
            no_remainder: constant(0),
            first_live: constant(1),
            _count: count,
            _asleep: false,
        }
    }

    /// Clocks from the radicand to the root.
    pub const fn latency(rows_per_stage: usize) -> usize {
        K.div_ceil(rows_per_stage)
    }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> Logic
    for SquareRoot<F, K, K1, K2>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("square_root");
        self.stages[0].clock.next = self.clock.val();
        self.stages[0].pairs.next = self.radicand.val();
        self.stages[0].root.next = self.no_digits.val();
        self.stages[0].remainder.next = self.no_remainder.val();
        self.stages[0].live.next = self.first_live.val();
        for i in 1..self._count {
            self.stages[i].clock.next = self.clock.val();
            self.stages[i].pairs.next = self.stages[i - 1].next_pairs.val();
            self.stages[i].root.next = self.stages[i - 1].next_root.val();
            self.stages[i].remainder.next = self.stages[i - 1].next_remainder.val();
            self.stages[i].live.next = self.stages[i - 1].next_live.val();
        }
        for i in 0..self._count {
            self.root.next = self.stages[i].next_root.val();
            self.remainder.next = self.stages[i].next_remainder.val();
        }
    }
}

clocked!(SquareRoot<const F: usize, const K: usize, const K1: usize, const K2: usize>);
