//! Whole machines as designs, and the shapes of their parts in the words of a format.

use crate::machine::{self, BeamMachine, Beat, Objects, Slot, Volumes, ZoneCore, ZoneMachine};
use crate::object::{Network, Widths};
use crate::video::{Output, OverlayBus};
use imogene_contract::words::{NORMAL, NORMAL_PART, depth_sum, plane, quadratic};
use imogene_hdl::{Bits, Design, Value};

/// Widths of the words of an object in a format.
pub fn widths(depth_word: u32) -> Widths {
    let word = depth_word as usize;
    Widths {
        linear: depth_sum(word) as u32,
        quadratic: quadratic(word) as u32,
        gradient: NORMAL_PART as u32,
        normal: NORMAL as u32,
        plane: plane(word) as u32,
    }
}

/// Object processors of a format, all alike, for objects of all classes.
pub fn objects(depth_word: u32, rows_per_stage: u32, count: u32, planes: u32) -> Objects {
    let slot = Slot {
        planes: planes as usize,
        two_volumes: true,
    };
    Objects {
        depth: depth_word,
        widths: widths(depth_word),
        root: Network::of(depth_word, rows_per_stage),
        slots: vec![slot; count as usize],
    }
}

/// Volume processors of a format, all alike.
pub fn volumes(depth_word: u32, rows_per_stage: u32, count: u32, planes: u32) -> Volumes {
    Volumes {
        depth: depth_word,
        widths: widths(depth_word),
        root: Network::of(depth_word, rows_per_stage),
        planes: vec![u64::from(planes); count as usize],
    }
}

/// A beam machine with its screen.
///
/// # Panics
///
/// With the reason, where machine and screen make no circuit.
pub fn beam_display(machine: &BeamMachine, output: &Output) -> Design {
    Design::of(|| {
        let beat = (Beat::input(machine.bus()), Bits::input(1));
        machine::beam_display("top", beat, OverlayBus::input(), machine, output);
    })
}

/// A beam machine that streams pictures of a width and a height.
///
/// # Panics
///
/// With the reason, where the machine makes no circuit.
pub fn beam_stream(machine: &BeamMachine, size: (u64, u64)) -> Design {
    Design::of(|| {
        let beat = (Beat::input(machine.bus()), Bits::input(1));
        machine::beam_stream("top", beat, Bits::input(1), machine, size);
    })
}

/// The part of a zone machine that decides, with nothing behind it.
///
/// # Panics
///
/// With the reason, where it makes no circuit.
pub fn zone_core(machine: &ZoneCore) -> Design {
    Design::of(|| {
        machine::zone_core(
            "top",
            Beat::input(machine.bus()),
            Bits::input(1),
            machine,
            0,
        );
    })
}

/// A zone machine that streams pixels.
///
/// # Panics
///
/// With the reason, where the machine makes no circuit.
pub fn zone_machine(machine: &ZoneMachine) -> Design {
    Design::of(|| {
        machine::zone_machine("top", Beat::input(machine.bus()), Bits::input(1), machine);
    })
}

/// A zone machine with its screen.
///
/// # Panics
///
/// With the reason, where machine and screen make no circuit.
pub fn zone_display(machine: &ZoneMachine, output: &Output) -> Design {
    Design::of(|| {
        let beat = Beat::input(machine.bus());
        machine::zone_display("top", beat, OverlayBus::input(), machine, output);
    })
}
