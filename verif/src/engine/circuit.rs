//! A circuit in its own simulator, stepped by hand with plain numbers.

use super::design::Instance;
use crate::signal::Signal;
use crate::subject::Clocked;
use imogene_hdl::{Design, Direction, Port, Simulator};

/// A circuit with its ports in their order, in lanes.
pub struct Circuit<const LANES: usize = 1> {
    simulator: Simulator<LANES>,
    inputs: Vec<Port>,
    outputs: Vec<(Signal, Port)>,
}

impl<const LANES: usize> Circuit<LANES> {
    /// Fresh instances of a design.
    pub fn in_lanes(design: &Design) -> Circuit<LANES> {
        let simulator = Simulator::in_lanes(design);
        let inputs = design.top.ports_of(Direction::In);
        let inputs = inputs.map(|port| simulator.port(&port.name)).collect();
        let outputs = design.top.ports_of(Direction::Out);
        let outputs = outputs.map(|port| (Signal::of(port), simulator.port(&port.name)));
        Circuit {
            inputs,
            outputs: outputs.collect(),
            simulator,
        }
    }

    /// Gives a lane its inputs in their order, of which the low bits count.
    pub fn set(&mut self, lane: usize, inputs: &[i64]) {
        for (port, value) in self.inputs.iter().zip(inputs) {
            self.simulator.set_lane(lane, *port, *value as u64);
        }
    }

    /// Gives all lanes one clock.
    pub fn step(&mut self) {
        self.simulator.clock();
    }

    /// The value of an output of a lane, by its place among them.
    pub fn output_of(&mut self, lane: usize, index: usize) -> i64 {
        let (signal, port) = &self.outputs[index];
        signal.value(self.simulator.get_lane(lane, *port))
    }

    /// The bits of a point inside a lane, as [`Simulator::point`] finds it.
    pub fn point(&mut self, lane: usize, path: &str) -> Option<u64> {
        let port = self.simulator.point(path)?;
        Some(self.simulator.get_lane(lane, port))
    }
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
        Circuit::in_lanes(design)
    }

    /// Gives one clock with the inputs in their order, of which the low bits count.
    pub fn clock(&mut self, inputs: &[i64]) {
        self.set(0, inputs);
        self.step();
    }

    /// The value of an output, by its place among them.
    pub fn output(&mut self, index: usize) -> i64 {
        self.output_of(0, index)
    }

    /// The value of the output of this name.
    ///
    /// # Panics
    ///
    /// If there is none.
    pub fn value(&mut self, name: &str) -> i64 {
        let mut outputs = self.outputs.iter();
        let found = outputs.position(|(signal, _)| signal.name == name);
        self.output(found.unwrap_or_else(|| panic!("no output `{name}`")))
    }
}

impl Instance for Circuit {
    fn clock(&mut self, inputs: &[u64], outputs: &mut [Option<u64>]) {
        for (port, word) in self.inputs.iter().zip(inputs) {
            self.simulator.set_lane(0, *port, *word);
        }
        self.step();
        for (place, (_, port)) in outputs.iter_mut().zip(&self.outputs) {
            *place = Some(self.simulator.get_lane(0, *port));
        }
    }
}

impl Clocked for Circuit {
    fn clock(&mut self, inputs: &[i64]) -> Vec<Option<i64>> {
        Circuit::clock(self, inputs);
        let outputs = 0..self.outputs.len();
        outputs.map(|index| Some(self.output(index))).collect()
    }
}
