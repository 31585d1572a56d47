//! Whole machines as designs, and the shapes of their parts in the words of a format.
//!
//! What makes no circuit ends in a panic that says why.

use crate::machine::{self, BeamMachine, Beat, Objects, Slot, Volumes, ZoneCore, ZoneMachine};
use crate::object::{Network, Widths};
use crate::video::{Output, OverlayBus};
use imogene_contract::words::{NORMAL, NORMAL_PART, depth_sum, plane, quadratic};
use imogene_hdl::{Bits, Design, Value};

/// The words from which all others of a machine follow, in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MachineWords {
    /// Depth word `W`.
    pub depth: u32,
    /// Root `K`.
    pub root: u32,
    /// Last digits of the root that are not computed.
    pub dropped_rows: u32,
    /// Plane word `P`.
    pub plane: u32,
    /// Normal component.
    pub normal: u32,
    /// Guard bits of f1.
    pub guard_linear: u32,
    /// Guard bits of f2.
    pub guard_quadratic: u32,
}

impl MachineWords {
    /// Words that all follow from the depth word.
    pub const fn of(depth: u32) -> MachineWords {
        MachineWords {
            depth,
            root: depth,
            dropped_rows: 0,
            plane: plane(depth as usize) as u32,
            normal: NORMAL as u32,
            guard_linear: 0,
            guard_quadratic: 0,
        }
    }

    /// Widths of the words of an object.
    pub fn widths(&self) -> Widths {
        Widths {
            linear: depth_sum(self.depth as usize) as u32 + self.guard_linear,
            quadratic: quadratic(self.root as usize) as u32 + self.guard_quadratic,
            gradient: self.normal + (NORMAL_PART - NORMAL) as u32,
            normal: self.normal,
            plane: self.plane,
        }
    }

    /// The root of an object.
    pub fn network(&self, rows_per_stage: u32) -> Network {
        Network {
            depth: self.depth,
            digits: self.root,
            rows: self.root - self.dropped_rows,
            rows_per_stage,
        }
    }
}

/// Object processors side by side.
pub fn objects(words: &MachineWords, rows_per_stage: u32, slots: Vec<Slot>) -> Objects {
    Objects {
        widths: words.widths(),
        root: words.network(rows_per_stage),
        slots,
    }
}

/// Volume processors, all alike.
pub fn volumes(words: &MachineWords, rows_per_stage: u32, count: usize, planes: u64) -> Volumes {
    Volumes {
        widths: words.widths(),
        root: words.network(rows_per_stage),
        planes: vec![planes; count],
    }
}

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
