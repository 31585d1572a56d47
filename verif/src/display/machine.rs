//! A machine in any engine, seen through its ports.

use crate::engine::Engine;
use crate::engine::circuit::Compiled;
use crate::engine::design::{Design as _, DesignError, Instance, Source};
use crate::signal::Signal;
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};
use imogene_rtl::emit::{Direction, Port};

/// One running machine. Inputs keep their values until set again.
pub struct Machine {
    running: Box<dyn Instance>,
    inputs: Vec<Signal>,
    outputs: Vec<Signal>,
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
    pub fn start(request: &MachineRequest, engine: Engine) -> Result<Machine, DesignError> {
        let emitted = emit_machine(request)?;
        let of = |direction| {
            let ports = emitted.ports.iter();
            let of = |port: &&Port| port.direction == direction && port.name != "clock";
            ports.filter(of).map(signal).collect::<Vec<_>>()
        };
        let (inputs, outputs) = (of(Direction::In), of(Direction::Out));
        let running: Box<dyn Instance> = match engine {
            Engine::BuiltIn => Compiled::of(&request.design()?, &[]).instance(),
            Engine::Verilog(simulator) => {
                let source = Source {
                    top: &emitted.top,
                    text: &emitted.bundle(),
                    inputs: &inputs,
                    outputs: &outputs,
                };
                simulator.compile(&source)?.instance()
            }
        };
        Ok(Machine {
            running,
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
        let place = place(&self.inputs, port);
        self.given[place] = self.inputs[place].bits(value);
    }

    /// An output after the last clock; `None` where the engine shows an undefined bit.
    ///
    /// # Panics
    ///
    /// When there is no such port.
    pub fn get(&self, port: &str) -> Option<i64> {
        let place = place(&self.outputs, port);
        self.found[place].map(|bits| self.outputs[place].value(bits))
    }

    /// True if an output of one bit is 1.
    pub fn is_set(&self, port: &str) -> bool {
        self.get(port) == Some(1)
    }

    /// One clock.
    pub fn clock(&mut self) {
        self.running.clock(&self.given, &mut self.found);
        self.clocks += 1;
    }
}

/// There are a few ports, so that no table is faster.
fn place(ports: &[Signal], port: &str) -> usize {
    let place = ports.iter().position(|signal| signal.name == port);
    place.unwrap_or_else(|| panic!("no port `{port}`"))
}

fn signal(port: &Port) -> Signal {
    Signal {
        name: port.name.clone(),
        width: port.width as u32,
        signed: port.signed,
    }
}
