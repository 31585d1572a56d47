//! Non-restoring square root network.

use crate::kernel::*;

/// One row of the network: one digit of the root.
///
/// `4 remainder + next pair`, less `4 root + 1` where the remainder is not negative, plus `4 root + 3` where it is. Because
/// `-(4 root + 1) = ~(4 root)` in two's complement, both are one addition whose addend is `4 root` or its complement, the low two bits
/// set: a row of controlled add/subtract cells.
///
/// Row k (from 0) takes a remainder of `k + 2` bits with its sign and leaves one of `k + 3`. The bits above are zeros, not copies of the
/// sign: `live` carries ones at the live bits from row to row, so that synthesis trims every row to its cells.
pub struct NonRestoringRow<const F: usize, const K: usize, const K1: usize, const K2: usize> {
    /// Pairs not used yet, the next one at the top.
    pub pairs: Signal<In, Word<F>>,
    /// Digits found so far.
    pub root: Signal<In, Word<K>>,
    /// Remainder so far, two's complement in the live bits.
    pub remainder: Signal<In, Word<K2>>,
    /// Ones at the live bits of the remainder.
    pub live: Signal<In, Word<K2>>,
    /// Pairs left.
    pub next_pairs: Signal<Out, Word<F>>,
    /// Root with one more digit.
    pub next_root: Signal<Out, Word<K>>,
    /// Remainder after this digit, likewise.
    pub next_remainder: Signal<Out, Word<K2>>,
    /// Ones at the live bits of the next remainder.
    pub next_live: Signal<Out, Word<K2>>,
    shifted_remainder: Signal<Local, Word<K2>>,
    top_pair: Signal<Local, Word<2>>,
    pair: Signal<Local, Word<K2>>,
    dividend: Signal<Local, Word<K2>>,
    wide_root: Signal<Local, Word<K2>>,
    shifted_root: Signal<Local, Word<K2>>,
    addend: Signal<Local, Word<K2>>,
    sum: Signal<Local, Word<K2>>,
    shifted_live: Signal<Local, Word<K2>>,
    grown_live: Signal<Local, Word<K2>>,
    halved_live: Signal<Local, Word<K2>>,
    sign: Signal<Local, Word<K2>>,
    remainder_sign: Signal<Local, Word<K2>>,
    next_sign: Signal<Local, Word<K2>>,
    sum_sign: Signal<Local, Word<K2>>,
    doubled_root: Signal<Local, Word<K>>,
    top: Constant<Word<8>>,
    none: Constant<Word<K2>>,
    by_one: Constant<Word<2>>,
    by_two: Constant<Word<2>>,
    digit: Constant<Word<K>>,
    wide_digit: Constant<Word<K2>>,
    low_digits: Constant<Word<K2>>,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const K2: usize] NonRestoringRow [F, K, K1, K2]
    inputs { pairs, root, remainder, live }
    parts { next_pairs, next_root, next_remainder, next_live, shifted_remainder, top_pair, pair,
        dividend, wide_root, shifted_root, addend, sum, shifted_live, grown_live, halved_live,
        sign, remainder_sign, next_sign, sum_sign, doubled_root, top, none, by_one, by_two, digit,
        wide_digit, low_digits }
    data { }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize>
    NonRestoringRow<F, K, K1, K2>
{
    fn new() -> Self {
        Self {
            pairs: Signal::default(),
            root: Signal::default(),
            remainder: Signal::default(),
            live: Signal::default(),
            next_pairs: Signal::default(),
            next_root: Signal::default(),
            next_remainder: Signal::default(),
            next_live: Signal::default(),
            shifted_remainder: Signal::default(),
            top_pair: Signal::default(),
            pair: Signal::default(),
            dividend: Signal::default(),
            wide_root: Signal::default(),
            shifted_root: Signal::default(),
            addend: Signal::default(),
            sum: Signal::default(),
            shifted_live: Signal::default(),
            grown_live: Signal::default(),
            halved_live: Signal::default(),
            sign: Signal::default(),
            remainder_sign: Signal::default(),
            next_sign: Signal::default(),
            sum_sign: Signal::default(),
            doubled_root: Signal::default(),
            top: constant(F as u64 - 2),
            none: constant(0),
            by_one: constant(1),
            by_two: constant(2),
            digit: constant(1),
            wide_digit: constant(1),
            low_digits: constant(3),
            _asleep: false,
        }
    }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> Logic
    for NonRestoringRow<F, K, K1, K2>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("non_restoring_row");
        self.shifted_remainder.next = self.remainder.val() << self.by_two.val();
        self.top_pair.next = self.pairs.val().get_bits::<2>(self.top.val().index());
        self.pair.next = bit_cast::<K2, 2>(self.top_pair.val());
        self.dividend.next = self.shifted_remainder.val() | self.pair.val();
        self.wide_root.next = bit_cast::<K2, K>(self.root.val());
        self.shifted_root.next = self.wide_root.val() << self.by_two.val();
        self.halved_live.next = self.live.val() >> self.by_one.val();
        self.sign.next = self.live.val() ^ self.halved_live.val();
        self.remainder_sign.next = self.remainder.val() & self.sign.val();
        if self.remainder_sign.val() != self.none.val() {
            self.addend.next = self.shifted_root.val() | self.low_digits.val();
        } else {
            self.addend.next = !self.shifted_root.val() | self.low_digits.val();
        }
        self.sum.next = self.dividend.val() + self.addend.val();
        self.shifted_live.next = self.live.val() << self.by_one.val();
        self.grown_live.next = self.shifted_live.val() | self.wide_digit.val();
        self.next_live.next = self.grown_live.val();
        self.next_sign.next = self.grown_live.val() ^ self.live.val();
        self.sum_sign.next = self.sum.val() & self.next_sign.val();
        self.doubled_root.next = self.root.val() << self.by_one.val();
        if self.sum_sign.val() != self.none.val() {
            self.next_root.next = self.doubled_root.val();
        } else {
            self.next_root.next = self.doubled_root.val() | self.digit.val();
        }
        self.next_pairs.next = self.pairs.val() << self.by_two.val();
        self.next_remainder.next = self.sum.val() & self.grown_live.val();
    }
}

/// One register stage: some rows, then registers.
pub struct NonRestoringStage<const F: usize, const K: usize, const K1: usize, const K2: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Pairs not used yet.
    pub pairs: Signal<In, Word<F>>,
    /// Digits found so far.
    pub root: Signal<In, Word<K>>,
    /// Remainder so far.
    pub remainder: Signal<In, Word<K2>>,
    /// Ones at the live bits of the remainder.
    pub live: Signal<In, Word<K2>>,
    /// Pairs left, registered.
    pub next_pairs: Signal<Out, Word<F>>,
    /// Root with the digits of this stage, registered.
    pub next_root: Signal<Out, Word<K>>,
    /// Remainder after this stage, registered.
    pub next_remainder: Signal<Out, Word<K2>>,
    /// Ones at the live bits of the remainder after this stage.
    pub next_live: Signal<Out, Word<K2>>,
    rows: Vec<NonRestoringRow<F, K, K1, K2>>,
    kept_pairs: DFF<Word<F>>,
    kept_root: DFF<Word<K>>,
    kept_remainder: DFF<Word<K2>>,
    _count: usize,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const K2: usize] NonRestoringStage [F, K, K1, K2]
    inputs { clock, pairs, root, remainder, live }
    parts { next_pairs, next_root, next_remainder, next_live, rows, kept_pairs, kept_root,
        kept_remainder }
    data { _count }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize>
    NonRestoringStage<F, K, K1, K2>
{
    fn new(rows: usize) -> Self {
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
            rows: repeat(rows, NonRestoringRow::new),
            kept_pairs: DFF::default(),
            kept_root: DFF::default(),
            kept_remainder: DFF::default(),
            _count: rows,
            _asleep: false,
        }
    }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> Logic
    for NonRestoringStage<F, K, K1, K2>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("non_restoring_stage");
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
/// `F = 2 K`, `K1 = K + 1`, `K2 = K + 2`. The `K` rows are cut into register stages of `rows_per_stage` rows; the last stage may hold
/// fewer. No row chooses between two remainders, so a row is an addition alone; in return a negative last remainder gets
/// `2 root + 1` added behind the last register.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `radicand` | in | `F` bits, unsigned |
/// | `root` | out | `K` bits, unsigned |
/// | `remainder` | out | `K + 1` bits, unsigned |
///
/// Free running; latency `ceil(K / rows_per_stage)`. Section 2.3.3.
pub struct SquareRootNonRestoring<const F: usize, const K: usize, const K1: usize, const K2: usize>
{
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The number whose root is taken.
    pub radicand: Signal<In, Word<F>>,
    /// Root, rounded down.
    pub root: Signal<Out, Word<K>>,
    /// Radicand less the square of the root.
    pub remainder: Signal<Out, Word<K1>>,
    last_root: Signal<Local, Word<K>>,
    last_remainder: Signal<Local, Word<K2>>,
    wide_root: Signal<Local, Word<K2>>,
    doubled_root: Signal<Local, Word<K2>>,
    restoring: Signal<Local, Word<K2>>,
    restored: Signal<Local, Word<K2>>,
    stages: Vec<NonRestoringStage<F, K, K1, K2>>,
    no_digits: Constant<Word<K>>,
    no_remainder: Constant<Word<K2>>,
    first_live: Constant<Word<K2>>,
    sign: Constant<Word<8>>,
    by_one: Constant<Word<2>>,
    digit: Constant<Word<K2>>,
    _count: usize,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const K2: usize] SquareRootNonRestoring [F, K, K1, K2]
    inputs { clock, radicand }
    parts { root, remainder, last_root, last_remainder, wide_root, doubled_root, restoring,
        restored, stages, no_digits, no_remainder, first_live, sign, by_one, digit }
    data { _count }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize>
    SquareRootNonRestoring<F, K, K1, K2>
{
    /// A network with `rows_per_stage` rows between registers.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or `rows_per_stage` is not in `1..=K`.
    pub fn new(rows_per_stage: usize) -> Self {
        assert!(
            F == 2 * K && K1 == K + 1 && K2 == K + 2,
            "widths of the root network"
        );
        assert!(
            (1..=K).contains(&rows_per_stage),
            "rows per stage are 1 to {K}"
        );
        let count = Self::latency(rows_per_stage);
        let rows = |stage: usize| rows_per_stage.min(K - stage * rows_per_stage);
        Self {
            clock: Signal::default(),
            radicand: Signal::default(),
            root: Signal::default(),
            remainder: Signal::default(),
            last_root: Signal::default(),
            last_remainder: Signal::default(),
            wide_root: Signal::default(),
            doubled_root: Signal::default(),
            restoring: Signal::default(),
            restored: Signal::default(),
            stages: (0..count)
                .map(|stage| NonRestoringStage::new(rows(stage)))
                .collect(),
            no_digits: constant(0),
            no_remainder: constant(0),
            first_live: constant(3),
            sign: constant(K2 as u64 - 1),
            by_one: constant(1),
            digit: constant(1),
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
    for SquareRootNonRestoring<F, K, K1, K2>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("square_root_non_restoring");
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
            self.last_root.next = self.stages[i].next_root.val();
            self.last_remainder.next = self.stages[i].next_remainder.val();
        }
        self.wide_root.next = bit_cast::<K2, K>(self.last_root.val());
        self.doubled_root.next = self.wide_root.val() << self.by_one.val();
        self.restoring.next = self.doubled_root.val() | self.digit.val();
        self.restored.next = self.last_remainder.val() + self.restoring.val();
        self.root.next = self.last_root.val();
        if self.last_remainder.val().get_bit(self.sign.val().index()) {
            self.remainder.next = bit_cast::<K1, K2>(self.restored.val());
        } else {
            self.remainder.next = bit_cast::<K1, K2>(self.last_remainder.val());
        }
    }
}

clocked!(SquareRootNonRestoring<const F: usize, const K: usize, const K1: usize, const K2: usize>);
