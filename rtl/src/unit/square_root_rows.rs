//! Square root network without its last rows.

use super::square_root::SquareRootStage;
use crate::kernel::*;

/// Gives the first `kept` digits of `floor(sqrt(radicand))`, the lower digits zero: the network of
/// [`SquareRoot`](super::square_root::SquareRoot) without its last rows.
///
/// `F = 2 K`, `K1 = K + 1`, `K2 = K + 2`. The root is low by less than `2^(K - kept)`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `radicand` | in | `F` bits, unsigned |
/// | `root` | out | `K` bits, unsigned |
///
/// Free running; latency `ceil(kept / rows_per_stage)`. Restatement 4.3.
pub struct SquareRootRows<const F: usize, const K: usize, const K1: usize, const K2: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The number whose root is taken.
    pub radicand: Signal<In, Word<F>>,
    /// Upper digits of the root.
    pub root: Signal<Out, Word<K>>,
    digits: Signal<Local, Word<K>>,
    stages: Vec<SquareRootStage<F, K, K1, K2>>,
    no_digits: Constant<Word<K>>,
    no_remainder: Constant<Word<K1>>,
    missing: Constant<Word<8>>,
    _count: usize,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const K2: usize] SquareRootRows [F, K, K1, K2]
    inputs { clock, radicand }
    parts { root, digits, stages, no_digits, no_remainder, missing }
    data { _count }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize>
    SquareRootRows<F, K, K1, K2>
{
    /// A network of `kept` rows with `rows_per_stage` rows between registers.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other, or a count is not in `1..=K`.
    pub fn new(kept: usize, rows_per_stage: usize) -> Self {
        assert!(
            F == 2 * K && K1 == K + 1 && K2 == K + 2,
            "widths of the root network"
        );
        assert!(
            (1..=K).contains(&rows_per_stage),
            "rows per stage are 1 to {K}"
        );
        assert!((1..=K).contains(&kept), "kept digits are 1 to {K}");
        let count = Self::latency(kept, rows_per_stage);
        let rows = |stage: usize| rows_per_stage.min(kept - stage * rows_per_stage);
        Self {
            clock: Signal::default(),
            radicand: Signal::default(),
            root: Signal::default(),
            digits: Signal::default(),
            stages: (0..count)
                .map(|stage| SquareRootStage::new(rows(stage)))
                .collect(),
            no_digits: constant(0),
            no_remainder: constant(0),
            missing: constant((K - kept) as u64),
            _count: count,
            _asleep: false,
        }
    }

    /// Clocks from the radicand to the root.
    pub const fn latency(kept: usize, rows_per_stage: usize) -> usize {
        kept.div_ceil(rows_per_stage)
    }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> Logic
    for SquareRootRows<F, K, K1, K2>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("square_root_rows");
        self.stages[0].clock.next = self.clock.val();
        self.stages[0].pairs.next = self.radicand.val();
        self.stages[0].root.next = self.no_digits.val();
        self.stages[0].remainder.next = self.no_remainder.val();
        for i in 1..self._count {
            self.stages[i].clock.next = self.clock.val();
            self.stages[i].pairs.next = self.stages[i - 1].next_pairs.val();
            self.stages[i].root.next = self.stages[i - 1].next_root.val();
            self.stages[i].remainder.next = self.stages[i - 1].next_remainder.val();
        }
        for i in 0..self._count {
            self.digits.next = self.stages[i].next_root.val();
        }
        self.root.next = self.digits.val() << self.missing.val();
    }
}

clocked!(SquareRootRows<const F: usize, const K: usize, const K1: usize, const K2: usize>);
