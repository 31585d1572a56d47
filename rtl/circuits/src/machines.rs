//! Whole machines as designs.
//!
//! What makes no circuit ends in a panic that says why.

use crate::machine::{self, BeamMachine, Beat, ZoneCore, ZoneMachine};
use crate::video::{Output, OverlayBus};
use imogene_contract::tile::TileWords;
use imogene_hdl::{Bits, Design, Value};

/// A beam machine with its screen.
pub fn beam_display(machine: &BeamMachine, output: &Output) -> Design {
    Design::of(|| {
        let beat = (Beat::input(machine.bus()), Bits::input(1));
        machine::beam_display("top", beat, OverlayBus::input(), machine, output)
    })
}

/// A beam machine that streams pictures of a width and a height.
pub fn beam_stream(machine: &BeamMachine, size: (u64, u64)) -> Design {
    Design::of(|| {
        let beat = (Beat::input(machine.bus()), Bits::input(1));
        machine::beam_stream("top", beat, Bits::input(1), machine, size)
    })
}

/// The part of a zone machine that decides, with nothing behind it.
pub fn zone_core(machine: &ZoneCore) -> Design {
    Design::of(|| {
        let beat = Beat::input(machine.bus());
        machine::zone_core("top", beat, Bits::input(1), machine, 0)
    })
}

/// A zone machine that streams pixels.
pub fn zone_machine(machine: &ZoneMachine) -> Design {
    Design::of(|| {
        let beat = Beat::input(machine.bus());
        machine::zone_machine("top", beat, Bits::input(1), machine)
    })
}

/// A zone machine with its screen.
pub fn zone_display(machine: &ZoneMachine, output: &Output) -> Design {
    Design::of(|| {
        let beat = Beat::input(machine.bus());
        machine::zone_display("top", beat, OverlayBus::input(), machine, output)
    })
}

/// A tile: one solid whose words are constants.
pub fn tile(words: &TileWords) -> Design {
    Design::of(|| machine::tile("top", words))
}
