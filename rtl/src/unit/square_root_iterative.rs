//! Square root by one row, digit after digit.

use super::square_root::SquareRootRow;
use crate::kernel::*;

/// Gives `root = floor(sqrt(radicand))` and `remainder = radicand - root^2` by one row used `K` times: one result in `K` clocks.
///
/// `F = 2 K`, `K1 = K + 1`, `K2 = K + 2`; `K` is at most 63.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `start` | in | take the radicand; obeyed when not `busy`, ignored otherwise |
/// | `radicand` | in | `F` bits, unsigned; read with an obeyed `start` |
/// | `busy` | out | digits are being found |
/// | `done` | out | root and remainder are complete; high for one clock |
/// | `root` | out | `K` bits, unsigned; kept until the next obeyed `start` |
/// | `remainder` | out | `K + 1` bits, unsigned; kept likewise |
///
/// The edge that obeys `start` finds the first digit, so `done` comes `K` edges after the radicand, that edge counted. A `start`
/// beside `done` is obeyed. Latency `K`. Section 2.3.3.
pub struct SquareRootIterative<const F: usize, const K: usize, const K1: usize, const K2: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Take the radicand.
    pub start: Signal<In, Bit>,
    /// The number whose root is taken.
    pub radicand: Signal<In, Word<F>>,
    /// Digits are being found.
    pub busy: Signal<Out, Bit>,
    /// Root and remainder are complete.
    pub done: Signal<Out, Bit>,
    /// Root, rounded down, when complete.
    pub root: Signal<Out, Word<K>>,
    /// Radicand less the square of the root, when complete.
    pub remainder: Signal<Out, Word<K1>>,
    is_busy: Signal<Local, Bit>,
    begins: Signal<Local, Bit>,
    current: Signal<Local, Word<6>>,
    works: Signal<Local, Bit>,
    less: Signal<Local, Word<6>>,
    row: SquareRootRow<F, K, K1, K2>,
    pairs_left: DFF<Word<F>>,
    kept_root: DFF<Word<K>>,
    kept_remainder: DFF<Word<K1>>,
    digits_left: DFF<Word<6>>,
    kept_done: DFF<Bit>,
    all_digits: Constant<Word<6>>,
    none: Constant<Word<6>>,
    one: Constant<Word<6>>,
    no_digits: Constant<Word<K>>,
    no_remainder: Constant<Word<K1>>,
    all_live: Constant<Word<K2>>,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const K2: usize] SquareRootIterative [F, K, K1, K2]
    inputs { clock, start, radicand }
    parts { busy, done, root, remainder, is_busy, begins, current, works, less, row,
        pairs_left, kept_root, kept_remainder, digits_left, kept_done, all_digits, none,
        one, no_digits, no_remainder, all_live }
    data {  }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize>
    SquareRootIterative<F, K, K1, K2>
{
    /// A unit at rest.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other.
    pub fn new() -> Self {
        assert!(
            F == 2 * K && K1 == K + 1 && K2 == K + 2 && K < 64,
            "widths of the root network"
        );
        Self {
            clock: Signal::default(),
            start: Signal::default(),
            radicand: Signal::default(),
            busy: Signal::default(),
            done: Signal::default(),
            root: Signal::default(),
            remainder: Signal::default(),
            is_busy: Signal::default(),
            begins: Signal::default(),
            current: Signal::default(),
            works: Signal::default(),
            less: Signal::default(),
            row: SquareRootRow::new(),
            pairs_left: DFF::default(),
            kept_root: DFF::default(),
            kept_remainder: DFF::default(),
            digits_left: DFF::default(),
            kept_done: DFF::default(),
            all_digits: constant(K as u64),
            none: constant(0),
            one: constant(1),
            no_digits: constant(0),
            no_remainder: constant(0),
            all_live: constant((1 << K) - 1),
            _asleep: false,
        }
    }

    /// Clocks from the radicand to the root.
    pub const fn latency() -> usize {
        K
    }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> Default
    for SquareRootIterative<F, K, K1, K2>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<const F: usize, const K: usize, const K1: usize, const K2: usize> Logic
    for SquareRootIterative<F, K, K1, K2>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("square_root_iterative");
        dff_setup!(
            self,
            clock,
            pairs_left,
            kept_root,
            kept_remainder,
            digits_left,
            kept_done
        );
        self.is_busy.next = self.digits_left.q.val() != self.none.val();
        self.begins.next = self.start.val() & !self.is_busy.val();
        if self.begins.val() {
            self.row.pairs.next = self.radicand.val();
            self.row.root.next = self.no_digits.val();
            self.row.remainder.next = self.no_remainder.val();
            self.current.next = self.all_digits.val();
        } else {
            self.row.pairs.next = self.pairs_left.q.val();
            self.row.root.next = self.kept_root.q.val();
            self.row.remainder.next = self.kept_remainder.q.val();
            self.current.next = self.digits_left.q.val();
        }
        self.row.live.next = self.all_live.val();
        self.works.next = self.begins.val() | self.is_busy.val();
        self.less.next = self.current.val() - self.one.val();
        self.kept_done.d.next = self.current.val() == self.one.val();
        if self.works.val() {
            self.pairs_left.d.next = self.row.next_pairs.val();
            self.kept_root.d.next = self.row.next_root.val();
            self.kept_remainder.d.next = self.row.next_remainder.val();
            self.digits_left.d.next = self.less.val();
        }
        self.busy.next = self.is_busy.val();
        self.done.next = self.kept_done.q.val();
        self.root.next = self.kept_root.q.val();
        self.remainder.next = self.kept_remainder.q.val();
    }
}

clocked!(SquareRootIterative<const F: usize, const K: usize, const K1: usize, const K2: usize>);
