//! Square of a word wider than the multipliers.

use crate::kernel::*;

/// Places by which the products of digits ll, lm, mm, lh, mh, hh stand in the square; a pair of different digits counts twice.
const PLACES: [u64; 6] = [0, 16, 30, 31, 46, 60];

/// Product of two digits of 15 bits, on a 16 x 16 signed multiplier.
pub struct DigitProduct<const M: usize> {
    /// One digit.
    pub a: Signal<In, Word<15>>,
    /// The other digit.
    pub b: Signal<In, Word<15>>,
    /// The product, 30 bits at most.
    pub product: Signal<Out, Word<M>>,
    wide_a: Signal<Local, Word<16>>,
    wide_b: Signal<Local, Word<16>>,
    factor_a: Signal<Local, Int<16>>,
    factor_b: Signal<Local, Int<16>>,
    signed_product: Signal<Local, Doubled<16>>,
    plain_product: Signal<Local, Word<32>>,
    _asleep: bool,
}

block! {
    [const M: usize] DigitProduct [M]
    inputs { a, b }
    parts { product, wide_a, wide_b, factor_a, factor_b, signed_product, plain_product }
    data {  }
}

impl<const M: usize> DigitProduct<M> {
    fn new() -> Self {
        Self {
            a: Signal::default(),
            b: Signal::default(),
            product: Signal::default(),
            wide_a: Signal::default(),
            wide_b: Signal::default(),
            factor_a: Signal::default(),
            factor_b: Signal::default(),
            signed_product: Signal::default(),
            plain_product: Signal::default(),
            _asleep: false,
        }
    }
}

impl<const M: usize> Logic for DigitProduct<M> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("digit_product");
        self.wide_a.next = bit_cast::<16, 15>(self.a.val());
        self.wide_b.next = bit_cast::<16, 15>(self.b.val());
        self.factor_a.next = signed_cast(self.wide_a.val());
        self.factor_b.next = signed_cast(self.wide_b.val());
        self.signed_product.next = self.factor_a.val() * self.factor_b.val();
        self.plain_product.next = unsigned_cast(self.signed_product.val().get_bits::<32>(0));
        self.product.next = bit_cast::<M, 32>(self.plain_product.val());
    }
}

/// Gives `square = value^2 mod 2^M` from products of 15-bit digits.
///
/// `N` is at most 45 and `M` at least 32. With digits l, m, h the square is `l^2 + 2^16 lm + 2^30 m^2 + 2^31 lh + 2^46 mh + 2^60 h^2`: six products,
/// each pair of digits once. For 16 to 30 bits the digit h is zero and three products are left; synthesis removes the others.
///
/// | port | direction | format |
/// |---|---|---|
/// | `value` | in | `N` bits, unsigned |
/// | `square` | out | `M` bits, unsigned |
///
/// Without registers: a multiplier and three additions deep.
pub struct Square<const N: usize, const M: usize> {
    /// The number to be squared.
    pub value: Signal<In, Word<N>>,
    /// Its square.
    pub square: Signal<Out, Word<M>>,
    wide: Signal<Local, Word<48>>,
    low: Signal<Local, Word<15>>,
    middle: Signal<Local, Word<15>>,
    high: Signal<Local, Word<15>>,
    term: Vec<Signal<Local, Word<M>>>,
    lower_sum: Signal<Local, Word<M>>,
    middle_sum: Signal<Local, Word<M>>,
    upper_sum: Signal<Local, Word<M>>,
    most: Signal<Local, Word<M>>,
    products: Vec<DigitProduct<M>>,
    middle_place: Constant<Word<8>>,
    high_place: Constant<Word<8>>,
    place: Vec<Constant<Word<8>>>,
    _count: usize,
    _asleep: bool,
}

block! {
    [const N: usize, const M: usize] Square [N, M]
    inputs { value }
    parts { square, wide, low, middle, high, term, lower_sum, middle_sum, upper_sum, most,
        products, middle_place, high_place, place }
    data { _count }
}

impl<const N: usize, const M: usize> Square<N, M> {
    pub(super) fn new() -> Self {
        Self {
            value: Signal::default(),
            square: Signal::default(),
            wide: Signal::default(),
            low: Signal::default(),
            middle: Signal::default(),
            high: Signal::default(),
            term: repeat(PLACES.len(), Signal::default),
            lower_sum: Signal::default(),
            middle_sum: Signal::default(),
            upper_sum: Signal::default(),
            most: Signal::default(),
            products: repeat(PLACES.len(), DigitProduct::new),
            middle_place: constant(15),
            high_place: constant(30),
            place: PLACES.map(constant).into(),
            _count: PLACES.len(),
            _asleep: false,
        }
    }
}

impl<const N: usize, const M: usize> Logic for Square<N, M> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("square");
        self.wide.next = bit_cast::<48, N>(self.value.val());
        self.low.next = self.wide.val().get_bits::<15>(0);
        self.middle.next = self
            .wide
            .val()
            .get_bits::<15>(self.middle_place.val().index());
        self.high.next = self
            .wide
            .val()
            .get_bits::<15>(self.high_place.val().index());
        self.products[0].a.next = self.low.val();
        self.products[0].b.next = self.low.val();
        self.products[1].a.next = self.low.val();
        self.products[1].b.next = self.middle.val();
        self.products[2].a.next = self.middle.val();
        self.products[2].b.next = self.middle.val();
        self.products[3].a.next = self.low.val();
        self.products[3].b.next = self.high.val();
        self.products[4].a.next = self.middle.val();
        self.products[4].b.next = self.high.val();
        self.products[5].a.next = self.high.val();
        self.products[5].b.next = self.high.val();
        for i in 0..self._count {
            self.term[i].next = self.products[i].product.val() << self.place[i].val();
        }
        self.lower_sum.next = self.term[0].val() + self.term[1].val();
        self.middle_sum.next = self.term[2].val() + self.term[3].val();
        self.upper_sum.next = self.term[4].val() + self.term[5].val();
        self.most.next = self.lower_sum.val() + self.middle_sum.val();
        self.square.next = self.most.val() + self.upper_sum.val();
    }
}
