//! Mean of several passes over a picture.

use super::pass_sum::PassSum;
use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;

/// Adds the colours of 4 or 16 passes in a memory, pixel by pixel, and gives their mean in the last pass.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `fine` | in | 4 x 4 passes, not 2 x 2 |
/// | `valid`, `address` | in | a pixel comes; `A` bits |
/// | `first_pass`, `last_pass` | in | the pixel is of this pass |
/// | `r`, `g`, `b` | in | 8 bits |
/// | `out_valid`, `out_address` | out | a pixel of the last pass leaves |
/// | `out_r`, `out_g`, `out_b` | out | 8 bits, the mean, rounded to the nearest, halves up |
///
/// Latency 3. A pixel comes once in a pass, in any order; its address comes again after 3 clocks at the earliest. `fine` is read with the pixels of the last pass.
pub struct Accumulator<const A: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// 4 x 4 passes.
    pub fine: Signal<In, Bit>,
    /// A pixel comes.
    pub valid: Signal<In, Bit>,
    /// Which pixel.
    pub address: Signal<In, Word<A>>,
    /// It is of the first pass.
    pub first_pass: Signal<In, Bit>,
    /// It is of the last pass.
    pub last_pass: Signal<In, Bit>,
    /// Its red.
    pub r: Signal<In, Word<8>>,
    /// Its green.
    pub g: Signal<In, Word<8>>,
    /// Its blue.
    pub b: Signal<In, Word<8>>,
    /// A pixel of the last pass leaves.
    pub out_valid: Signal<Out, Bit>,
    /// Which pixel.
    pub out_address: Signal<Out, Word<A>>,
    /// Mean of red.
    pub out_r: Signal<Out, Word<8>>,
    /// Mean of green.
    pub out_g: Signal<Out, Word<8>>,
    /// Mean of blue.
    pub out_b: Signal<Out, Word<8>>,
    store: BlockMemory<A, 36>,
    kept_fine: DFF<Bit>,
    kept_valid: DFF<Bit>,
    kept_first: DFF<Bit>,
    kept_last: DFF<Bit>,
    kept_address: DFF<Word<A>>,
    kept_r: DFF<Word<8>>,
    kept_g: DFF<Word<8>>,
    kept_b: DFF<Word<8>>,
    earlier: DFF<Word<36>>,
    held_fine: DFF<Bit>,
    held_valid: DFF<Bit>,
    held_first: DFF<Bit>,
    held_last: DFF<Bit>,
    held_address: DFF<Word<A>>,
    held_r: DFF<Word<8>>,
    held_g: DFF<Word<8>>,
    held_b: DFF<Word<8>>,
    red: PassSum,
    green: PassSum,
    blue: PassSum,
    wide_red: Signal<Local, Word<36>>,
    wide_green: Signal<Local, Word<36>>,
    wide_blue: Signal<Local, Word<36>>,
    high_red: Signal<Local, Word<36>>,
    high_green: Signal<Local, Word<36>>,
    mean_r: DFF<Word<8>>,
    mean_g: DFF<Word<8>>,
    mean_b: DFF<Word<8>>,
    late_valid: DFF<Bit>,
    late_address: DFF<Word<A>>,
    green_place: Constant<Word<6>>,
    red_place: Constant<Word<6>>,
    _asleep: bool,
}

block! {
    [const A: usize] Accumulator [A]
    inputs { clock, fine, valid, address, first_pass, last_pass, r, g, b }
    parts { out_valid, out_address, out_r, out_g, out_b, store, kept_fine, kept_valid, kept_first,
        kept_last, kept_address, kept_r, kept_g, kept_b, earlier, held_fine, held_valid, held_first, held_last, held_address, held_r, held_g, held_b, red, green, blue, wide_red, wide_green,
        wide_blue, high_red, high_green, mean_r, mean_g, mean_b, late_valid, late_address,
        green_place, red_place }
    data { }
}

impl<const A: usize> Accumulator<A> {
    /// An accumulator for `2^A` pixels.
    pub fn new() -> Self {
        Self::of_address_bits(A)
    }

    /// An accumulator for `2^bits` pixels; the other bits of an address are ignored.
    ///
    /// # Panics
    ///
    /// When `bits` is 0 or more than `A`.
    pub fn of_address_bits(bits: usize) -> Self {
        fields! {
            [clock, fine, valid, address, first_pass, last_pass, r, g, b, out_valid, out_address,
                out_r, out_g, out_b, kept_fine, kept_valid, kept_first, kept_last, kept_address,
                kept_r, kept_g, kept_b, earlier, held_fine, held_valid, held_first, held_last, held_address, held_r, held_g, held_b, wide_red, wide_green, wide_blue, high_red, high_green,
                mean_r, mean_g, mean_b, late_valid, late_address]
            store: BlockMemory::of_address_bits(bits),
            red: PassSum::new(),
            green: PassSum::new(),
            blue: PassSum::new(),
            green_place: constant(12),
            red_place: constant(24),
        }
    }

    /// Clocks from a pixel of the last pass to its mean.
    pub const fn latency() -> usize {
        3
    }
}

impl<const A: usize> Default for Accumulator<A> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const A: usize> Logic for Accumulator<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("accumulator");
        dff_setup!(
            self,
            clock,
            kept_fine,
            kept_valid,
            kept_first,
            kept_last,
            kept_address,
            kept_r,
            kept_g,
            kept_b,
            earlier,
            held_fine,
            held_valid,
            held_first,
            held_last,
            held_address,
            held_r,
            held_g,
            held_b,
            mean_r,
            mean_g,
            mean_b,
            late_valid,
            late_address
        );
        self.kept_fine.d.next = self.fine.val();
        self.kept_valid.d.next = self.valid.val();
        self.kept_first.d.next = self.first_pass.val();
        self.kept_last.d.next = self.last_pass.val();
        self.kept_address.d.next = self.address.val();
        self.kept_r.d.next = self.r.val();
        self.kept_g.d.next = self.g.val();
        self.kept_b.d.next = self.b.val();
        self.earlier.d.next = self.store.read_data.val();
        self.held_fine.d.next = self.kept_fine.q.val();
        self.held_valid.d.next = self.kept_valid.q.val();
        self.held_first.d.next = self.kept_first.q.val();
        self.held_last.d.next = self.kept_last.q.val();
        self.held_address.d.next = self.kept_address.q.val();
        self.held_r.d.next = self.kept_r.q.val();
        self.held_g.d.next = self.kept_g.q.val();
        self.held_b.d.next = self.kept_b.q.val();
        self.red.value.next = self.held_r.q.val();
        self.red.earlier.next = self.earlier.q.val().get_bits::<12>(24);
        self.red.first.next = self.held_first.q.val();
        self.red.fine.next = self.held_fine.q.val();
        self.wide_red.next = bit_cast::<36, 12>(self.red.sum.val());
        self.mean_r.d.next = self.red.mean.val();
        self.green.value.next = self.held_g.q.val();
        self.green.earlier.next = self.earlier.q.val().get_bits::<12>(12);
        self.green.first.next = self.held_first.q.val();
        self.green.fine.next = self.held_fine.q.val();
        self.wide_green.next = bit_cast::<36, 12>(self.green.sum.val());
        self.mean_g.d.next = self.green.mean.val();
        self.blue.value.next = self.held_b.q.val();
        self.blue.earlier.next = self.earlier.q.val().get_bits::<12>(0);
        self.blue.first.next = self.held_first.q.val();
        self.blue.fine.next = self.held_fine.q.val();
        self.wide_blue.next = bit_cast::<36, 12>(self.blue.sum.val());
        self.mean_b.d.next = self.blue.mean.val();
        self.high_red.next = self.wide_red.val() << self.red_place.val();
        self.high_green.next = self.wide_green.val() << self.green_place.val();
        self.store.clock.next = self.clock.val();
        self.store.read_address.next = self.address.val();
        self.store.write.next = self.held_valid.q.val();
        self.store.write_address.next = self.held_address.q.val();
        self.store.write_data.next =
            self.high_red.val() | self.high_green.val() | self.wide_blue.val();
        self.late_valid.d.next = self.held_valid.q.val() & self.held_last.q.val();
        self.late_address.d.next = self.held_address.q.val();
        self.out_valid.next = self.late_valid.q.val();
        self.out_address.next = self.late_address.q.val();
        self.out_r.next = self.mean_r.q.val();
        self.out_g.next = self.mean_g.q.val();
        self.out_b.next = self.mean_b.q.val();
    }
}

clocked!(Accumulator<const A: usize>);
