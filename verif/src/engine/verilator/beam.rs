//! A beam machine in Verilator.

use super::{Model, VerilatedUnit, VerilatorError};
use crate::engine::{Engine, MachineInputs, MachineOutputs, MachineShape};
use crate::signal::Signal;
use imogene_models::object::load::LoadWord;
use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::{EmitError, EmitRequest, emit};
use thiserror::Error;

/// Why a machine cannot be run in Verilator.
#[derive(Debug, Error)]
pub enum BeamError {
    /// The machine cannot be emitted.
    #[error(transparent)]
    Emit(#[from] EmitError),
    /// It cannot be compiled or loaded.
    #[error(transparent)]
    Verilator(#[from] VerilatorError),
}

/// The compiled beam machine of a shape.
pub struct BeamModel {
    model: Model,
    outputs: Vec<Signal>,
}

impl BeamModel {
    /// Emits and compiles the machine, or takes the library that is kept from before.
    ///
    /// # Errors
    ///
    /// When the shape is out of its range, a tool is missing, or a file cannot be written.
    pub fn compile(shape: &MachineShape) -> Result<BeamModel, BeamError> {
        let emitted = emit(&EmitRequest {
            depth_word: shape.depth_word as usize,
            planes: shape.planes,
            rows_per_stage: shape.rows_per_stage,
            objects: shape.objects,
            ..EmitRequest::new(Unit::Beam)
        })?;
        let text = emitted.bundle();
        let inputs = [
            Signal::bit("go"),
            Signal::unsigned("width", 12),
            Signal::unsigned("height", 12),
            Signal::bit("load_valid"),
            Signal::unsigned("load_object", 8),
            Signal::unsigned("load_address", 8),
            Signal::unsigned("load_data", 2 * shape.depth_word),
        ];
        let outputs = vec![
            Signal::bit("valid"),
            Signal::signed("depth", shape.depth_word),
            Signal::unsigned("id", 8),
            Signal::unsigned("number", 4),
            Signal::signed("nx", 16),
            Signal::signed("ny", 16),
            Signal::signed("nz", 16),
        ];
        let model = Model::compile(&emitted.top, &text, &inputs, &outputs)?;
        Ok(BeamModel { model, outputs })
    }

    /// A fresh machine: every slot is empty.
    pub fn machine(&self) -> VerilatedBeam {
        VerilatedBeam {
            unit: self.model.instance(),
            outputs: self.outputs.clone(),
        }
    }
}

/// One beam machine in Verilator. It shows its ports only: [`Engine::probe`] finds nothing, so that a scene is compared at the outputs.
pub struct VerilatedBeam {
    unit: VerilatedUnit,
    outputs: Vec<Signal>,
}

impl Engine for VerilatedBeam {
    fn load(&mut self, object: u8, word: &LoadWord) {
        let words = [0, 0, 0, 1, object.into(), word.address.into(), word.bits];
        self.unit.clock_words(&words, &mut [0; 7]);
    }

    fn clock(&mut self, inputs: MachineInputs) -> MachineOutputs {
        let zone = [inputs.width, inputs.height].map(u64::from);
        let mut found = [0; 7];
        let words = [inputs.go.into(), zone[0], zone[1], 0, 0, 0, 0];
        self.unit.clock_words(&words, &mut found);
        let value = |place: usize| self.outputs[place].value(found[place]);
        MachineOutputs {
            valid: found[0] == 1,
            depth: value(1),
            id: found[2] as u8,
            number: found[3] as u8,
            normal: [4, 5, 6].map(|place| value(place) as i16),
        }
    }

    fn probe(&mut self, _object: usize) -> Vec<i64> {
        Vec::new()
    }
}
