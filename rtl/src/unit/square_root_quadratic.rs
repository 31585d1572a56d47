//! Piecewise quadratic square root with corrections.

use super::fifteenth::Fifteenth;
use super::root_correction::RootCorrection;
use super::root_length::RootLength;
use super::square::Square;
use crate::kernel::*;

/// Gives an approximate root: one parabola per pair of octaves, joined, and corrections behind it.
///
/// `F = 2 K`, `K1 = K + 1`, `P = K + 12`. With `m` from [`RootLength`] and `A = floor(X / 2^m)`,
/// `15 R = floor(15 X / 2^m) + 2^(m+2) - floor(A^2 / 2^(m-2))`: the source's polynomial with the sign of its square corrected. The greatest error is
/// 1.35, 0.53 and 0.22 % after 0, 1 and 2 corrections, besides the floors. The root steps down by one at some radicands.
/// Cost besides the corrections: the products of a [`Square`] of `K` bits and twelve additions.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `radicand` | in | `F` bits, unsigned |
/// | `root` | out | `K + 1` bits, unsigned; `2^K` at most |
///
/// Free running; latency `3 + 2 corrections`: scaling, square, fifteenth. Section 2.3.3.
pub struct SquareRootQuadratic<const F: usize, const K: usize, const K1: usize, const P: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The number whose root is taken.
    pub radicand: Signal<In, Word<F>>,
    /// The approximate root.
    pub root: Signal<Out, Word<K1>>,
    length: Signal<Local, Word<6>>,
    power: Signal<Local, Word<K1>>,
    mask: Signal<Local, Word<K1>>,
    shifted: Signal<Local, Word<F>>,
    low_part: Signal<Local, Word<K1>>,
    wide_scaled: Signal<Local, Word<P>>,
    scaled_16: Signal<Local, Word<P>>,
    scaled_15: Signal<Local, Word<P>>,
    wide_rest: Signal<Local, Word<P>>,
    rest_16: Signal<Local, Word<P>>,
    rest_15: Signal<Local, Word<P>>,
    rest_part: Signal<Local, Word<P>>,
    offset: Signal<Local, Word<P>>,
    slope: Signal<Local, Word<P>>,
    places: Signal<Local, Word<6>>,
    shifted_square: Signal<Local, Word<F>>,
    square_part: Signal<Local, Word<P>>,
    fifteenfold: Signal<Local, Word<P>>,
    measured: RootLength<F>,
    kept_scaled: DFF<Word<K>>,
    kept_rest: DFF<Word<K1>>,
    length_1: DFF<Word<6>>,
    radicand_1: DFF<Word<F>>,
    squarer: Square<K, F>,
    kept_square: DFF<Word<F>>,
    kept_sum: DFF<Word<P>>,
    length_2: DFF<Word<6>>,
    radicand_2: DFF<Word<F>>,
    fifteenth: Fifteenth<P, K1>,
    length_3: DFF<Word<6>>,
    radicand_3: DFF<Word<F>>,
    kept_root: DFF<Word<K1>>,
    corrections: Vec<RootCorrection<F, K1>>,
    one: Constant<Word<K1>>,
    four: Constant<Word<P>>,
    by_4: Constant<Word<8>>,
    two_places: Constant<Word<6>>,
    no_places: Constant<Word<6>>,
    _first: usize,
    _count: usize,
    _asleep: bool,
}

block! {
    [const F: usize, const K: usize, const K1: usize, const P: usize] SquareRootQuadratic [F, K, K1, P]
    inputs { clock, radicand }
    parts { root, length, power, mask, shifted, low_part, wide_scaled, scaled_16, scaled_15,
        wide_rest, rest_16, rest_15, rest_part, offset, slope, places, shifted_square,
        square_part, fifteenfold, measured, kept_scaled, kept_rest, length_1, radicand_1,
        squarer, kept_square, kept_sum, length_2, radicand_2, fifteenth, length_3,
        radicand_3, kept_root, corrections, one, four, by_4, two_places, no_places }
    data { _first, _count }
}

impl<const F: usize, const K: usize, const K1: usize, const P: usize>
    SquareRootQuadratic<F, K, K1, P>
{
    /// A unit with a number of corrections behind the estimate, which may be 0.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other.
    pub fn new(corrections: usize) -> Self {
        assert!(
            F == 2 * K && K1 == K + 1 && P == K + 12,
            "widths of the root network"
        );
        Self {
            clock: Signal::default(),
            radicand: Signal::default(),
            root: Signal::default(),
            length: Signal::default(),
            power: Signal::default(),
            mask: Signal::default(),
            shifted: Signal::default(),
            low_part: Signal::default(),
            wide_scaled: Signal::default(),
            scaled_16: Signal::default(),
            scaled_15: Signal::default(),
            wide_rest: Signal::default(),
            rest_16: Signal::default(),
            rest_15: Signal::default(),
            rest_part: Signal::default(),
            offset: Signal::default(),
            slope: Signal::default(),
            places: Signal::default(),
            shifted_square: Signal::default(),
            square_part: Signal::default(),
            fifteenfold: Signal::default(),
            measured: RootLength::new(),
            kept_scaled: DFF::default(),
            kept_rest: DFF::default(),
            length_1: DFF::default(),
            radicand_1: DFF::default(),
            squarer: Square::new(),
            kept_square: DFF::default(),
            kept_sum: DFF::default(),
            length_2: DFF::default(),
            radicand_2: DFF::default(),
            fifteenth: Fifteenth::new(),
            length_3: DFF::default(),
            radicand_3: DFF::default(),
            kept_root: DFF::default(),
            corrections: repeat(corrections, RootCorrection::new),
            one: constant(1),
            four: constant(4),
            by_4: constant(4),
            two_places: constant(2),
            no_places: constant(0),
            _first: corrections.min(1),
            _count: corrections,
            _asleep: false,
        }
    }

    /// Clocks from the radicand to the root.
    pub const fn latency(corrections: usize) -> usize {
        3 + 2 * corrections
    }
}

impl<const F: usize, const K: usize, const K1: usize, const P: usize> Logic
    for SquareRootQuadratic<F, K, K1, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("square_root_quadratic");
        clock!(
            self,
            clock,
            kept_scaled,
            kept_rest,
            length_1,
            radicand_1,
            kept_square,
            kept_sum,
            length_2,
            radicand_2,
            length_3,
            radicand_3,
            kept_root
        );
        self.measured.radicand.next = self.radicand.val();
        self.length.next = self.measured.length.val();
        self.power.next = self.one.val() << self.length.val();
        self.mask.next = self.power.val() - self.one.val();
        self.shifted.next = self.radicand.val() >> self.length.val();
        self.low_part.next = bit_cast::<K1, F>(self.radicand.val());
        self.kept_scaled.d.next = bit_cast::<K, F>(self.shifted.val());
        self.kept_rest.d.next = self.low_part.val() & self.mask.val();
        self.length_1.d.next = self.length.val();
        self.radicand_1.d.next = self.radicand.val();
        // 15 X does not fit the radicand's width: 15 A, and 15 times the bits below A.
        self.wide_scaled.next = bit_cast::<P, K>(self.kept_scaled.q.val());
        self.scaled_16.next = self.wide_scaled.val() << self.by_4.val();
        self.scaled_15.next = self.scaled_16.val() - self.wide_scaled.val();
        self.wide_rest.next = bit_cast::<P, K1>(self.kept_rest.q.val());
        self.rest_16.next = self.wide_rest.val() << self.by_4.val();
        self.rest_15.next = self.rest_16.val() - self.wide_rest.val();
        self.rest_part.next = self.rest_15.val() >> self.length_1.q.val();
        self.offset.next = self.four.val() << self.length_1.q.val();
        self.slope.next = self.scaled_15.val() + self.rest_part.val();
        self.kept_sum.d.next = self.slope.val() + self.offset.val();
        self.squarer.value.next = self.kept_scaled.q.val();
        self.kept_square.d.next = self.squarer.square.val();
        self.length_2.d.next = self.length_1.q.val();
        self.radicand_2.d.next = self.radicand_1.q.val();
        // At lengths below 2 the square is 0 or 1, and the fifteenth is the same without a shift.
        if self.length_2.q.val() < self.two_places.val() {
            self.places.next = self.no_places.val();
        } else {
            self.places.next = self.length_2.q.val() - self.two_places.val();
        }
        self.shifted_square.next = self.kept_square.q.val() >> self.places.val();
        self.square_part.next = bit_cast::<P, F>(self.shifted_square.val());
        self.fifteenfold.next = self.kept_sum.q.val() - self.square_part.val();
        self.fifteenth.value.next = self.fifteenfold.val();
        self.kept_root.d.next = self.fifteenth.quotient.val();
        self.length_3.d.next = self.length_2.q.val();
        self.radicand_3.d.next = self.radicand_2.q.val();
        for i in 0..self._first {
            self.corrections[i].radicand.next = self.radicand_3.q.val();
            self.corrections[i].length.next = self.length_3.q.val();
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

clocked!(SquareRootQuadratic<const F: usize, const K: usize, const K1: usize, const P: usize>);
