//! Plane of one bit per pixel over the picture.

use super::pixel_place::PixelPlace;
use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;
use crate::unit::delay::WordDelay;

/// Clocks until the word of a pixel is there.
const READ: usize = 3;

/// Puts a plane of one bit per pixel over a picture that comes pixel by pixel.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `write`, `write_address`, `write_data` | in | the host writes 32 pixels; address `A` bits |
/// | `enable` | in | the plane is shown |
/// | `colour` | in | 24 bits, colour of the set pixels: red in 23..16, green in 15..8, blue in 7..0 |
/// | `width` | in | 12 bits, pixels of a line |
/// | `valid`, `x`, `y` | in | a pixel comes; 12 bits |
/// | `r`, `g`, `b` | in | its colour; 8 bits |
/// | `out_valid`, `out_r`, `out_g`, `out_b` | out | the pixel with the plane over it |
///
/// Pixel `n = y width + x` is bit `n mod 32` of word `n / 32`, modulo `2^A`. Latency 4. `enable` and `colour` are read 3 clocks after the pixel. A word written
/// at clock t is seen by the pixels of t - 1 and later. All bits are 0 at power-up.
pub struct Overlay<const A: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Write a word.
    pub write: Signal<In, Bit>,
    /// Which word.
    pub write_address: Signal<In, Word<A>>,
    /// The word.
    pub write_data: Signal<In, Word<32>>,
    /// The plane is shown.
    pub enable: Signal<In, Bit>,
    /// Colour of the set pixels.
    pub colour: Signal<In, Word<24>>,
    /// Pixels of a line.
    pub width: Signal<In, Word<12>>,
    /// A pixel comes.
    pub valid: Signal<In, Bit>,
    /// Its column.
    pub x: Signal<In, Word<12>>,
    /// Its line.
    pub y: Signal<In, Word<12>>,
    /// Its red.
    pub r: Signal<In, Word<8>>,
    /// Its green.
    pub g: Signal<In, Word<8>>,
    /// Its blue.
    pub b: Signal<In, Word<8>>,
    /// A pixel leaves.
    pub out_valid: Signal<Out, Bit>,
    /// Its red.
    pub out_r: Signal<Out, Word<8>>,
    /// Its green.
    pub out_g: Signal<Out, Word<8>>,
    /// Its blue.
    pub out_b: Signal<Out, Word<8>>,
    read_place: PixelPlace,
    plane: BlockMemory<A, 32>,
    late_valid: WordDelay<Bit>,
    late_r: WordDelay<Word<8>>,
    late_g: WordDelay<Word<8>>,
    late_b: WordDelay<Word<8>>,
    bit_place: DFF<Word<5>>,
    shifted: Signal<Local, Word<32>>,
    covered: Signal<Local, Bit>,
    kept_valid: DFF<Bit>,
    kept_r: DFF<Word<8>>,
    kept_g: DFF<Word<8>>,
    kept_b: DFF<Word<8>>,
    _asleep: bool,
}

block! {
    [const A: usize] Overlay [A]
    inputs { clock, write, write_address, write_data, enable, colour, width, valid, x, y, r, g, b }
    parts { out_valid, out_r, out_g, out_b, read_place, plane, late_valid, late_r, late_g, late_b,
        bit_place, shifted, covered, kept_valid, kept_r, kept_g, kept_b }
    data { }
}

impl<const A: usize> Overlay<A> {
    /// A plane of `2^A` words.
    ///
    /// # Panics
    ///
    /// When the plane is longer than the places of pixels, which have 24 bits.
    pub fn new() -> Self {
        Self::of_address_bits(A)
    }

    /// A plane of `2^bits` words.
    ///
    /// # Panics
    ///
    /// When the plane is longer than the places of pixels, which have 24 bits, or `bits` is not in `1..=A`.
    pub fn of_address_bits(bits: usize) -> Self {
        assert!(bits <= 19, "a plane has at most 19 bits of address");
        fields! {
            [clock, write, write_address, write_data, enable, colour, width, valid, x, y, r, g, b,
                out_valid, out_r, out_g, out_b, bit_place, shifted, covered, kept_valid, kept_r,
                kept_g, kept_b]
            read_place: PixelPlace::new(),
            plane: BlockMemory::of_address_bits(bits),
            late_valid: WordDelay::new(READ),
            late_r: WordDelay::new(READ),
            late_g: WordDelay::new(READ),
            late_b: WordDelay::new(READ),
        }
    }

    /// Clocks from a pixel to the pixel with the plane over it.
    pub const fn latency() -> usize {
        READ + 1
    }
}

impl<const A: usize> Default for Overlay<A> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const A: usize> Logic for Overlay<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("overlay");
        dff_setup!(self, clock, bit_place, kept_valid, kept_r, kept_g, kept_b);
        self.read_place.clock.next = self.clock.val();
        self.read_place.x.next = self.x.val();
        self.read_place.y.next = self.y.val();
        self.read_place.width.next = self.width.val();
        self.plane.clock.next = self.clock.val();
        self.plane.write.next = self.write.val();
        self.plane.write_address.next = self.write_address.val();
        self.plane.write_data.next = self.write_data.val();
        self.plane.read_address.next = self.read_place.place.val().get_bits::<A>(5);
        self.bit_place.d.next = self.read_place.place.val().get_bits::<5>(0);
        self.late_valid.clock.next = self.clock.val();
        self.late_valid.word.next = self.valid.val();
        self.late_r.clock.next = self.clock.val();
        self.late_r.word.next = self.r.val();
        self.late_g.clock.next = self.clock.val();
        self.late_g.word.next = self.g.val();
        self.late_b.clock.next = self.clock.val();
        self.late_b.word.next = self.b.val();
        self.shifted.next = self.plane.read_data.val() >> self.bit_place.q.val();
        self.covered.next = self.enable.val() & self.shifted.val().get_bit(0);
        self.kept_valid.d.next = self.late_valid.late.val();
        self.kept_r.d.next = self.late_r.late.val();
        self.kept_g.d.next = self.late_g.late.val();
        self.kept_b.d.next = self.late_b.late.val();
        if self.covered.val() {
            self.kept_r.d.next = self.colour.val().get_bits::<8>(16);
            self.kept_g.d.next = self.colour.val().get_bits::<8>(8);
            self.kept_b.d.next = self.colour.val().get_bits::<8>(0);
        }
        self.out_valid.next = self.kept_valid.q.val();
        self.out_r.next = self.kept_r.q.val();
        self.out_g.next = self.kept_g.q.val();
        self.out_b.next = self.kept_b.q.val();
    }
}

clocked!(Overlay<const A: usize>);
