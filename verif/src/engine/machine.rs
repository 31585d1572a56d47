//! A machine, or a beam machine with signals inside its slots, in any engine.

use super::circuit::Compiled;
use super::design::{Design, DesignError, Instance, Source};
use super::nets::{NetError, select, values};
use super::{Engine, ProbeSignal};
use crate::signal::Signal;
use imogene_golden::object::load::LoadWord;
use imogene_hdl::{self as hdl, Direction};
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};

/// A compiled machine; makes any number of instances.
pub struct MachineDesign {
    design: Box<dyn Design>,
    /// Name of its top module.
    pub name: String,
    /// Input ports without the clock.
    pub inputs: Vec<Signal>,
    /// Output ports.
    pub outputs: Vec<Signal>,
    /// Nets inside that were wanted, by their paths: the last of the points.
    pub nets: Vec<Signal>,
}

impl MachineDesign {
    /// Compiles a machine, with the points inside that will be asked for; the built-in engine alone shows them. `nets`
    /// are paths of more of them, as [`select`] takes them.
    pub fn compile(
        engine: Engine,
        request: &MachineRequest,
        points: &[String],
        nets: &[String],
    ) -> Result<MachineDesign, DesignError> {
        let circuit = request.design()?;
        let [inputs, outputs] = ports(&circuit);
        let nets = select(&circuit.top, nets)?;
        let design = match engine {
            Engine::BuiltIn => {
                let nets = nets.iter().map(|net| &net.name);
                let points: Vec<String> = points.iter().chain(nets).cloned().collect();
                Box::new(Compiled::of(&circuit, &points))
            }
            Engine::Verilog(_) if !nets.is_empty() => return Err(NetError::Engine.into()),
            Engine::Verilog(simulator) => {
                let emitted = emit_machine(request)?;
                simulator.compile(&Source {
                    top: &emitted.top,
                    text: &emitted.bundle(),
                    inputs: &inputs,
                    outputs: &outputs,
                })?
            }
        };
        Ok(MachineDesign {
            nets,
            ..MachineDesign::of(&circuit, design)
        })
    }

    /// A circuit in something that runs it.
    pub fn of(circuit: &hdl::Design, design: Box<dyn Design>) -> MachineDesign {
        let [inputs, outputs] = ports(circuit);
        MachineDesign {
            design,
            name: circuit.top.name.clone(),
            inputs,
            outputs,
            nets: vec![],
        }
    }

    /// A fresh instance: registers have their initial values.
    pub fn instance(&self) -> Box<dyn Instance> {
        self.design.instance()
    }
}

/// Inputs and outputs of a circuit.
fn ports(circuit: &hdl::Design) -> [Vec<Signal>; 2] {
    [Direction::In, Direction::Out].map(|way| circuit.top.ports_of(way).map(Signal::of).collect())
}

/// Values of the outputs of a beam machine: whether a pixel is there, its depth word, slot of the visible object,
/// number and normal of its visible face; `None` where the engine shows an undefined bit.
pub type Outputs = [Option<i64>; 7];

/// A compiled beam machine.
pub struct BeamDesign {
    /// The machine.
    pub machine: MachineDesign,
    /// What runs it.
    pub engine: Engine,
    /// Signals inside a slot that the engine shows.
    inside: Vec<ProbeSignal>,
}

impl BeamDesign {
    /// Compiles a machine; each slot has these signals inside, which the built-in engine shows, and so are these nets.
    pub fn compile(
        engine: Engine,
        request: &MachineRequest,
        mut inside: Vec<ProbeSignal>,
        nets: &[String],
    ) -> Result<BeamDesign, DesignError> {
        if engine != Engine::BuiltIn {
            inside.clear();
        }
        let path = |slot, probe: &ProbeSignal| format!("processors_{slot}.{}", probe.point);
        let slots = 0..request.slots.len();
        let points = slots.flat_map(|slot| inside.iter().map(move |probe| path(slot, probe)));
        let points: Vec<String> = points.collect();
        Ok(BeamDesign {
            machine: MachineDesign::compile(engine, request, &points, nets)?,
            engine,
            inside,
        })
    }

    /// A fresh machine: every slot is empty.
    pub fn machine(&self) -> Beam<'_> {
        Beam {
            instance: self.machine.instance(),
            given: [0; 7],
            design: self,
        }
    }
}

/// One beam machine that runs clock by clock.
pub struct Beam<'a> {
    instance: Box<dyn Instance>,
    given: [u64; 7],
    design: &'a BeamDesign,
}

impl Beam<'_> {
    /// Writes one coefficient word; takes a clock.
    pub fn load(&mut self, object: u8, word: LoadWord) {
        let words = [0, 0, 0, 1, object.into(), word.address.into(), word.bits];
        self.instance.clock(&words, &mut [None; 7]);
    }

    /// One clock without a write: whether a zone starts, its pixels per line and its lines.
    pub fn clock(&mut self, [go, width, height]: [u64; 3]) -> Outputs {
        let mut found = [None; 7];
        self.given = [go, width, height, 0, 0, 0, 0];
        self.instance.clock(&self.given, &mut found);
        let signals = &self.design.machine.outputs;
        std::array::from_fn(|k| found[k].map(|bits| signals[k].value(bits)))
    }

    /// The signals inside a slot that this engine shows; none where it shows only ports.
    pub fn inside(&self) -> &[ProbeSignal] {
        &self.design.inside
    }

    /// Values of the signals of [`Beam::inside`] in one slot after the last clock, and of the nets of the machine.
    pub fn probe(&mut self, slot: usize) -> (Vec<i64>, Vec<Option<i64>>) {
        let BeamDesign {
            inside, machine, ..
        } = self.design;
        let points = self.instance.points(&self.given);
        let nets = points.len() - machine.nets.len();
        let own = points.iter().skip(slot * inside.len()).zip(inside);
        let own = own.map(|(bits, probe)| probe.signal.value(*bits));
        (own.collect(), values(&machine.nets, &points[nets..]))
    }
}
