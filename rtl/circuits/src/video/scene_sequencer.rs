//! The words of a scene that stand in a memory, to the loader of a machine.

use imogene_hdl::{Bits, Value, bundle, module, net};

/// Bits of an address of the memory.
pub const SEQUENCE: u32 = 12;

bundle! {
    /// What a sequencer hears.
    Sequence() {
        last: Bits(1), "the word at the address of the clock before is the last one of the memory";
        m_tready: Bits(1), "the machine takes the word";
    }

    /// What it says.
    Sequenced() {
        m_tvalid: Bits(1), "the word at the address of the clock before is there";
        address: Bits(SEQUENCE), "which word of the memory";
    }
}

/// Sends all words of a memory over AXI4-Stream, one after the other, and begins again behind the last one.
///
/// The memory gives the word of an address one clock later, which is the one that is sent; the sequencer does not see
/// it. One word every two clocks. A frame is what ends in `tlast`: a memory of several frames is an animation, one
/// frame of it in each frame of the screen.
pub fn scene_sequencer(at: &str, sequence: Sequence) -> Sequenced {
    module("scene_sequencer", at, sequence, |sequence| {
        net! {
            let is_there = Bits::register(1);
            let address = Bits::register(SEQUENCE);
            let is_taken = is_there & sequence.m_tready;
            let first = Bits::new(0, SEQUENCE);
            let following = address + Bits::new(1, SEQUENCE);
        }
        is_there.load(!is_taken);
        address.load_when(is_taken, sequence.last.select(first, following));
        Sequenced {
            m_tvalid: is_there,
            address,
        }
    })
}
