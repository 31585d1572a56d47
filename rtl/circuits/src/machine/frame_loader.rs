//! A whole frame of words waits in a memory, and goes to the processors in the vertical blanking.

use super::{Beat, WordBus};
use imogene_contract::command_stream::{command, kind};
use imogene_hdl::{Bits, Bundle, Value, bundles, join, memory, module, net};

bundles! {
    /// What a loader says.
    Loaded {
        s_tready: Bits as "s_tready", "the beat is taken";
        load: WordBus as "load", "the load bus";
        chosen: Option<Bits> as "chosen", "modules that the word on it is for";
        take: Bits as "take", "all words of a frame are there";
        is_busy: Bits as "is_busy", "words are being copied, until they are all at work";
        refused: Bits as "refused", "a frame of more words than the memory keeps came to its end, and is forgotten";
    }
}

/// Takes the words of the next frame while the present one is drawn, `2^places` of them at most, and copies them to the
/// machine in the vertical blanking, one per clock. Of several `modules` a command chooses those that the words behind
/// it are for, the last one for those of the next frame too; other commands are ignored.
///
/// After the last word `s_tready` is low until all words are copied. If it does not come until `patience` clocks after
/// `retrace`, the frame before is drawn again: no picture mixes two frames. In one blanking at most one frame is
/// copied. n words are at work n + 7 clocks after `retrace`, or after a last word behind it: registers stand between
/// the memory and all processors, and before each of them.
/// Chaillou 1991, IV.4.5: the loading memory M2 and its automaton.
pub fn frame_loader(
    at: &str,
    beat: Beat,
    last: Bits,
    (retrace, patience): (Bits, u64),
    (places, modules): (u32, u32),
) -> Loaded {
    let inputs = (("s", beat), ("s_tlast", last), ("retrace", retrace));
    module("frame_loader", at, inputs, |(beat, last, retrace)| {
        let count = |value: u64| Bits::new(value, places + 1);
        let address = |count: Bits| count.low(places);
        net! {
            let filled = Bits::register(places + 1);
            let copied = Bits::register(places + 1);
            let is_whole = Bits::register(1);
            let is_copying = Bits::register(1);
            let is_settling = Bits::register(1);
            let comes = beat.tvalid & !is_whole;
            // The memory is full at a power of two, where the count stops.
            let is_full = filled.top();
            let is_kept = comes & !is_full;
            let gets_whole = is_kept & last;
            let refuses = comes & is_full & last;
            let begins = Bits::forward(1);
            let next_copied = copied + count(1);
            // Filled before it is copied, and so known a clock later.
            let last_copied = (filled - count(1)).reg();
            let ends = is_copying & copied.equals(last_copied);
            let filled_place = address(filled);
            let copied_place = address(copied);
            let written_place = join([beat.tdest, beat.tuser]);
            let take_late = ends.delay(5);
        }
        let is_in_time = match patience {
            0 => retrace,
            _ => retrace | is_shortly_after(retrace, begins, patience),
        };
        begins.drive(is_in_time & is_whole & !is_copying);
        let next_filled = is_kept.select(filled + count(1), count(0));
        filled.load_when(is_kept | refuses | ends, next_filled);
        copied.load_when(is_copying | begins, begins.select(count(0), next_copied));
        is_whole.load_when(gets_whole | ends, gets_whole);
        is_copying.load_when(begins | ends, begins);
        is_settling.load(is_copying | (is_settling & !take_late));
        let read = |name: &str, data: Bits| {
            let write = (is_kept, filled_place, data);
            memory(name, 1 << places, write, copied_place).reg()
        };
        net! {
            let place = read("place_memory", written_place);
            let word = read("word_memory", beat.tdata);
        }
        let copied = Beat {
            tvalid: is_copying.delayed_as("is_copying_late", 2),
            tdest: place.slice(27, 24),
            tuser: place.low(24),
            tdata: word,
        };
        Loaded {
            s_tready: !is_whole,
            load: WordBus::of(copied).registered(),
            chosen: (modules > 1).then(|| chosen(copied, modules)),
            take: take_late,
            is_busy: is_copying | is_settling,
            refused: refuses.reg(),
        }
    })
}

/// One of the clocks behind an event, as many as there is patience for, unless what it waits for is done.
fn is_shortly_after(event: Bits, is_done: Bits, patience: u64) -> Bits {
    let width = patience.ilog2() + 1;
    let count = |value: u64| Bits::new(value, width);
    net! {
        let clocks_left = Bits::register(width);
        let is_patient = !clocks_left.is(0);
        let counted = event.select(count(patience), clocks_left - count(1));
    }
    let next = is_done.select(count(0), counted);
    clocks_left.load_when(event | is_patient, next);
    is_patient
}

/// The modules that a command has chosen.
fn chosen(copied: Beat, modules: u32) -> Bits {
    let is_command = copied.tvalid & copied.tdest.is(kind::COMMAND.into());
    net! {
        let chooses = is_command & copied.tuser.low(16).is(command::MODULES.into());
        let chosen_modules = copied.tdata.low(modules).reg_when(chooses);
    }
    chosen_modules
}
