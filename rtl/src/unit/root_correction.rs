//! Correction of an approximate root.

use super::square::Square;
use crate::kernel::*;

/// One correction of an approximate root: `next_root = root - floor((root^2 - radicand) / 2^(length + 1))`.
///
/// Root and results have `K1` bits, one more than the exact root, because the floor can round the largest root up to a power of two. The
/// excess `root^2 - radicand` stands in `F` bits, two's complement: a root in error by 7 % at most leaves it below an eighth of their
/// range. Cost: the products of a [`Square`], an `F` bit and a `K1` bit subtractor, and one shifter.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `radicand` | in | `F` bits, unsigned |
/// | `length` | in | 6 bits, as from [`RootLength`](super::root_length::RootLength) |
/// | `root` | in | `K1` bits, unsigned |
/// | `late_radicand`, `late_length` | out | the inputs, beside the result |
/// | `next_root` | out | `K1` bits, unsigned |
///
/// Latency 2: the square, then the subtractions. Section 2.3.3.
pub struct RootCorrection<const F: usize, const K1: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The number whose root is taken.
    pub radicand: Signal<In, Word<F>>,
    /// Bits of the root.
    pub length: Signal<In, Word<6>>,
    /// The root so far.
    pub root: Signal<In, Word<K1>>,
    /// The radicand, beside the result.
    pub late_radicand: Signal<Out, Word<F>>,
    /// The length, beside the result.
    pub late_length: Signal<Out, Word<6>>,
    /// The corrected root.
    pub next_root: Signal<Out, Word<K1>>,
    excess: Signal<Local, Word<F>>,
    negative: Signal<Local, Bit>,
    magnitude: Signal<Local, Word<F>>,
    places: Signal<Local, Word<6>>,
    shifted: Signal<Local, Word<F>>,
    narrow: Signal<Local, Word<K1>>,
    taken: Signal<Local, Word<K1>>,
    squarer: Square<K1, F>,
    kept_square: DFF<Word<F>>,
    kept_radicand: DFF<Word<F>>,
    kept_length: DFF<Word<6>>,
    kept_root: DFF<Word<K1>>,
    last_radicand: DFF<Word<F>>,
    last_length: DFF<Word<6>>,
    last_root: DFF<Word<K1>>,
    sign: Constant<Word<8>>,
    one: Constant<Word<6>>,
    _asleep: bool,
}

block! {
    [const F: usize, const K1: usize] RootCorrection [F, K1]
    inputs { clock, radicand, length, root }
    parts { late_radicand, late_length, next_root, excess, negative, magnitude, places,
        shifted, narrow, taken, squarer, kept_square, kept_radicand, kept_length,
        kept_root, last_radicand, last_length, last_root, sign, one }
    data {  }
}

impl<const F: usize, const K1: usize> RootCorrection<F, K1> {
    pub(super) fn new() -> Self {
        Self {
            clock: Signal::default(),
            radicand: Signal::default(),
            length: Signal::default(),
            root: Signal::default(),
            late_radicand: Signal::default(),
            late_length: Signal::default(),
            next_root: Signal::default(),
            excess: Signal::default(),
            negative: Signal::default(),
            magnitude: Signal::default(),
            places: Signal::default(),
            shifted: Signal::default(),
            narrow: Signal::default(),
            taken: Signal::default(),
            squarer: Square::new(),
            kept_square: DFF::default(),
            kept_radicand: DFF::default(),
            kept_length: DFF::default(),
            kept_root: DFF::default(),
            last_radicand: DFF::default(),
            last_length: DFF::default(),
            last_root: DFF::default(),
            sign: constant(F as u64 - 1),
            one: constant(1),
            _asleep: false,
        }
    }
}

impl<const F: usize, const K1: usize> Logic for RootCorrection<F, K1> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("root_correction");
        clock!(
            self,
            clock,
            kept_square,
            kept_radicand,
            kept_length,
            kept_root,
            last_radicand,
            last_length,
            last_root
        );
        self.squarer.value.next = self.root.val();
        self.kept_square.d.next = self.squarer.square.val();
        self.kept_radicand.d.next = self.radicand.val();
        self.kept_length.d.next = self.length.val();
        self.kept_root.d.next = self.root.val();
        self.excess.next = self.kept_square.q.val() - self.kept_radicand.q.val();
        self.negative.next = self.excess.val().get_bit(self.sign.val().index());
        self.places.next = self.kept_length.q.val() + self.one.val();
        // The floor of a negative number is the complement of the shifted complement.
        if self.negative.val() {
            self.magnitude.next = !self.excess.val();
        } else {
            self.magnitude.next = self.excess.val();
        }
        self.shifted.next = self.magnitude.val() >> self.places.val();
        self.narrow.next = bit_cast::<K1, F>(self.shifted.val());
        if self.negative.val() {
            self.taken.next = !self.narrow.val();
        } else {
            self.taken.next = self.narrow.val();
        }
        self.last_root.d.next = self.kept_root.q.val() - self.taken.val();
        self.last_radicand.d.next = self.kept_radicand.q.val();
        self.last_length.d.next = self.kept_length.q.val();
        self.late_radicand.next = self.last_radicand.q.val();
        self.late_length.next = self.last_length.q.val();
        self.next_root.next = self.last_root.q.val();
    }
}
