//! Engines that run the hardware: the circuits themselves, compiled or levelised in process, and the emitted Verilog in
//! Icarus Verilog or Verilator.
//!
//! A unit runs behind [`Clocked`](crate::subject::Clocked), a machine behind [`Instance`](source::Instance); both get
//! the same stimulus and the same scoreboard in every engine. [`design`] is what the simulators of Verilog have in
//! common.

pub mod beam;
pub mod circuit;
pub mod design;
pub mod icarus;
pub mod source;
pub mod speed;
pub mod verilator;

use crate::signal::Signal;
use design::Simulator;
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_golden::machine::fitted::FittedSlot;
use imogene_rtl::emit::machine::{MachineRequest, Slot};

/// Name of the engine in process, circuits as machine code, in options and reports.
pub const BUILT_IN: &str = "built-in";

/// Name of the simulator of `imogene-hdl`, which needs no code generator: the check of the built-in engine.
pub const LEVELISED: &str = "levelised";

/// What runs the hardware.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// The circuits, compiled in process.
    BuiltIn,
    /// The emitted Verilog.
    Verilog(Simulator),
}

impl Engine {
    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Engine::BuiltIn => BUILT_IN,
            Engine::Verilog(simulator) => simulator.name(),
        }
    }
}

/// Shape of a beam machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MachineShape {
    /// Its words.
    pub format: Format,
    /// Object slots.
    pub objects: usize,
    /// Cut planes of each slot.
    pub planes: usize,
    /// Rows of the root network per register stage.
    pub rows_per_stage: usize,
}

impl MachineShape {
    /// The request for its hardware.
    pub fn request(&self) -> MachineRequest {
        let slots = vec![Slot::full(self.planes); self.objects];
        MachineRequest::fitted(self.format.widths(), self.rows_per_stage, slots)
    }
}

/// The slots of a golden machine, as hardware is asked for.
pub fn slots_of(slots: &[FittedSlot]) -> Vec<Slot> {
    let slot = |slot: &FittedSlot| Slot {
        planes: slot.planes as usize,
        two_volumes: slot.two_volumes,
    };
    slots.iter().map(slot).collect()
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
    /// Values of [`MachineOutputs::signals`]; `None` where the engine shows an undefined bit.
    pub values: [Option<i64>; 7],
}

impl MachineOutputs {
    /// The outputs: whether a pixel is there, its depth word, slot of the visible object, number and normal of its
    /// visible face.
    pub fn signals(widths: &MachineWords) -> Vec<Signal> {
        vec![
            Signal::bit("valid"),
            Signal::signed("depth", widths.depth),
            Signal::unsigned("id", 8),
            Signal::unsigned("number", 4),
            Signal::signed("nx", widths.normal),
            Signal::signed("ny", widths.normal),
            Signal::signed("nz", widths.normal),
        ]
    }

    /// True if a pixel is there.
    pub fn valid(&self) -> bool {
        self.values[0] == Some(1)
    }
}

/// A signal inside a quadric processor, and how many clocks after the raster flags it belongs to their pixel.
#[derive(Clone, Debug)]
pub struct ProbeSignal {
    /// Name, width and sign.
    pub signal: Signal,
    /// Clocks after the flags.
    pub offset: usize,
    /// Its place within the processor.
    pub point: String,
}

/// The traced signals of a quadric processor, in the order of the pipeline.
pub fn processor_signals(shape: &MachineShape) -> Vec<ProbeSignal> {
    let format = &shape.format;
    let (w, sum) = (format.depth, format.sum);
    let root = (format.root_rows() as usize).div_ceil(shape.rows_per_stage);
    let planes = shape.planes;
    let mut list = Vec::new();
    let mut add = |signal: Signal, offset: usize, point: &str| {
        let point = point.to_owned();
        list.push(ProbeSignal {
            signal,
            offset,
            point,
        });
    };
    add(
        Signal::signed("f2", format.pe2_width()),
        1,
        "quadric.f2.value",
    );
    add(
        Signal::signed("f1", format.pe1_width()),
        1 + root,
        "quadric.f1.value",
    );
    let width = format.root_rows();
    add(
        Signal::unsigned("root", width),
        1 + root,
        "quadric.square_root.root",
    );
    for name in ["near_sum", "far_sum"] {
        add(
            Signal::signed(name, sum),
            2 + root,
            &format!("quadric.{name}"),
        );
    }
    let ends = [("zf", "a"), ("zb", "a"), ("zf", "b"), ("zb", "b")];
    for (end, half) in ends {
        let [name, point] = ["_", "."].map(|joint| format!("interval{joint}{end}_{half}"));
        add(Signal::signed(name, w), 3 + root, &point);
    }
    for i in 0..planes {
        let depth = Signal::signed(format!("plane_{i}_depth"), w);
        add(depth, 3 + root + i, &format!("planes_{i}.depth"));
        for (end, half) in ends {
            let cut = Signal::signed(format!("cut_{i}_{end}_{half}"), w);
            add(cut, 4 + root + i, &format!("cut_{half}_{i}.cut_{end}"));
        }
    }
    let merged = 4 + root + planes;
    add(Signal::signed("merged_zf", w), merged, "merge.zf");
    add(Signal::signed("merged_zb", w), merged, "merge.zb");
    add(Signal::unsigned("merged_nf", 4), merged, "merge.nf");
    let [zf, zb] = ["zf", "zb"].map(|name| Signal::signed(name, w));
    let normal = ["nx", "ny", "nz"].map(|name| Signal::signed(name, format.normal));
    let outputs = [zf, zb, Signal::unsigned("number", 4)];
    for port in outputs.into_iter().chain(normal) {
        let name = port.name.clone();
        add(port, 7 + root + planes, &name);
    }
    list
}
