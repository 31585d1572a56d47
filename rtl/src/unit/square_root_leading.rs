//! Leading significant digits of the square root.

use super::delay::WordDelay;
use super::root_length::RootLength;
use super::square_root::SquareRoot;
use crate::kernel::*;

/// Gives the `kept` leading significant digits of `floor(sqrt(radicand))`, the lower digits zero; shorter roots are exact.
///
/// `F = 2 K`, `K1 = K + 1`, `K2 = K + 2`. The radicand is shifted up by the even count that fills its top pair, `kept` rows find digits, and
/// the root is shifted back by half the count: the rows left out would only find digits that are zeroed. The root is low by less than
/// `2^(1 - kept)` of itself.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `radicand` | in | `F` bits, unsigned |
/// | `root` | out | `K` bits, unsigned |
///
/// Free running; latency `ceil(kept / rows_per_stage) + 2`, one clock for each shift. Section B.10.
pub struct SquareRootLeading<const F: usize, const K: usize, const K1: usize, const K2: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The number whose root is taken.
    pub radicand: Signal<In, Word<F>>,
    /// Leading digits of the root.
    pub root: Signal<Out, Word<K>>,
    places: Signal<Local, Word<6>>,
    wide_places: Signal<Local, Word<7>>,
    doubled_places: Signal<Local, Word<7>>,
    aligned: Signal<Local, Word<K>>,
    measured: RootLength<F>,
    normal: DFF<Word<F>>,
    kept_places: DFF<Word<6>>,
    network: SquareRoot<F, K, K1, K2>,
    beside: WordDelay<Word<6>>,
    kept_root: DFF<Word<K>>,
    all_digits: Constant<Word<6>>,
    by_one: Constant<Word<2>>,
    missing: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const K2: usize] SquareRootLeading [F, K, K1, K2]
    inputs { clock, radicand }
    parts { root, places, wide_places, doubled_places, aligned, measured, normal, kept_places,
        network, beside, kept_root, all_digits, by_one, missing }
    data { }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize>
    SquareRootLeading<F, K, K1, K2>
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
            places: Signal::default(),
            wide_places: Signal::default(),
            doubled_places: Signal::default(),
            aligned: Signal::default(),
            measured: RootLength::new(),
            normal: DFF::default(),
            kept_places: DFF::default(),
            network: SquareRoot::of_digits(kept, rows_per_stage),
            beside: WordDelay::new(kept.div_ceil(rows_per_stage)),
            kept_root: DFF::default(),
            all_digits: constant(K as u64),
            by_one: constant(1),
            missing: constant((K - kept) as u64),
            _asleep: false,
        }
    }

    /// Clocks from the radicand to the root.
    pub const fn latency(kept: usize, rows_per_stage: usize) -> usize {
        kept.div_ceil(rows_per_stage) + 2
    }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> Logic
    for SquareRootLeading<F, K, K1, K2>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("square_root_leading");
        clock!(self, clock, normal, kept_places, beside, network, kept_root);
        self.measured.radicand.next = self.radicand.val();
        self.places.next = self.all_digits.val() - self.measured.length.val();
        self.wide_places.next = bit_cast::<7, 6>(self.places.val());
        self.doubled_places.next = self.wide_places.val() << self.by_one.val();
        self.normal.d.next = self.radicand.val() << self.doubled_places.val();
        self.kept_places.d.next = self.places.val();
        self.beside.word.next = self.kept_places.q.val();
        self.network.radicand.next = self.normal.q.val();
        self.aligned.next = self.network.root.val() << self.missing.val();
        self.kept_root.d.next = self.aligned.val() >> self.beside.late.val();
        self.root.next = self.kept_root.q.val();
    }
}

clocked!(SquareRootLeading<const F: usize, const K: usize, const K1: usize, const K2: usize>);
