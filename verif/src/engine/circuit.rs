//! A circuit in process, compiled or levelised, stepped with plain numbers.

use super::design::{self, Instance};
use crate::signal::Signal;
use crate::subject::Hardware;
use imogene_compiled::{Program, Simulation};
use imogene_faults::Upset;
use imogene_hdl::{self as hdl, Design, Direction, Simulator};
use std::sync::Arc;

/// A design as machine code with its outputs in their order; its instances and copies share it.
#[derive(Clone)]
pub struct Compiled {
    program: Arc<Program>,
    outputs: Arc<[Signal]>,
    /// Registers that hold other words at power-up, in every lane.
    upsets: Arc<[Upset]>,
}

impl Compiled {
    /// Compiles a design, with the points inside that will be asked for.
    /// Panics with a point that the design does not have.
    pub fn of(design: &Design, points: &[String]) -> Compiled {
        Compiled::with(design, Program::new(design, points))
    }

    /// The same, for runs side by side.
    pub fn in_lanes(design: &Design) -> Compiled {
        Compiled::with(design, Program::in_lanes(design, &[]))
    }

    fn with(design: &Design, program: Program) -> Compiled {
        let outputs = design.top.ports_of(Direction::Out);
        Compiled {
            program: Arc::new(program),
            outputs: outputs.map(Signal::of).collect(),
            upsets: Arc::default(),
        }
    }

    /// Instances of it.
    pub fn design(self) -> design::Design {
        Box::new(move || Box::new(Circuit::new(&self)))
    }

    /// The same with registers that hold other words at power-up.
    pub fn upset(&self, upsets: &[Upset]) -> Compiled {
        Compiled {
            upsets: upsets.into(),
            ..self.clone()
        }
    }
}

/// A compiled circuit, or as many side by side as its program has lanes.
pub struct Circuit {
    design: Compiled,
    simulation: Simulation,
}

impl Circuit {
    /// A fresh instance.
    pub fn new(design: &Compiled) -> Circuit {
        let mut simulation = Simulation::new(&design.program);
        for lane in 0..design.program.lanes() {
            for (register, word) in &*design.upsets {
                simulation.upset(lane, *register, *word);
            }
        }
        Circuit {
            simulation,
            design: design.clone(),
        }
    }

    /// The one module that a function builds. Panics if the circuit is refused.
    pub fn of<T>(build: impl FnOnce() -> T) -> Circuit {
        Circuit::new(&Compiled::of(&Design::of(build), &[]))
    }

    /// A clock with inputs that are 0, or as they were last set.
    pub fn idle(&mut self) {
        self.simulation.clock();
    }

    /// Does it hold what another one of the same design holds?
    pub fn is_like(&self, other: &Circuit) -> bool {
        self.simulation.is_like(&other.simulation)
    }

    /// Gives one clock with the inputs in their order, of which the low bits count.
    pub fn clock(&mut self, inputs: &[i64]) {
        self.simulation.step(&[inputs]);
    }

    /// The value of an output, by its place among them.
    pub fn output(&mut self, index: usize) -> i64 {
        self.design.outputs[index].value(self.simulation.outputs()[index])
    }

    /// The value of the output of this name. Panics if there is none.
    pub fn value(&mut self, name: &str) -> i64 {
        let mut outputs = self.design.outputs.iter();
        let found = outputs.position(|signal| signal.name == name);
        self.output(found.unwrap_or_else(|| panic!("no output `{name}`")))
    }
}

impl Instance for Circuit {
    fn clock(&mut self, inputs: &[u64], outputs: &mut [Option<u64>]) {
        self.simulation.set_all(inputs.iter().copied());
        self.simulation.clock();
        for (place, word) in outputs.iter_mut().zip(self.simulation.outputs()) {
            *place = Some(*word);
        }
    }

    fn points(&mut self, inputs: &[u64]) -> &[u64] {
        self.simulation.set_all(inputs.iter().copied());
        self.simulation.points()
    }
}

impl Hardware for Circuit {
    fn clock(&mut self, inputs: &[&[i64]]) {
        self.simulation.step(inputs);
    }

    fn outputs(&mut self, lane: usize, found: &mut Vec<Option<i64>>) {
        let lanes = self.design.program.lanes();
        let words = self.simulation.outputs()[lane..].iter().step_by(lanes);
        let outputs = self.design.outputs.iter().zip(words);
        found.clear();
        found.extend(outputs.map(|(signal, bits)| Some(signal.value(*bits))));
    }
}

/// A circuit in the simulator of `imogene-hdl`, which interprets it level by level: the check of the compiled one.
/// Memories may upset what is read while it is written.
pub fn levelised(design: Design, upsets_collisions: bool) -> design::Design {
    Box::new(move || {
        let mut simulator = Simulator::new(&design);
        if upsets_collisions {
            simulator = simulator.with_upset_collisions();
        }
        let ports = |way| {
            let ports = design.top.ports_of(way);
            ports.map(|port| simulator.port(&port.name)).collect()
        };
        let [inputs, outputs] = [Direction::In, Direction::Out].map(ports);
        Box::new(Levelised {
            inputs,
            outputs,
            simulator,
        })
    })
}

struct Levelised {
    simulator: Simulator,
    inputs: Vec<hdl::Port>,
    outputs: Vec<hdl::Port>,
}

impl Instance for Levelised {
    fn clock(&mut self, inputs: &[u64], outputs: &mut [Option<u64>]) {
        for (port, word) in self.inputs.iter().zip(inputs) {
            self.simulator.set(*port, *word);
        }
        self.simulator.clock();
        for (port, word) in self.outputs.iter().zip(outputs) {
            *word = Some(self.simulator.get(*port));
        }
    }
}
