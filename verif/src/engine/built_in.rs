//! The built-in engine: the circuits themselves as machine code, in process, no outside tool.

use super::circuit::{Circuit, Ports};
use super::{Engine, MachineInputs, MachineOutputs, MachineShape, ProbeSignal, processor_signals};
use imogene_contract::RequestError;
use imogene_golden::object::load::LoadWord;
use imogene_rtl::emit::machine::MachineRequest;
use std::array::from_fn;

/// Lanes of a beam machine: more make no step cheaper, because the words of all lanes leave the cache.
const LANES: usize = 8;

/// A beam machine in its own simulator, in lanes.
pub struct BuiltIn {
    circuit: Circuit,
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
        let inside = processor_signals(shape);
        let objects = 0..shape.objects;
        let points = objects.flat_map(|object| inside.iter().map(move |probe| path(object, probe)));
        let ports = Ports::of(&shape.request().design()?, &points.collect::<Vec<_>>());
        Ok(BuiltIn {
            circuit: Circuit::in_lanes(&ports, LANES),
            inside,
        })
    }

    /// Fresh machines that are fitted to a scene, without signals inside.
    ///
    /// # Errors
    ///
    /// When words or slots are out of their ranges.
    pub fn fitted(request: &MachineRequest) -> Result<BuiltIn, RequestError> {
        Ok(BuiltIn {
            circuit: Circuit::in_lanes(&Ports::of(&request.design()?, &[]), LANES),
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
            let bits = circuit.point(lane, &path(object, probe));
            probe.signal.value(bits)
        };
        inside.iter().map(read).collect()
    }
}

/// Where a signal inside the processor of a slot is.
fn path(object: usize, probe: &ProbeSignal) -> String {
    format!("processors_{object}.{}", probe.point)
}
