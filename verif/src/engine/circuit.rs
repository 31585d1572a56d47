//! A circuit in its own simulator, stepped by hand with plain numbers.

use crate::signal::Signal;
use crate::subject::Hardware;
use imogene_hdl::{Design, Direction, Port, Simulator};

/// A circuit with its ports in their order.
pub struct Circuit {
    simulator: Simulator,
    inputs: Vec<Port>,
    outputs: Vec<(Signal, Port)>,
}

impl Circuit {
    /// The one module that a function builds.
    ///
    /// # Panics
    ///
    /// If the circuit is refused.
    pub fn of<T>(build: impl FnOnce() -> T) -> Circuit {
        Circuit::new(&Design::of(build))
    }

    /// A fresh instance of a design.
    pub fn new(design: &Design) -> Circuit {
        let simulator = Simulator::new(design);
        let inputs = design.top.ports_of(Direction::In);
        let inputs = inputs.map(|port| simulator.port(&port.name)).collect();
        let output = design.top.ports_of(Direction::Out).map(|port| {
            let signal = match port.signed {
                true => Signal::signed(&port.name, port.width),
                false => Signal::unsigned(&port.name, port.width),
            };
            (signal, simulator.port(&port.name))
        });
        Circuit {
            inputs,
            outputs: output.collect(),
            simulator,
        }
    }

    /// Gives one clock with the inputs in their order, of which the low bits count.
    pub fn clock(&mut self, inputs: &[i64]) {
        for (port, value) in self.inputs.iter().zip(inputs) {
            self.simulator.set(*port, *value as u64);
        }
        self.simulator.clock();
    }

    /// The value of an output, by its place among them.
    pub fn output(&mut self, index: usize) -> i64 {
        let (signal, port) = &self.outputs[index];
        signal.value(self.simulator.get(*port))
    }

    /// The bits of a point inside, as [`Simulator::point`] finds it.
    pub fn point(&mut self, path: &str) -> Option<u64> {
        let port = self.simulator.point(path)?;
        Some(self.simulator.get(port))
    }

    /// The value of the output of this name.
    ///
    /// # Panics
    ///
    /// If there is none.
    pub fn value(&mut self, name: &str) -> i64 {
        let found = self
            .outputs
            .iter()
            .position(|(signal, _)| signal.name == name);
        self.output(found.unwrap_or_else(|| panic!("no output `{name}`")))
    }
}

impl Hardware for Circuit {
    fn clock(&mut self, inputs: &[i64]) -> Vec<Option<i64>> {
        Circuit::clock(self, inputs);
        let outputs = 0..self.outputs.len();
        outputs.map(|index| Some(self.output(index))).collect()
    }
}
