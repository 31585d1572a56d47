//! A machine in any engine, seen through its ports, with signals inside where the engine shows them.

use super::circuit::Compiled;
use super::design::{Design, DesignError, Instance, Source};
use super::nets::{NetError, select};
use super::{Engine, ProbeSignal};
use crate::signal::Signal;
use crate::subject::{Hardware, Subject};
use imogene_golden::machine::zone::beat::Beat;
use imogene_hdl::{self as hdl, Direction};
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};
use std::sync::Arc;

/// A compiled machine, or a unit; makes any number of instances.
pub struct MachineDesign {
    design: Design,
    /// Name of its top module.
    pub name: String,
    /// Input ports without the clock.
    pub inputs: Vec<Signal>,
    /// Output ports.
    pub outputs: Vec<Signal>,
    /// Signals inside each slot that the engine shows: slot by slot the first of the points.
    pub inside: Vec<ProbeSignal>,
    /// Nets inside that were wanted, by their paths: the last of the points.
    pub nets: Vec<Signal>,
}

impl MachineDesign {
    /// Compiles a machine, with these signals inside each slot and these nets, paths as [`select`] takes them. The
    /// built-in engine alone shows either: others leave out the signals and refuse nets.
    pub fn compile(
        engine: Engine,
        request: &MachineRequest,
        inside: Vec<ProbeSignal>,
        nets: &[String],
    ) -> Result<Arc<MachineDesign>, DesignError> {
        let circuit = request.design()?;
        let [inputs, outputs] = ports(&circuit);
        let nets = select(&circuit.top, nets)?;
        let (design, inside) = match engine {
            Engine::BuiltIn => {
                let slots = 0..request.slots.len();
                let path = |slot, probe: &ProbeSignal| format!("processors_{slot}.{}", probe.point);
                let own = slots.flat_map(|slot| inside.iter().map(move |probe| path(slot, probe)));
                let points = own.chain(nets.iter().map(|net| net.name.clone()));
                let points: Vec<String> = points.collect();
                (Compiled::of(&circuit, &points).design(), inside)
            }
            Engine::Verilog(_) if !nets.is_empty() => return Err(NetError::Engine.into()),
            Engine::Verilog(simulator) => {
                let emitted = emit_machine(request)?;
                let design = simulator.compile(&Source {
                    top: &emitted.top,
                    text: &emitted.bundle(),
                    inputs: &inputs,
                    outputs: &outputs,
                })?;
                (design, vec![])
            }
        };
        Ok(Arc::new(MachineDesign {
            design,
            name: circuit.top.name.clone(),
            inputs,
            outputs,
            inside,
            nets,
        }))
    }

    /// A circuit in something that runs it.
    pub fn of(circuit: &hdl::Design, design: Design) -> Arc<MachineDesign> {
        MachineDesign::with(&circuit.top.name, ports(circuit), design)
    }

    fn with(name: &str, [inputs, outputs]: [Vec<Signal>; 2], design: Design) -> Arc<MachineDesign> {
        Arc::new(MachineDesign {
            design,
            name: name.to_owned(),
            inputs,
            outputs,
            inside: vec![],
            nets: vec![],
        })
    }
}

/// Puts a design in an engine in the place of the subject's hardware.
pub(crate) fn driven(subject: Subject, engine: &'static str, design: Design) -> Subject {
    let ports = [&subject.inputs, &subject.outputs].map(Vec::clone);
    let design = MachineDesign::with(&subject.name, ports, design);
    Subject {
        engine,
        hardware: Box::new(move |_| Box::new(Machine::of(&design))),
        lanes: 1,
        ..subject
    }
}

/// Inputs and outputs of a circuit.
fn ports(circuit: &hdl::Design) -> [Vec<Signal>; 2] {
    [Direction::In, Direction::Out].map(|way| circuit.top.ports_of(way).map(Signal::of).collect())
}

/// One running machine. Inputs keep their values until set again.
pub struct Machine {
    running: Box<dyn Instance>,
    /// What it is made of.
    pub design: Arc<MachineDesign>,
    given: Vec<u64>,
    found: Vec<Option<u64>>,
    /// Clocks given.
    pub clocks: u64,
}

impl Machine {
    /// A fresh instance of a design: registers have their initial values.
    pub fn of(design: &Arc<MachineDesign>) -> Machine {
        Machine {
            running: (design.design)(),
            given: vec![0; design.inputs.len()],
            found: vec![Some(0); design.outputs.len()],
            design: design.clone(),
            clocks: 0,
        }
    }

    /// Sets an input. Panics when there is no such port.
    pub fn set(&mut self, port: &str, value: i64) {
        let place = place(&self.design.inputs, port);
        self.given[place] = self.design.inputs[place].bits(value);
    }

    /// Puts a beat on its command stream, or none.
    pub fn offer(&mut self, beat: Option<&Beat>) {
        self.set("s_tvalid", i64::from(beat.is_some()));
        if let Some(beat) = beat {
            self.set("s_tdest", beat.kind.into());
            let user = i64::from(beat.unit) << 16 | i64::from(beat.address);
            self.set("s_tuser", user);
            self.set("s_tdata", beat.data as i64);
        }
    }

    /// Place of an output, for [`Machine::at`]. Panics when there is no such port.
    pub fn output(&self, port: &str) -> usize {
        place(&self.design.outputs, port)
    }

    /// The output at a place after the last clock; `None` where the engine shows an undefined bit.
    pub fn at(&self, place: usize) -> Option<i64> {
        self.found[place].map(|bits| self.design.outputs[place].value(bits))
    }

    /// An output by its name. Panics when there is no such port.
    pub fn get(&self, port: &str) -> Option<i64> {
        self.at(self.output(port))
    }

    /// True if an output of one bit is 1.
    pub fn is_set(&self, port: &str) -> bool {
        self.get(port) == Some(1)
    }

    /// The inputs that are set for the next clock, in the order of the ports.
    pub fn inputs(&self) -> Vec<i64> {
        let given = self.design.inputs.iter().zip(&self.given);
        given.map(|(port, bits)| port.value(*bits)).collect()
    }

    /// Values of the signals inside a slot, and of the nets of the machine, before an edge with the inputs that are
    /// set; none where the engine shows only ports.
    pub fn probe(&mut self, slot: usize) -> (Vec<i64>, Vec<Option<i64>>) {
        let MachineDesign { inside, nets, .. } = &*self.design;
        let points = self.running.points(&self.given);
        let own = points.iter().skip(slot * inside.len()).zip(inside);
        let own = own.map(|(bits, probe)| probe.signal.value(*bits));
        let last = nets.iter().zip(&points[points.len() - nets.len()..]);
        let last = last.map(|(net, bits)| Some(net.value(*bits)));
        (own.collect(), last.collect())
    }

    /// One clock.
    pub fn clock(&mut self) {
        self.running.clock(&self.given, &mut self.found);
        self.clocks += 1;
    }

    /// One clock with these words on its inputs, in the order of the ports.
    pub fn clock_with(&mut self, words: &[u64]) {
        self.given.copy_from_slice(words);
        self.clock();
    }
}

impl Hardware for Machine {
    fn clock(&mut self, inputs: &[&[i64]]) {
        let given = self.given.iter_mut().zip(&self.design.inputs);
        for ((word, port), value) in given.zip(inputs[0]) {
            *word = port.bits(*value);
        }
        Machine::clock(self);
    }

    fn outputs(&mut self, _: usize, found: &mut Vec<Option<i64>>) {
        found.clear();
        found.extend((0..self.found.len()).map(|place| self.at(place)));
    }
}

/// There are a few ports, so that no table is faster.
fn place(ports: &[Signal], port: &str) -> usize {
    let place = ports.iter().position(|signal| signal.name == port);
    place.unwrap_or_else(|| panic!("no port `{port}`"))
}
