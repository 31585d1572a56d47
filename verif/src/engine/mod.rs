//! Engines that run the hardware of a beam machine, behind one trait.

pub mod rust_hdl;
pub mod verilator;

use crate::signal::Signal;
use imogene_models::object::load::LoadWord;
use serde::Serialize;

/// Shape of a beam machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct MachineShape {
    /// Depth word.
    pub depth_word: u32,
    /// Object slots.
    pub objects: usize,
    /// Cut planes of each slot.
    pub planes: usize,
    /// Rows of the root network per register stage.
    pub rows_per_stage: usize,
}

/// Inputs of a beam machine for one clock, besides the load bus.
#[derive(Clone, Copy, Debug, Default)]
pub struct MachineInputs {
    /// Starts a zone.
    pub go: bool,
    /// Pixels per line of the zone.
    pub width: u16,
    /// Lines of the zone.
    pub height: u16,
}

/// Outputs of a beam machine after a clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MachineOutputs {
    /// A pixel is there.
    pub valid: bool,
    /// Its depth word.
    pub depth: i64,
    /// Slot of the visible object.
    pub id: u8,
    /// Number of the visible face.
    pub number: u8,
    /// Normal of the visible face.
    pub normal: [i16; 3],
}

/// Something that runs the hardware clock by clock.
pub trait Engine {
    /// Writes one coefficient word; takes a clock.
    fn load(&mut self, object: u8, word: &LoadWord);

    /// One clock without a write.
    fn clock(&mut self, inputs: MachineInputs) -> MachineOutputs;

    /// Values of the signals of [`processor_signals`] inside one slot, after the last clock; none where the engine shows only ports.
    fn probe(&mut self, object: usize) -> Vec<i64>;
}

/// A signal inside a quadric processor, and how many clocks after the raster flags it belongs to their pixel.
#[derive(Clone, Debug)]
pub struct ProbeSignal {
    /// Name, width and sign.
    pub signal: Signal,
    /// Clocks after the flags.
    pub offset: usize,
}

/// The traced signals of a quadric processor, in the order of the pipeline.
pub fn processor_signals(shape: &MachineShape) -> Vec<ProbeSignal> {
    let w = shape.depth_word;
    let root = (w as usize).div_ceil(shape.rows_per_stage);
    let planes = shape.planes;
    let mut list = Vec::new();
    let mut add = |signal: Signal, offset: usize| list.push(ProbeSignal { signal, offset });
    add(Signal::signed("f2", 2 * w), 1);
    add(Signal::signed("f1", w + 2), 1 + root);
    add(Signal::unsigned("root", w), 1 + root);
    add(Signal::signed("near_sum", w + 2), 2 + root);
    add(Signal::signed("far_sum", w + 2), 2 + root);
    add(Signal::signed("interval_zf_a", w), 3 + root);
    add(Signal::signed("interval_zb_a", w), 3 + root);
    add(Signal::signed("interval_zf_b", w), 3 + root);
    add(Signal::signed("interval_zb_b", w), 3 + root);
    for i in 0..planes {
        add(Signal::signed(format!("plane_{i}_depth"), w), 3 + root + i);
        add(Signal::signed(format!("cut_{i}_zf_a"), w), 4 + root + i);
        add(Signal::signed(format!("cut_{i}_zb_a"), w), 4 + root + i);
        add(Signal::signed(format!("cut_{i}_zf_b"), w), 4 + root + i);
        add(Signal::signed(format!("cut_{i}_zb_b"), w), 4 + root + i);
    }
    add(Signal::signed("merged_zf", w), 4 + root + planes);
    add(Signal::signed("merged_zb", w), 4 + root + planes);
    add(Signal::unsigned("merged_nf", 4), 4 + root + planes);
    for name in ["zf", "zb"] {
        add(Signal::signed(name, w), 7 + root + planes);
    }
    add(Signal::unsigned("number", 4), 7 + root + planes);
    for name in ["nx", "ny", "nz"] {
        add(Signal::signed(name, 16), 7 + root + planes);
    }
    list
}
