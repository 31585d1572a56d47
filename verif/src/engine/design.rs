//! Verilog of a design, and what every engine makes of it, seen through its ports.

use super::nets::NetError;
use crate::signal::Signal;
use crate::subject::Subject;
use crate::waveform::PlaceError;
use imogene_contract::RequestError;
use imogene_tools::ToolError;
use std::path::PathBuf;
use thiserror::Error;

/// Why a design cannot be run.
#[derive(Debug, Error)]
pub enum DesignError {
    /// It cannot be emitted.
    #[error(transparent)]
    Emit(#[from] RequestError),
    /// A net is wanted that cannot be shown.
    #[error(transparent)]
    Net(#[from] NetError),
    /// A program is missing or refused the design.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// Waveforms are wanted from a place that its screen does not have.
    #[error(transparent)]
    Place(#[from] PlaceError),
    /// The library that Verilator's output was compiled to cannot be loaded.
    #[error("{}: {source}; remove the file and try again", path.display())]
    Load {
        /// Library.
        path: PathBuf,
        /// What the loader says.
        source: libloading::Error,
    },
}

/// Verilog of a design: the clock is the port `clock`, every other port has at most 64 bits.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// Name of the top module.
    pub top: &'a str,
    /// All modules.
    pub text: &'a str,
    /// Input ports without the clock.
    pub inputs: &'a [Signal],
    /// Output ports.
    pub outputs: &'a [Signal],
}

impl<'a> Source<'a> {
    /// Verilog with the ports of a subject.
    pub fn of(subject: &'a Subject, top: &'a str, text: &'a str) -> Source<'a> {
        Source {
            top,
            text,
            inputs: &subject.inputs,
            outputs: &subject.outputs,
        }
    }
}

/// A compiled design: makes any number of instances, whose registers have their initial values.
pub type Design = Box<dyn Fn() -> Box<dyn Instance> + Send + Sync>;

/// One instance of a design.
pub trait Instance: Send {
    /// One clock on raw words, one for each port in the order of the signals: inputs change while the clock is low,
    /// outputs are those after the rising edge, `None` where a bit is undefined. An unused high bit of an input must be
    /// 0.
    fn clock(&mut self, inputs: &[u64], outputs: &mut [Option<u64>]);

    /// The bits of the points inside that the design was compiled with, in their order: those before the edge that
    /// these inputs are for. None where the engine shows ports alone.
    fn points(&mut self, _inputs: &[u64]) -> &[u64] {
        &[]
    }
}
