//! The built-in engine: rust-hdl's own simulator, in process, no outside tool.

use super::{Engine, MachineInputs, MachineOutputs, MachineShape, ProbeSignal, processor_signals};
use imogene_models::object::load::LoadWord;
use imogene_rtl::emit::EmitError;
use imogene_rtl::simulator::{BeamInputs, BeamSimulator, beam_simulator};

/// A beam machine in rust-hdl.
pub struct RustHdl {
    simulator: Box<dyn BeamSimulator>,
    /// Where the traced signals stand among the simulator's points; found at the first probe.
    places: Vec<usize>,
    inside: Vec<ProbeSignal>,
}

impl RustHdl {
    /// A fresh machine: every slot is empty.
    pub fn new(shape: &MachineShape) -> Result<RustHdl, EmitError> {
        let simulator = beam_simulator(
            shape.depth_word as usize,
            shape.objects,
            shape.planes,
            shape.rows_per_stage,
        )?;
        Ok(RustHdl {
            simulator,
            places: Vec::new(),
            inside: processor_signals(shape),
        })
    }
}

impl Engine for RustHdl {
    fn load(&mut self, object: u8, word: &LoadWord) {
        self.simulator.load(object, word.address, word.bits);
    }

    fn clock(&mut self, inputs: MachineInputs) -> MachineOutputs {
        let outputs = self.simulator.clock(BeamInputs {
            go: inputs.go,
            width: inputs.width,
            height: inputs.height,
        });
        let [nx, ny, nz] = outputs.normal.map(i64::from);
        let (id, number) = (outputs.id.into(), outputs.number.into());
        MachineOutputs {
            values: [outputs.valid.into(), outputs.depth, id, number, nx, ny, nz].map(Some),
        }
    }

    fn inside(&self) -> Vec<ProbeSignal> {
        self.inside.clone()
    }

    fn probe(&mut self, object: usize) -> Vec<i64> {
        let points = self.simulator.probe(object);
        if self.places.is_empty() {
            let place = |probe: &ProbeSignal| {
                let name = &probe.signal.name;
                points
                    .iter()
                    .position(|p| p.name == *name)
                    .unwrap_or_else(|| panic!("the processor has no point {name}"))
            };
            self.places = self.inside.iter().map(place).collect();
        }
        self.places.iter().map(|&k| points[k].value).collect()
    }
}
