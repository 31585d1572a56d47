//! A beam machine in any engine.

use super::circuit::Compiled;
use super::design::{Design, DesignError, Instance, Simulator, Source};
use super::{Engine, MachineInputs, MachineOutputs, MachineShape, ProbeSignal, processor_signals};
use crate::signal::Signal;
use imogene_golden::object::load::LoadWord;
use imogene_rtl::emit::Emitted;
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};

/// The compiled beam machine of a shape.
pub struct BeamDesign {
    design: Box<dyn Design>,
    outputs: Vec<Signal>,
    /// Signals inside a slot that the engine shows.
    inside: Vec<ProbeSignal>,
}

impl BeamDesign {
    /// Compiles the machine; in the built-in engine its slots show their inside.
    ///
    /// # Errors
    ///
    /// When the shape is out of its range, a tool is missing, or a file cannot be written.
    pub fn compile(engine: Engine, shape: &MachineShape) -> Result<BeamDesign, DesignError> {
        let outputs = MachineOutputs::signals(&shape.format.widths());
        match engine {
            Engine::BuiltIn => {
                let inside = processor_signals(shape);
                BeamDesign::built_in(&shape.request(), outputs, inside)
            }
            Engine::Verilog(simulator) => {
                let emitted = emit_machine(&shape.request())?;
                BeamDesign::emitted(simulator, &emitted, outputs)
            }
        }
    }

    /// Compiles a machine with these outputs for the built-in engine; each slot has these signals inside.
    ///
    /// # Errors
    ///
    /// When a number of the request is out of its range.
    pub fn built_in(
        request: &MachineRequest,
        outputs: Vec<Signal>,
        inside: Vec<ProbeSignal>,
    ) -> Result<BeamDesign, DesignError> {
        let slots = 0..request.slots.len();
        let points = slots.flat_map(|slot| inside.iter().map(move |probe| path(slot, probe)));
        let points: Vec<String> = points.collect();
        Ok(BeamDesign {
            design: Box::new(Compiled::of(&request.design()?, &points)),
            outputs,
            inside,
        })
    }

    /// Compiles an emitted machine with these outputs.
    ///
    /// # Errors
    ///
    /// When a tool is missing, or a file cannot be written.
    pub fn emitted(
        simulator: Simulator,
        emitted: &Emitted,
        outputs: Vec<Signal>,
    ) -> Result<BeamDesign, DesignError> {
        let bus = emitted.ports.iter().find(|port| port.name == "load_data");
        let inputs = [
            Signal::bit("go"),
            Signal::unsigned("width", 12),
            Signal::unsigned("height", 12),
            Signal::bit("load_valid"),
            Signal::unsigned("load_object", 8),
            Signal::unsigned("load_address", 8),
            Signal::unsigned("load_data", bus.map_or(0, |port| port.width as u32)),
        ];
        let design = simulator.compile(&Source {
            top: &emitted.top,
            text: &emitted.bundle(),
            inputs: &inputs,
            outputs: &outputs,
        })?;
        Ok(BeamDesign {
            design,
            outputs,
            inside: vec![],
        })
    }

    /// A fresh machine: every slot is empty.
    pub fn machine(&self) -> Beam<'_> {
        Beam {
            instance: self.design.instance(),
            design: self,
        }
    }
}

/// One beam machine that runs clock by clock.
pub struct Beam<'a> {
    instance: Box<dyn Instance>,
    design: &'a BeamDesign,
}

impl Beam<'_> {
    /// Writes one coefficient word; takes a clock.
    pub fn load(&mut self, object: u8, word: LoadWord) {
        let words = [0, 0, 0, 1, object.into(), word.address.into(), word.bits];
        self.instance.clock(&words, &mut [None; 7]);
    }

    /// One clock without a write.
    pub fn clock(&mut self, inputs: MachineInputs) -> MachineOutputs {
        let zone = [inputs.width, inputs.height].map(u64::from);
        let words = [inputs.go.into(), zone[0], zone[1], 0, 0, 0, 0];
        let mut found = [None; 7];
        self.instance.clock(&words, &mut found);
        let mut outputs = MachineOutputs::default();
        let places = outputs.values.iter_mut().zip(&self.design.outputs);
        for ((value, signal), bits) in places.zip(found) {
            *value = bits.map(|bits| signal.value(bits));
        }
        outputs
    }

    /// The signals inside a slot that this engine shows; none where it shows only ports.
    pub fn inside(&self) -> &[ProbeSignal] {
        &self.design.inside
    }

    /// Values of the signals of [`Beam::inside`] in one slot, after the last clock.
    pub fn probe(&mut self, slot: usize) -> Vec<i64> {
        let Beam { instance, design } = self;
        let inside = design.inside.iter();
        let values = inside.map(|probe| {
            let bits = instance.point(&path(slot, probe));
            probe.signal.value(bits.expect("the engine shows it"))
        });
        values.collect()
    }
}

/// Where a signal inside the processor of a slot is.
fn path(slot: usize, probe: &ProbeSignal) -> String {
    format!("processors_{slot}.{}", probe.point)
}
