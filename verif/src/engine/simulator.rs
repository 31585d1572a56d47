//! Verilog in a simulator.

use super::design::{Design, DesignError, Source};
use super::icarus;
use super::machine::driven;
use super::verilator::Model;
use crate::subject::Subject;

/// A simulator of Verilog.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Simulator {
    /// Icarus Verilog, a process of its own: four values of a bit, no compiler of C++, slow.
    Icarus,
    /// Verilator, in process: two values of a bit, fast.
    Verilator,
}

impl Simulator {
    /// Both.
    pub const ALL: [Simulator; 2] = [Simulator::Icarus, Simulator::Verilator];

    /// Name of the engine in reports.
    pub fn name(self) -> &'static str {
        match self {
            Simulator::Icarus => "icarus",
            Simulator::Verilator => "verilator",
        }
    }

    /// Compiles a design.
    pub fn compile(self, source: &Source) -> Result<Design, DesignError> {
        match self {
            Simulator::Icarus => icarus::compile(source),
            Simulator::Verilator => Ok(Model::compile(source, ["", ""])?.design()),
        }
    }
}

/// Puts Verilog `text` (module `top`) in the place of the subject's hardware.
pub fn with_verilog(
    subject: Subject,
    simulator: Simulator,
    top: &str,
    text: &str,
) -> Result<Subject, DesignError> {
    let design = simulator.compile(&Source::of(&subject, top, text))?;
    Ok(driven(subject, simulator.name(), design))
}
