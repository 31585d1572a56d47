//! Engines of the hardware: circuits compiled or levelised in process, emitted Verilog in Icarus Verilog or Verilator.
//!
//! A unit runs behind [`Hardware`](crate::subject::Hardware), a machine behind [`Instance`](design::Instance);
//! stimulus and scoreboard are the same in every engine. [`design`] is what the simulators of Verilog have in common.

pub mod circuit;
pub mod design;
pub mod icarus;
pub mod machine;
pub mod nets;
pub mod simulator;
pub mod speed;
pub mod verilator;

use crate::signal::Signal;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::after_root;
use imogene_golden::unit::half_spaces::tree_levels;
use simulator::Simulator;

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
pub fn processor_signals(
    format: &Format,
    planes: usize,
    rows_per_stage: usize,
) -> Vec<ProbeSignal> {
    let (w, normal) = (format.depth, format.normal);
    let root = format.root_latency(rows_per_stage as u32) as usize;
    let mut list = Vec::new();
    let mut add = |name: &str, width: u32, offset: usize, point: &str| {
        let signed = !["root", "seen_number", "number"].contains(&name);
        list.push(ProbeSignal {
            signal: Signal::new(name, width, signed),
            offset,
            point: point.to_owned(),
        });
    };
    add("f2", format.pe2_width(), 1, "quadric.f2.value");
    add("f1", format.pe1_width(), 1 + root, "quadric.f1.value");
    let (width, point) = (format.root_rows(), "quadric.square_root.root");
    add("root", width, 1 + root, point);
    for name in ["near_sum", "far_sum"] {
        add(name, format.sum, 2 + root, &format!("quadric.{name}"));
    }
    // The normal takes four clocks; the limits of the planes meet the roots three clocks before it.
    let end = root + after_root(planes) as usize;
    let limits = end - 7 - tree_levels(planes) as usize;
    for i in 0..planes {
        let point = format!("planes_{i}.plane.value");
        add(&format!("plane_{i}"), format.plane, limits - 2, &point);
    }
    let depths = [("zf", w), ("zb", w), ("number", 4)];
    for (name, width) in depths {
        let [name, point] = ["seen_", "cut."].map(|of| format!("{of}{name}"));
        add(&name, width, end - 4, &point);
    }
    let normals = ["nx", "ny", "nz"].map(|name| (name, normal));
    for (name, width) in depths.into_iter().chain(normals) {
        add(name, width, end, name);
    }
    list
}
