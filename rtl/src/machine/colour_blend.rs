//! One colour component seen through another.

use crate::kernel::*;

/// Blends two components: `round((t front + (255 - t) behind) / 255)`.
///
/// The sum is `255 behind + t (front - behind)`: one product. It is 65025 at most, and `(n + floor(n / 256)) / 256` with `n = sum + 128` rounds its
/// 255th part exactly; there are no ties, since 255 is odd.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `front`, `behind` | in | 8 bits |
/// | `weight` | in | 8 bits, t |
/// | `is_seen` | in | the front one counts; else the result is `behind` |
/// | `blend` | out | 8 bits |
///
/// Latency 2: product, sum.
pub struct ColourBlend {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Component in front.
    pub front: Signal<In, Word<8>>,
    /// Component behind it.
    pub behind: Signal<In, Word<8>>,
    /// Weight of the one in front.
    pub weight: Signal<In, Word<8>>,
    /// The one in front counts.
    pub is_seen: Signal<In, Bit>,
    /// What is seen.
    pub blend: Signal<Out, Word<8>>,
    wide_front: Signal<Local, Word<9>>,
    wide_behind: Signal<Local, Word<9>>,
    wide_weight: Signal<Local, Word<9>>,
    signed_weight: Signal<Local, Int<9>>,
    difference: Signal<Local, Word<9>>,
    signed_difference: Signal<Local, Int<9>>,
    kept_product: DFF<Doubled<9>>,
    kept_behind: DFF<Word<8>>,
    kept_is_seen: DFF<Bit>,
    low_product: Signal<Local, Int<16>>,
    product: Signal<Local, Word<16>>,
    single: Signal<Local, Word<16>>,
    shifted: Signal<Local, Word<16>>,
    base: Signal<Local, Word<16>>,
    sum: Signal<Local, Word<16>>,
    quotient: Signal<Local, Word<16>>,
    rounded: Signal<Local, Word<16>>,
    kept_blend: DFF<Word<8>>,
    half: Constant<Word<16>>,
    by_byte: Constant<Word<8>>,
    low: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [] ColourBlend []
    inputs { clock, front, behind, weight, is_seen }
    parts { blend, wide_front, wide_behind, wide_weight, signed_weight, difference,
        signed_difference, kept_product, kept_behind, kept_is_seen, low_product, product, single,
        shifted, base, sum, quotient, rounded, kept_blend, half,
        by_byte, low }
    data { }
}

impl ColourBlend {
    /// A blend of two components.
    pub fn new() -> Self {
        fields! {
            [clock, front, behind, weight, is_seen, blend, wide_front, wide_behind, wide_weight,
                signed_weight, difference, signed_difference, kept_product, kept_behind,
                kept_is_seen, low_product, product, single, shifted, base, sum, quotient, rounded,
                kept_blend]
            half: constant(128),
            by_byte: constant(8),
            low: constant(0),
        }
    }

    /// Clocks from the components to their blend.
    pub const fn latency() -> usize {
        2
    }
}

impl Default for ColourBlend {
    fn default() -> Self {
        Self::new()
    }
}

impl Logic for ColourBlend {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("colour_blend");
        clock!(
            self,
            clock,
            kept_product,
            kept_behind,
            kept_is_seen,
            kept_blend
        );
        self.wide_front.next = bit_cast::<9, 8>(self.front.val());
        self.wide_behind.next = bit_cast::<9, 8>(self.behind.val());
        self.wide_weight.next = bit_cast::<9, 8>(self.weight.val());
        self.difference.next = self.wide_front.val() - self.wide_behind.val();
        self.signed_difference.next = signed_cast(self.difference.val());
        self.signed_weight.next = signed_cast(self.wide_weight.val());
        self.kept_product.d.next = self.signed_difference.val() * self.signed_weight.val();
        self.kept_behind.d.next = self.behind.val();
        self.kept_is_seen.d.next = self.is_seen.val();
        // The sum is never negative and has 16 bits: what the product has above them cancels.
        self.low_product.next = self
            .kept_product
            .q
            .val()
            .get_bits::<16>(self.low.val().index());
        self.product.next = unsigned_cast(self.low_product.val());
        self.single.next = bit_cast::<16, 8>(self.kept_behind.q.val());
        self.shifted.next = self.single.val() << self.by_byte.val();
        self.base.next = self.shifted.val() - self.single.val();
        self.sum.next = self.base.val() + self.product.val() + self.half.val();
        self.quotient.next = self.sum.val() >> self.by_byte.val();
        self.rounded.next = self.sum.val() + self.quotient.val();
        if self.kept_is_seen.q.val() {
            self.kept_blend.d.next = self.rounded.val().get_bits::<8>(self.by_byte.val().index());
        } else {
            self.kept_blend.d.next = self.kept_behind.q.val();
        }
        self.blend.next = self.kept_blend.q.val();
    }
}

clocked!(ColourBlend);
