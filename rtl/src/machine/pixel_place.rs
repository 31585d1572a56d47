//! Place of a pixel in a picture.

use crate::kernel::*;

/// Gives the number of a pixel, line by line: `place = y width + x`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `x`, `y` | in | 12 bits |
/// | `width` | in | 12 bits, pixels of a line |
/// | `place` | out | 24 bits |
///
/// One multiplier of 13 x 13 signed bits. Latency 2.
pub struct PixelPlace {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Column.
    pub x: Signal<In, Word<12>>,
    /// Line.
    pub y: Signal<In, Word<12>>,
    /// Pixels of a line.
    pub width: Signal<In, Word<12>>,
    /// Number of the pixel.
    pub place: Signal<Out, Word<24>>,
    wide_y: Signal<Local, Word<13>>,
    wide_width: Signal<Local, Word<13>>,
    factor_y: Signal<Local, Int<13>>,
    factor_width: Signal<Local, Int<13>>,
    product: Signal<Local, Doubled<13>>,
    wide_x: Signal<Local, Word<24>>,
    line_place: DFF<Word<24>>,
    kept_x: DFF<Word<12>>,
    kept_place: DFF<Word<24>>,
    _asleep: bool,
}

block! {
    [] PixelPlace []
    inputs { clock, x, y, width }
    parts { place, wide_y, wide_width, factor_y, factor_width, product, wide_x, line_place, kept_x,
        kept_place }
    data { }
}

impl PixelPlace {
    pub(super) fn new() -> Self {
        fields! {
            [clock, x, y, width, place, wide_y, wide_width, factor_y, factor_width, product,
                wide_x, line_place, kept_x, kept_place]
        }
    }
}

impl Logic for PixelPlace {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("pixel_place");
        dff_setup!(self, clock, line_place, kept_x, kept_place);
        self.wide_y.next = bit_cast::<13, 12>(self.y.val());
        self.wide_width.next = bit_cast::<13, 12>(self.width.val());
        self.factor_y.next = signed_cast(self.wide_y.val());
        self.factor_width.next = signed_cast(self.wide_width.val());
        self.product.next = self.factor_y.val() * self.factor_width.val();
        self.line_place.d.next = unsigned_cast(self.product.val().get_bits::<24>(0));
        self.kept_x.d.next = self.x.val();
        self.wide_x.next = bit_cast::<24, 12>(self.kept_x.q.val());
        self.kept_place.d.next = self.line_place.q.val() + self.wide_x.val();
        self.place.next = self.kept_place.q.val();
    }
}
