//! Square root network without its last rows.

use super::square_root::SquareRoot;
use crate::kernel::*;

/// Gives the first `kept` digits of `floor(sqrt(radicand))`, the lower digits zero: the network of
/// [`SquareRoot`] without its last rows.
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
    network: SquareRoot<F, K, K1, K2>,
    missing: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const K2: usize] SquareRootRows [F, K, K1, K2]
    inputs { clock, radicand }
    parts { root, network, missing }
    data { }
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
        Self {
            clock: Signal::default(),
            radicand: Signal::default(),
            root: Signal::default(),
            network: SquareRoot::of_digits(kept, rows_per_stage),
            missing: constant((K - kept) as u64),
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
        self.network.clock.next = self.clock.val();
        self.network.radicand.next = self.radicand.val();
        self.root.next = self.network.root.val() << self.missing.val();
    }
}

clocked!(SquareRootRows<const F: usize, const K: usize, const K1: usize, const K2: usize>);
