//! Loader: a whole frame of words waits in a memory, and goes to the processors in the vertical blanking.

use super::zone_control::{MATERIAL, OBJECT_WORD, SHADING_WORD, VOLUME_WORD};
use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;
use crate::unit::delay::WordDelay;

/// Bits of the address of a waiting word at most.
pub const LOADER_BITS: usize = 16;

/// Takes the words of the next frame over AXI4-Stream while the present one is drawn, and copies them to the machine in the vertical blanking, one per clock.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `s_tvalid`, `s_tready` | in, out | a word comes |
/// | `s_tdest`, `s_tuser`, `s_tdata` | in | kind, unit and address, data, as for the zone control; commands are ignored |
/// | `s_tlast` | in | last word of the frame |
/// | `retrace` | in | first clock of the vertical blanking |
/// | `load_object`, `load_volume`, `load_shading`, `load_material` | out | a word is on the load bus for them |
/// | `load_unit`, `load_address`, `load_data` | out | the load bus |
/// | `take` | out | all words of a frame are there |
/// | `is_busy` | out | words are being copied, until they are all at work |
/// | `refused` | out | a frame of more words than the memory keeps came to its end, and is forgotten |
///
/// After the last word `s_tready` is low until all words are copied. A `retrace` before the last word changes nothing: the frame before is drawn again, and no
/// picture mixes two frames. n words are at work n + 5 clocks after `retrace`. Chaillou 1991, IV.4.5: the loading memory M2 and its automaton.
pub struct FrameLoader<const F: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// A word comes.
    pub s_tvalid: Signal<In, Bit>,
    /// What it is.
    pub s_tdest: Signal<In, Word<4>>,
    /// Unit and address.
    pub s_tuser: Signal<In, Word<24>>,
    /// Data.
    pub s_tdata: Signal<In, Word<F>>,
    /// It is the last of the frame.
    pub s_tlast: Signal<In, Bit>,
    /// The vertical blanking begins.
    pub retrace: Signal<In, Bit>,
    /// The word is taken.
    pub s_tready: Signal<Out, Bit>,
    /// A word for an object.
    pub load_object: Signal<Out, Bit>,
    /// A word for a volume.
    pub load_volume: Signal<Out, Bit>,
    /// A word for the shading processor.
    pub load_shading: Signal<Out, Bit>,
    /// A material.
    pub load_material: Signal<Out, Bit>,
    /// Unit of the word.
    pub load_unit: Signal<Out, Word<8>>,
    /// Address of the word.
    pub load_address: Signal<Out, Word<16>>,
    /// The word.
    pub load_data: Signal<Out, Word<F>>,
    /// All words are there.
    pub take: Signal<Out, Bit>,
    /// Words are being copied.
    pub is_busy: Signal<Out, Bit>,
    /// The frame is forgotten.
    pub refused: Signal<Out, Bit>,
    place_memory: BlockMemory<LOADER_BITS, 28>,
    word_memory: BlockMemory<LOADER_BITS, F>,
    filled: DFF<Word<17>>,
    is_whole: DFF<Bit>,
    is_over: DFF<Bit>,
    is_copying: DFF<Bit>,
    copied: DFF<Word<17>>,
    was_copying: DFF<Bit>,
    kept_valid: DFF<Bit>,
    kept_place: DFF<Word<28>>,
    kept_word: DFF<Word<F>>,
    kept_refused: DFF<Bit>,
    take_delay: WordDelay<Bit>,
    is_settling: DFF<Bit>,
    comes: Signal<Local, Bit>,
    is_full: Signal<Local, Bit>,
    ends: Signal<Local, Bit>,
    place: Signal<Local, Word<28>>,
    kind: Signal<Local, Word<4>>,
    zero: Constant<Word<17>>,
    one: Constant<Word<17>>,
    size: Constant<Word<17>>,
    kind_bit: Constant<Word<8>>,
    unit_bit: Constant<Word<8>>,
    kind_object: Constant<Word<4>>,
    kind_volume: Constant<Word<4>>,
    kind_shading: Constant<Word<4>>,
    kind_material: Constant<Word<4>>,
    _asleep: bool,
}

block! {
    [const F: usize] FrameLoader [F]
    inputs { clock, s_tvalid, s_tdest, s_tuser, s_tdata, s_tlast, retrace }
    parts { s_tready, load_object, load_volume, load_shading, load_material, load_unit, load_address, load_data, take, is_busy, refused, place_memory, word_memory, filled,
        is_whole, is_over, is_copying, copied, was_copying, kept_valid, kept_place, kept_word, kept_refused, take_delay, is_settling, comes, is_full, ends, place,
        kind, zero, one, size, kind_bit, unit_bit, kind_object, kind_volume, kind_shading, kind_material }
    data { }
}

impl<const F: usize> FrameLoader<F> {
    /// A loader of `2^bits` words.
    ///
    /// # Panics
    ///
    /// When `bits` is not in `1..=16`.
    pub fn new(bits: usize) -> Self {
        fields! {
            [clock, s_tvalid, s_tdest, s_tuser, s_tdata, s_tlast, retrace, s_tready, load_object, load_volume, load_shading, load_material, load_unit,
                load_address, load_data, take, is_busy, refused, filled, is_whole, is_over, is_copying, copied, was_copying, kept_valid, kept_place, kept_word,
                kept_refused, is_settling, comes, is_full, ends, place, kind]
            place_memory: BlockMemory::of_address_bits(bits),
            word_memory: BlockMemory::of_address_bits(bits),
            take_delay: WordDelay::new(3),
            zero: constant(0),
            one: constant(1),
            size: constant(1 << bits),
            kind_bit: constant(24),
            unit_bit: constant(16),
            kind_object: constant(OBJECT_WORD),
            kind_volume: constant(VOLUME_WORD),
            kind_shading: constant(SHADING_WORD),
            kind_material: constant(MATERIAL),
        }
    }

    /// Clocks from the vertical blanking until `words` words are at work.
    pub const fn clocks(words: usize) -> usize {
        words + 5
    }
}

impl<const F: usize> Logic for FrameLoader<F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("frame_loader");
        clock!(self, clock, place_memory, word_memory, take_delay);
        dff_setup!(
            self,
            clock,
            filled,
            is_whole,
            is_over,
            is_copying,
            copied,
            was_copying,
            kept_valid,
            kept_place,
            kept_word,
            kept_refused,
            is_settling
        );
        self.comes.next = self.s_tvalid.val() & !self.is_whole.q.val();
        self.is_full.next = self.filled.q.val() == self.size.val();
        self.place.next = bit_cast::<28, 24>(self.s_tuser.val())
            | (bit_cast::<28, 4>(self.s_tdest.val()) << self.kind_bit.val());
        self.place_memory.write.next = self.comes.val() & !self.is_full.val();
        self.place_memory.write_address.next = self.filled.q.val().get_bits::<LOADER_BITS>(0);
        self.place_memory.write_data.next = self.place.val();
        self.word_memory.write.next = self.comes.val() & !self.is_full.val();
        self.word_memory.write_address.next = self.filled.q.val().get_bits::<LOADER_BITS>(0);
        self.word_memory.write_data.next = self.s_tdata.val();
        self.kept_refused.d.next = false;
        if self.comes.val() {
            if self.is_full.val() {
                self.is_over.d.next = true;
            } else {
                self.filled.d.next = self.filled.q.val() + self.one.val();
            }
            if self.s_tlast.val() {
                if self.is_full.val() | self.is_over.q.val() {
                    self.is_over.d.next = false;
                    self.filled.d.next = self.zero.val();
                    self.kept_refused.d.next = true;
                } else {
                    self.is_whole.d.next = true;
                }
            }
        }
        self.ends.next = self.copied.q.val() + self.one.val() == self.filled.q.val();
        self.place_memory.read_address.next = self.copied.q.val().get_bits::<LOADER_BITS>(0);
        self.word_memory.read_address.next = self.copied.q.val().get_bits::<LOADER_BITS>(0);
        if self.is_copying.q.val() {
            self.copied.d.next = self.copied.q.val() + self.one.val();
            if self.ends.val() {
                self.is_copying.d.next = false;
                self.is_whole.d.next = false;
                self.filled.d.next = self.zero.val();
            }
        } else if self.retrace.val() & self.is_whole.q.val() {
            self.is_copying.d.next = true;
            self.copied.d.next = self.zero.val();
        }
        self.was_copying.d.next = self.is_copying.q.val();
        self.kept_valid.d.next = self.was_copying.q.val();
        self.kept_place.d.next = self.place_memory.read_data.val();
        self.kept_word.d.next = self.word_memory.read_data.val();
        self.take_delay.word.next = self.is_copying.q.val() & self.ends.val();
        self.take.next = self.take_delay.late.val();
        self.is_settling.d.next =
            self.is_copying.q.val() | (self.is_settling.q.val() & !self.take_delay.late.val());
        self.is_busy.next = self.is_copying.q.val() | self.is_settling.q.val();
        self.kind.next = self
            .kept_place
            .q
            .val()
            .get_bits::<4>(self.kind_bit.val().index());
        self.s_tready.next = !self.is_whole.q.val();
        self.load_object.next =
            self.kept_valid.q.val() & (self.kind.val() == self.kind_object.val());
        self.load_volume.next =
            self.kept_valid.q.val() & (self.kind.val() == self.kind_volume.val());
        self.load_shading.next =
            self.kept_valid.q.val() & (self.kind.val() == self.kind_shading.val());
        self.load_material.next =
            self.kept_valid.q.val() & (self.kind.val() == self.kind_material.val());
        self.load_unit.next = self
            .kept_place
            .q
            .val()
            .get_bits::<8>(self.unit_bit.val().index());
        self.load_address.next = self.kept_place.q.val().get_bits::<16>(0);
        self.load_data.next = self.kept_word.q.val();
        self.refused.next = self.kept_refused.q.val();
    }
}

clocked!(FrameLoader<const F: usize>);
