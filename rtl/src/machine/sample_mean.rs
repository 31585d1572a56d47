//! Samples of a zone, pass after pass, to pixels.

use super::accumulator::Accumulator;
use super::zone_core::ZONE_BITS;
use crate::kernel::*;
use crate::unit::delay::WordDelay;

/// Means of 2 x 2 or 4 x 4 samples of the pixels of a zone, whose passes follow each other.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid` | in | a sample comes, in the order of the pixels of the zone |
/// | `first_pass`, `last_pass` | in | it is of the first, of the last pass over the zone |
/// | `pass_ends` | in | it is the last of its pass |
/// | `r`, `g`, `b` | in | 8 bits |
/// | `place` | in | 24 bits, the pixel's place on the screen |
/// | `last` | in | it is the last of the frame |
/// | `out_valid` | out | a pixel leaves |
/// | `out_r`, `out_g`, `out_b` | out | 8 bits, the mean, rounded to the nearest, halves up |
/// | `out_place`, `out_last` | out | as they came with the last sample |
///
/// Latency 3, from the sample of the last pass.
pub struct SampleMean {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// A sample comes.
    pub valid: Signal<In, Bit>,
    /// It is of the first pass.
    pub first_pass: Signal<In, Bit>,
    /// It is of the last pass.
    pub last_pass: Signal<In, Bit>,
    /// It is the last of its pass.
    pub pass_ends: Signal<In, Bit>,
    /// Its red.
    pub r: Signal<In, Word<8>>,
    /// Its green.
    pub g: Signal<In, Word<8>>,
    /// Its blue.
    pub b: Signal<In, Word<8>>,
    /// Its pixel's place.
    pub place: Signal<In, Word<24>>,
    /// It is the last of the frame.
    pub last: Signal<In, Bit>,
    /// A pixel leaves.
    pub out_valid: Signal<Out, Bit>,
    /// Mean of red.
    pub out_r: Signal<Out, Word<8>>,
    /// Mean of green.
    pub out_g: Signal<Out, Word<8>>,
    /// Mean of blue.
    pub out_b: Signal<Out, Word<8>>,
    /// Its place.
    pub out_place: Signal<Out, Word<24>>,
    /// It is the last of the frame.
    pub out_last: Signal<Out, Bit>,
    sums: Accumulator<ZONE_BITS>,
    place_delay: WordDelay<Word<24>>,
    last_delay: WordDelay<Bit>,
    count: DFF<Word<ZONE_BITS>>,
    is_fine: Constant<Bit>,
    zero: Constant<Word<ZONE_BITS>>,
    one: Constant<Word<ZONE_BITS>>,
    _asleep: bool,
}

block! {
    [] SampleMean []
    inputs { clock, valid, first_pass, last_pass, pass_ends, r, g, b, place, last }
    parts { out_valid, out_r, out_g, out_b, out_place, out_last, sums, place_delay, last_delay, count, is_fine, zero, one }
    data { }
}

impl SampleMean {
    /// Means of `samples x samples` for zones of up to `2^bits` pixels.
    ///
    /// # Panics
    ///
    /// When there are not 2 or 4 samples along a side, or the zone has more than [`ZONE_BITS`].
    pub fn new(samples: usize, bits: usize) -> Self {
        assert!(samples == 2 || samples == 4, "2 x 2 or 4 x 4 samples");
        fields! {
            [clock, valid, first_pass, last_pass, pass_ends, r, g, b, place, last, out_valid, out_r, out_g, out_b, out_place, out_last, count]
            sums: Accumulator::of_address_bits(bits),
            place_delay: WordDelay::new(Accumulator::<ZONE_BITS>::latency()),
            last_delay: WordDelay::new(Accumulator::<ZONE_BITS>::latency()),
            is_fine: Constant::new(samples == 4),
            zero: constant(0),
            one: constant(1),
        }
    }

    /// Clocks from a sample of the last pass to its pixel.
    pub const fn latency() -> usize {
        Accumulator::<ZONE_BITS>::latency()
    }
}

impl Logic for SampleMean {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sample_mean");
        clock!(self, clock, sums, place_delay, last_delay);
        dff_setup!(self, clock, count);
        self.sums.fine.next = self.is_fine.val();
        self.sums.valid.next = self.valid.val();
        self.sums.address.next = self.count.q.val();
        self.sums.first_pass.next = self.first_pass.val();
        self.sums.last_pass.next = self.last_pass.val();
        self.sums.r.next = self.r.val();
        self.sums.g.next = self.g.val();
        self.sums.b.next = self.b.val();
        if self.valid.val() {
            self.count.d.next = self.count.q.val() + self.one.val();
            if self.pass_ends.val() {
                self.count.d.next = self.zero.val();
            }
        }
        self.place_delay.word.next = self.place.val();
        self.last_delay.word.next = self.last.val();
        self.out_valid.next = self.sums.out_valid.val();
        self.out_r.next = self.sums.out_r.val();
        self.out_g.next = self.sums.out_g.val();
        self.out_b.next = self.sums.out_b.val();
        self.out_place.next = self.place_delay.late.val();
        self.out_last.next = self.last_delay.late.val();
    }
}

clocked!(SampleMean);
