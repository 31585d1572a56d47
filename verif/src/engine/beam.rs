//! A beam machine as emitted Verilog, in any of the simulators.

use super::design::{Design, DesignError, Instance, Simulator, Source};
use super::{Engine, MachineInputs, MachineOutputs, MachineShape};
use crate::signal::Signal;
use imogene_golden::object::load::LoadWord;
use imogene_rtl::emit::Emitted;
use imogene_rtl::emit::machine::emit_machine;

/// The compiled beam machine of a shape.
pub struct BeamDesign {
    design: Box<dyn Design>,
    outputs: Vec<Signal>,
}

impl BeamDesign {
    /// Emits and compiles the machine.
    ///
    /// # Errors
    ///
    /// When the shape is out of its range, a tool is missing, or a file cannot be written.
    pub fn compile(simulator: Simulator, shape: &MachineShape) -> Result<BeamDesign, DesignError> {
        let emitted = emit_machine(&shape.request())?;
        let outputs = MachineOutputs::signals(&shape.format.widths());
        Self::of(simulator, &emitted, outputs)
    }

    /// Compiles an emitted machine with these outputs.
    ///
    /// # Errors
    ///
    /// When a tool is missing, or a file cannot be written.
    pub fn of(
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
        Ok(BeamDesign { design, outputs })
    }

    /// A fresh machine: every slot is empty.
    pub fn machine(&self) -> VerilogBeam {
        VerilogBeam {
            instance: self.design.instance(),
            outputs: self.outputs.clone(),
        }
    }
}

/// One beam machine in a simulator of Verilog, which shows its ports only.
pub struct VerilogBeam {
    instance: Box<dyn Instance>,
    outputs: Vec<Signal>,
}

impl Engine for VerilogBeam {
    fn load(&mut self, object: u8, words: &[LoadWord]) {
        for word in words {
            let words = [0, 0, 0, 1, object.into(), word.address.into(), word.bits];
            self.instance.clock(&words, &mut [None; 7]);
        }
    }

    fn clock(&mut self, inputs: &[MachineInputs], outputs: &mut [MachineOutputs]) {
        for (inputs, outputs) in inputs.iter().zip(outputs) {
            let zone = [inputs.width, inputs.height].map(u64::from);
            let words = [inputs.go.into(), zone[0], zone[1], 0, 0, 0, 0];
            let mut found = [None; 7];
            self.instance.clock(&words, &mut found);
            for ((value, signal), bits) in outputs.values.iter_mut().zip(&self.outputs).zip(found) {
                *value = bits.map(|bits| signal.value(bits));
            }
        }
    }
}
