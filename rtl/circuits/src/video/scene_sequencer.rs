//! The words of a scene that stand in a memory, to the loader of a machine.

use imogene_hdl::{Bits, Value, bundle, module, net};

/// Bits of an address of the memory.
pub const SEQUENCE: u32 = 12;
/// Bits of the number of frames of the screen that show one image.
pub const STAYS: u32 = 8;

bundle! {
    /// What a sequencer hears.
    Sequence() {
        last: Bits(1), "the word at the address of the clock before is the last one of the memory";
        ends: Bits(1), "that word is the last one of an image";
        stays: Bits(STAYS), "frames of the screen that show an image, less one; constant";
        m_tready: Bits(1), "the machine takes the word";
    }

    /// What it says.
    Sequenced() {
        m_tvalid: Bits(1), "the word at the address of the clock before is there";
        address: Bits(SEQUENCE), "which word of the memory";
    }
}

/// Sends the images of a memory over AXI4-Stream, one after the other, and begins again behind the last one.
///
/// The memory gives the word of an address one clock later, which is the one that is sent; the sequencer does not see
/// it. One word every two clocks. A machine takes the words of one image for each frame of the screen, so an image that
/// stays is sent again for every frame that shows it.
pub fn scene_sequencer(at: &str, sequence: Sequence) -> Sequenced {
    module("scene_sequencer", at, sequence, |sequence| {
        net! {
            let is_there = Bits::register(1);
            let address = Bits::register(SEQUENCE);
            let image = Bits::register(SEQUENCE);
            let stayed = Bits::register(STAYS);
            let is_taken = is_there & sequence.m_tready;
            let is_sent = is_taken & sequence.ends;
            let is_over = stayed.equals(sequence.stays);
            let beyond = address + Bits::new(1, SEQUENCE);
            let following = sequence.last.select(Bits::new(0, SEQUENCE), beyond);
        }
        is_there.load(!is_taken);
        let again = sequence.ends & !is_over;
        address.load_when(is_taken, again.select(image, following));
        image.load_when(is_sent & is_over, following);
        let more = stayed + Bits::new(1, STAYS);
        stayed.load_when(is_sent, is_over.select(Bits::new(0, STAYS), more));
        Sequenced {
            m_tvalid: is_there,
            address,
        }
    })
}
