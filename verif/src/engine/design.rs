//! Verilog text in a simulator, seen through its ports: the same for every simulator.

use super::icarus::IcarusDesign;
use super::verilator::Model;
use crate::signal::Signal;
use crate::subject::{Clocked, Inputs, Subject};
use std::hint::black_box;
use std::sync::Arc;

pub use super::source::{Design, DesignError, Instance, Source};

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
    ///
    /// # Errors
    ///
    /// When a tool is missing or refuses the text, or a file cannot be written.
    pub fn compile(self, source: &Source) -> Result<Box<dyn Design>, DesignError> {
        Ok(match self {
            Simulator::Icarus => Box::new(IcarusDesign::compile(source)?),
            Simulator::Verilator => Box::new(Model::compile(source)?),
        })
    }
}

/// Puts Verilog `text` (module `top`) in the place of the subject's hardware.
///
/// # Errors
///
/// As [`Simulator::compile`].
pub fn with_verilog(
    subject: Subject,
    simulator: Simulator,
    top: &str,
    text: &str,
) -> Result<Subject, DesignError> {
    let design = simulator.compile(&Source::of(&subject, top, text))?;
    let inputs: Arc<[Signal]> = subject.inputs.clone().into();
    let outputs: Arc<[Signal]> = subject.outputs.clone().into();
    Ok(Subject {
        engine: simulator.name(),
        hardware: Box::new(move || {
            Box::new(Driven {
                instance: design.instance(),
                words: vec![0; inputs.len()],
                found: vec![None; outputs.len()],
                inputs: inputs.clone(),
                outputs: outputs.clone(),
            })
        }),
        ..subject
    })
}

/// An instance whose ports are values of signals.
struct Driven {
    instance: Box<dyn Instance>,
    inputs: Arc<[Signal]>,
    outputs: Arc<[Signal]>,
    words: Vec<u64>,
    found: Vec<Option<u64>>,
}

impl Driven {
    fn drive(&mut self, inputs: &[i64]) {
        for ((word, signal), value) in self.words.iter_mut().zip(&*self.inputs).zip(inputs) {
            *word = signal.bits(*value);
        }
        self.instance.clock(&self.words, &mut self.found);
    }
}

impl Clocked for Driven {
    fn clock(&mut self, inputs: &[i64]) -> Vec<Option<i64>> {
        self.drive(inputs);
        let outputs = self.outputs.iter().zip(&self.found);
        outputs
            .map(|(signal, bits)| bits.map(|bits| signal.value(bits)))
            .collect()
    }

    fn run(&mut self, stimulus: &[Inputs]) {
        for inputs in stimulus {
            self.drive(inputs);
            black_box(&self.found);
        }
    }
}
