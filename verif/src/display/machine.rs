//! A machine in any engine, seen through its ports.

use crate::engine::BUILT_IN;
use crate::engine::circuit::Circuit;
use crate::engine::design::{Design, DesignError, Instance, Simulator, Source};
use crate::signal::Signal;
use imogene_contract::RequestError;
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};
use imogene_rtl::emit::{Direction, Port};
use std::collections::HashMap;
use thiserror::Error;

/// What runs the hardware.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DisplayEngine {
    /// The built-in simulator, in process.
    BuiltIn,
    /// The emitted Verilog.
    Verilog(Simulator),
}

/// Why a machine cannot be run.
#[derive(Debug, Error)]
pub enum DisplayError {
    /// It cannot be emitted.
    #[error(transparent)]
    Emit(#[from] RequestError),
    /// It cannot be compiled or loaded.
    #[error(transparent)]
    Design(#[from] DesignError),
}

impl DisplayEngine {
    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self {
            DisplayEngine::BuiltIn => BUILT_IN,
            DisplayEngine::Verilog(simulator) => simulator.name(),
        }
    }
}

enum Running {
    BuiltIn(Box<Circuit>),
    Verilog(Box<dyn Instance>),
}

/// One running machine. Inputs keep their values until set again.
pub struct Machine {
    running: Running,
    inputs: Vec<Signal>,
    outputs: Vec<Signal>,
    places: HashMap<String, usize>,
    given: Vec<u64>,
    found: Vec<Option<u64>>,
    /// Name of its top module.
    pub name: String,
    /// Clocks given.
    pub clocks: u64,
}

impl Machine {
    /// Builds, and if the engine wants it compiles, a machine.
    ///
    /// # Errors
    ///
    /// When a number of the request is out of its range, a tool is missing, or a file cannot be written.
    pub fn start(request: &MachineRequest, engine: DisplayEngine) -> Result<Machine, DisplayError> {
        let emitted = emit_machine(request)?;
        let of = |direction| {
            let ports = emitted
                .ports
                .iter()
                .filter(move |p| p.direction == direction);
            ports
                .filter(|port| port.name != "clock")
                .map(signal)
                .collect::<Vec<_>>()
        };
        let (inputs, outputs) = (of(Direction::In), of(Direction::Out));
        let running = match engine {
            DisplayEngine::BuiltIn => Running::BuiltIn(Box::new(Circuit::new(&request.design()?))),
            DisplayEngine::Verilog(simulator) => {
                let design: Box<dyn Design> = simulator.compile(&Source {
                    top: &emitted.top,
                    text: &emitted.bundle(),
                    inputs: &inputs,
                    outputs: &outputs,
                })?;
                Running::Verilog(design.instance())
            }
        };
        let place = |signals: &[Signal]| {
            let names = signals.iter().enumerate();
            names
                .map(|(place, s)| (s.name.clone(), place))
                .collect::<Vec<_>>()
        };
        Ok(Machine {
            running,
            places: [place(&inputs), place(&outputs)]
                .concat()
                .into_iter()
                .collect(),
            given: vec![0; inputs.len()],
            found: vec![Some(0); outputs.len()],
            inputs,
            outputs,
            name: emitted.top,
            clocks: 0,
        })
    }

    /// Sets an input.
    ///
    /// # Panics
    ///
    /// When there is no such port.
    pub fn set(&mut self, port: &str, value: i64) {
        let place = self.places[port];
        self.given[place] = self.inputs[place].bits(value);
    }

    /// An output after the last clock; `None` where the engine shows an undefined bit.
    ///
    /// # Panics
    ///
    /// When there is no such port.
    pub fn get(&self, port: &str) -> Option<i64> {
        let place = self.places[port];
        self.found[place].map(|bits| self.outputs[place].value(bits))
    }

    /// True if an output of one bit is 1.
    pub fn is_set(&self, port: &str) -> bool {
        self.get(port) == Some(1)
    }

    /// One clock.
    pub fn clock(&mut self) {
        match &mut self.running {
            Running::BuiltIn(circuit) => {
                let given: Vec<i64> = self.given.iter().map(|bits| *bits as i64).collect();
                circuit.clock(&given);
                for (index, signal) in self.outputs.iter().enumerate() {
                    self.found[index] = Some(signal.bits(circuit.output(index)));
                }
            }
            Running::Verilog(instance) => instance.clock(&self.given, &mut self.found),
        }
        self.clocks += 1;
    }
}

fn signal(port: &Port) -> Signal {
    Signal {
        name: port.name.clone(),
        width: port.width as u32,
        signed: port.signed,
    }
}
