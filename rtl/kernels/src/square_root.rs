//! Cellular square root network: a row, a stage, and the stages behind each other.
//!
//! `K` is the digits of the root. `X = 2K`, `R = K + 1` and `T = K + 2` follow from it: stable Rust computes no width.

use rust_hdl::prelude::*;

/// One digit of the root: `trial = 4 remainder + next pair - (4 root + 1)`, whose sign decides. Section 2.3.3.
///
/// `live` has a one for each bit that the new remainder can have; the sign of the trial is the bit above them.
#[derive(LogicBlock)]
pub struct SquareRootRow<const X: usize, const K: usize, const R: usize, const T: usize> {
    /// Pairs not used yet, the next one at the top.
    pub pairs: Signal<In, Bits<X>>,
    /// Digits found so far.
    pub root: Signal<In, Bits<K>>,
    /// Remainder so far.
    pub remainder: Signal<In, Bits<R>>,
    /// Bits that the new remainder can have.
    pub live: Signal<In, Bits<T>>,
    /// Pairs that are left.
    pub next_pairs: Signal<Out, Bits<X>>,
    /// Digits, with one more.
    pub next_root: Signal<Out, Bits<K>>,
    /// New remainder.
    pub next_remainder: Signal<Out, Bits<R>>,
    dividend: Signal<Local, Bits<T>>,
    divisor: Signal<Local, Bits<T>>,
    trial: Signal<Local, Bits<T>>,
    sign: Signal<Local, Bits<T>>,
    kept: Signal<Local, Bits<T>>,
    place: Constant<Bits<8>>,
}

impl<const X: usize, const K: usize, const R: usize, const T: usize> Default
    for SquareRootRow<X, K, R, T>
{
    fn default() -> Self {
        const { assert!(X == 2 * K && R == K + 1 && T == K + 2, "widths of K digits") };
        Self {
            pairs: Default::default(),
            root: Default::default(),
            remainder: Default::default(),
            live: Default::default(),
            next_pairs: Default::default(),
            next_root: Default::default(),
            next_remainder: Default::default(),
            dividend: Default::default(),
            divisor: Default::default(),
            trial: Default::default(),
            sign: Default::default(),
            kept: Default::default(),
            place: Constant::new((X as u64 - 2).into()),
        }
    }
}

impl<const X: usize, const K: usize, const R: usize, const T: usize> Logic
    for SquareRootRow<X, K, R, T>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.dividend.next = (bit_cast::<T, R>(self.remainder.val()) << 2)
            | bit_cast::<T, X>(self.pairs.val() >> self.place.val());
        self.divisor.next = (bit_cast::<T, K>(self.root.val()) << 2) | 1;
        self.trial.next = self.dividend.val() - self.divisor.val();
        self.sign.next = self.live.val() + 1;
        if (self.trial.val() & self.sign.val()).any() {
            self.kept.next = self.dividend.val() & self.live.val();
            self.next_root.next = self.root.val() << 1;
        } else {
            self.kept.next = self.trial.val() & self.live.val();
            self.next_root.next = (self.root.val() << 1) | 1;
        }
        self.next_pairs.next = self.pairs.val() << 2;
        self.next_remainder.next = self.kept.val().get_bits::<R>(0);
    }
}

/// A row, then registers. Latency 1.
#[derive(LogicBlock, Default)]
pub struct SquareRootStage<const X: usize, const K: usize, const R: usize, const T: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Pairs not used yet, the next one at the top.
    pub pairs: Signal<In, Bits<X>>,
    /// Digits found so far.
    pub root: Signal<In, Bits<K>>,
    /// Remainder so far.
    pub remainder: Signal<In, Bits<R>>,
    /// Bits that the new remainder can have.
    pub live: Signal<In, Bits<T>>,
    /// Pairs that are left.
    pub next_pairs: Signal<Out, Bits<X>>,
    /// Digits, with one more.
    pub next_root: Signal<Out, Bits<K>>,
    /// New remainder.
    pub next_remainder: Signal<Out, Bits<R>>,
    row: SquareRootRow<X, K, R, T>,
    kept_pairs: DFF<Bits<X>>,
    kept_root: DFF<Bits<K>>,
    kept_remainder: DFF<Bits<R>>,
}

impl<const X: usize, const K: usize, const R: usize, const T: usize> Logic
    for SquareRootStage<X, K, R, T>
{
    #[hdl_gen]
    fn update(&mut self) {
        clock!(self, clock, kept_pairs, kept_root, kept_remainder);
        self.row.pairs.next = self.pairs.val();
        self.row.root.next = self.root.val();
        self.row.remainder.next = self.remainder.val();
        self.row.live.next = self.live.val();
        self.kept_pairs.d.next = self.row.next_pairs.val();
        self.kept_root.d.next = self.row.next_root.val();
        self.kept_remainder.d.next = self.row.next_remainder.val();
        self.next_pairs.next = self.kept_pairs.q.val();
        self.next_root.next = self.kept_root.q.val();
        self.next_remainder.next = self.kept_remainder.q.val();
    }
}

/// `floor(sqrt(radicand))` and its remainder, a row for each stage. Latency K.
#[derive(LogicBlock)]
pub struct SquareRoot<const X: usize, const K: usize, const R: usize, const T: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Radicand.
    pub radicand: Signal<In, Bits<X>>,
    /// Largest integer whose square is not greater than the radicand.
    pub root: Signal<Out, Bits<K>>,
    /// Radicand less the square of the root.
    pub remainder: Signal<Out, Bits<R>>,
    stages: [SquareRootStage<X, K, R, T>; K],
    live: [Constant<Bits<T>>; K],
}

impl<const X: usize, const K: usize, const R: usize, const T: usize> Default
    for SquareRoot<X, K, R, T>
{
    fn default() -> Self {
        // Stage k leaves a remainder of k + 2 bits.
        let live = |k: usize| Constant::new(Bits::from((1_u64 << (k + 2)) - 1));
        Self {
            clock: Default::default(),
            radicand: Default::default(),
            root: Default::default(),
            remainder: Default::default(),
            stages: std::array::from_fn(|_| Default::default()),
            live: std::array::from_fn(live),
        }
    }
}

impl<const X: usize, const K: usize, const R: usize, const T: usize> Logic
    for SquareRoot<X, K, R, T>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.stages[0].pairs.next = self.radicand.val();
        self.stages[0].root.next = 0.into();
        self.stages[0].remainder.next = 0.into();
        for i in 1..K {
            self.stages[i].pairs.next = self.stages[i - 1].next_pairs.val();
            self.stages[i].root.next = self.stages[i - 1].next_root.val();
            self.stages[i].remainder.next = self.stages[i - 1].next_remainder.val();
        }
        for i in 0..K {
            self.stages[i].clock.next = self.clock.val();
            self.stages[i].live.next = self.live[i].val();
            // rust-hdl prints no `stages[K - 1]`: of these assignments the one of the last stage holds.
            self.root.next = self.stages[i].next_root.val();
            self.remainder.next = self.stages[i].next_remainder.val();
        }
    }
}
