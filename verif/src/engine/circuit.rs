//! A circuit in process, compiled or levelised, stepped with plain numbers.

use super::design::Instance;
use crate::signal::Signal;
use crate::subject::Clocked;
use imogene_compiled::{Lanes, Port, Program};
use imogene_hdl::{self as hdl, Design, Direction, Simulator};
use std::sync::Arc;

/// A design as machine code with its ports in their order; its instances share it.
pub struct Ports {
    program: Arc<Program>,
    inputs: Vec<Port>,
    outputs: Vec<(Signal, Port)>,
}

impl Ports {
    /// Compiles a design, with the points inside that will be asked for.
    ///
    /// # Panics
    ///
    /// With a point that the design does not have.
    pub fn of(design: &Design, points: &[String]) -> Arc<Ports> {
        let program = Arc::new(Program::new(design, points));
        let ports = |direction| design.top.ports_of(direction);
        let inputs = ports(Direction::In).map(|port| program.port(&port.name));
        let outputs = ports(Direction::Out);
        let outputs = outputs.map(|port| (Signal::of(port), program.port(&port.name)));
        Arc::new(Ports {
            inputs: inputs.collect(),
            outputs: outputs.collect(),
            program,
        })
    }
}

/// A compiled circuit, in lanes.
pub struct Circuit {
    ports: Arc<Ports>,
    lanes: Lanes,
}

impl Circuit {
    /// So many fresh instances.
    pub fn in_lanes(ports: &Arc<Ports>, lanes: usize) -> Circuit {
        Circuit {
            lanes: Lanes::new(&ports.program, lanes),
            ports: ports.clone(),
        }
    }

    /// Gives a lane its inputs in their order, of which the low bits count.
    pub fn set(&mut self, lane: usize, inputs: &[i64]) {
        for (port, value) in self.ports.inputs.iter().zip(inputs) {
            self.lanes.set(lane, *port, *value as u64);
        }
    }

    /// Gives all lanes one clock.
    pub fn step(&mut self) {
        self.lanes.clock();
    }

    /// The value of an output of a lane, by its place among them.
    pub fn output_of(&mut self, lane: usize, index: usize) -> i64 {
        let (signal, port) = &self.ports.outputs[index];
        signal.value(self.lanes.get(lane, *port))
    }

    /// The bits of a point inside a lane.
    ///
    /// # Panics
    ///
    /// If it is not one of those that the design was compiled with.
    pub fn point(&mut self, lane: usize, path: &str) -> u64 {
        self.lanes.get(lane, self.ports.program.port(path))
    }

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
        Circuit::in_lanes(&Ports::of(design, &[]), 1)
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
        let mut outputs = self.ports.outputs.iter();
        let found = outputs.position(|(signal, _)| signal.name == name);
        self.output(found.unwrap_or_else(|| panic!("no output `{name}`")))
    }
}

impl Instance for Circuit {
    fn clock(&mut self, inputs: &[u64], outputs: &mut [Option<u64>]) {
        for (port, word) in self.ports.inputs.iter().zip(inputs) {
            self.lanes.set(0, *port, *word);
        }
        self.step();
        for (place, (_, port)) in outputs.iter_mut().zip(&self.ports.outputs) {
            *place = Some(self.lanes.get(0, *port));
        }
    }
}

impl Clocked for Circuit {
    fn clock(&mut self, inputs: &[i64]) -> Vec<Option<i64>> {
        Circuit::clock(self, inputs);
        let outputs = 0..self.ports.outputs.len();
        outputs.map(|index| Some(self.output(index))).collect()
    }
}

/// A circuit in the simulator of `imogene-hdl`, which interprets it level by level: the check of the compiled one.
pub struct Levelised {
    simulator: Simulator,
    inputs: Vec<hdl::Port>,
    outputs: Vec<(Signal, hdl::Port)>,
}

impl Levelised {
    /// A fresh instance of a design.
    pub fn new(design: &Design) -> Levelised {
        let simulator = Simulator::new(design);
        let inputs = design.top.ports_of(Direction::In);
        let inputs = inputs.map(|port| simulator.port(&port.name)).collect();
        let outputs = design.top.ports_of(Direction::Out);
        let outputs = outputs.map(|port| (Signal::of(port), simulator.port(&port.name)));
        Levelised {
            inputs,
            outputs: outputs.collect(),
            simulator,
        }
    }
}

impl Clocked for Levelised {
    fn clock(&mut self, inputs: &[i64]) -> Vec<Option<i64>> {
        for (port, value) in self.inputs.iter().zip(inputs) {
            self.simulator.set(*port, *value as u64);
        }
        self.simulator.clock();
        let outputs = self.outputs.iter();
        outputs
            .map(|(signal, port)| Some(signal.value(self.simulator.get(*port))))
            .collect()
    }
}
