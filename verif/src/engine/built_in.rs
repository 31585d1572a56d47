//! The built-in engine: the simulator of the circuits themselves, in process, no outside tool.

use super::circuit::Circuit;
use super::{Engine, MachineInputs, MachineOutputs, MachineShape, ProbeSignal, processor_signals};
use imogene_contract::RequestError;
use imogene_golden::object::load::LoadWord;
use imogene_rtl::emit::machine::MachineRequest;
use std::array::from_fn;

/// Lanes of a beam machine: more make no step cheaper, because the words of all lanes leave the cache.
const LANES: usize = 8;

/// A beam machine in its own simulator, in lanes.
pub struct BuiltIn {
    circuit: Circuit<LANES>,
    /// Signals inside a slot.
    inside: Vec<ProbeSignal>,
}

impl BuiltIn {
    /// Fresh machines: every slot is empty.
    ///
    /// # Errors
    ///
    /// When the shape is out of its range.
    pub fn new(shape: &MachineShape) -> Result<BuiltIn, RequestError> {
        Ok(BuiltIn {
            circuit: Circuit::in_lanes(&shape.request().design()?),
            inside: processor_signals(shape),
        })
    }

    /// Fresh machines that are fitted to a scene, without signals inside.
    ///
    /// # Errors
    ///
    /// When words or slots are out of their ranges.
    pub fn fitted(request: &MachineRequest) -> Result<BuiltIn, RequestError> {
        Ok(BuiltIn {
            circuit: Circuit::in_lanes(&request.design()?),
            inside: vec![],
        })
    }
}

impl Engine for BuiltIn {
    const LANES: usize = LANES;

    fn load(&mut self, object: u8, words: &[LoadWord]) {
        for (lane, word) in words.iter().enumerate() {
            let [object, address] = [object, word.address].map(i64::from);
            let inputs = [0, 0, 0, 1, object, address, word.bits as i64];
            self.circuit.set(lane, &inputs);
        }
        self.circuit.step();
    }

    fn clock(&mut self, inputs: &[MachineInputs], outputs: &mut [MachineOutputs]) {
        for (lane, inputs) in inputs.iter().enumerate() {
            let [width, height] = [inputs.width, inputs.height].map(i64::from);
            let inputs = [inputs.go.into(), width, height, 0, 0, 0, 0];
            self.circuit.set(lane, &inputs);
        }
        self.circuit.step();
        for (lane, outputs) in outputs.iter_mut().enumerate() {
            outputs.values = from_fn(|index| Some(self.circuit.output_of(lane, index)));
        }
    }

    fn inside(&self) -> Vec<ProbeSignal> {
        self.inside.clone()
    }

    fn probe(&mut self, lane: usize, object: usize) -> Vec<i64> {
        let BuiltIn { circuit, inside } = self;
        let read = |probe: &ProbeSignal| {
            let path = format!("processors_{object}.{}", probe.point);
            let bits = circuit.point(lane, &path);
            let bits = bits.unwrap_or_else(|| panic!("the machine has no point {path}"));
            probe.signal.value(bits)
        };
        inside.iter().map(read).collect()
    }
}
