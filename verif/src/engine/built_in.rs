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
    /// Signals inside a slot, and what each is called there.
    inside: Vec<(ProbeSignal, String)>,
}

/// Where the processor has the signals that are traced, if not at its ports.
const POINTS: [(&str, &str); 17] = [
    ("f2", "quadric.f2.value"),
    ("f1", "quadric.f1.value"),
    ("root", "quadric.square_root.root"),
    ("near_sum", "quadric.near_sum"),
    ("far_sum", "quadric.far_sum"),
    ("interval_zf_a", "interval.zf_a"),
    ("interval_zb_a", "interval.zb_a"),
    ("interval_zf_b", "interval.zf_b"),
    ("interval_zb_b", "interval.zb_b"),
    ("plane_#_depth", "planes_#.depth"),
    ("cut_#_zf_a", "cut_a_#.cut_zf"),
    ("cut_#_zb_a", "cut_a_#.cut_zb"),
    ("cut_#_zf_b", "cut_b_#.cut_zf"),
    ("cut_#_zb_b", "cut_b_#.cut_zb"),
    ("merged_zf", "merge.zf"),
    ("merged_zb", "merge.zb"),
    ("merged_nf", "merge.nf"),
];

/// The place of a signal within a processor.
fn point(signal: &str) -> String {
    let number = signal.split('_').find(|part| part.parse::<usize>().is_ok());
    let found = POINTS.iter().find_map(|(name, point)| {
        let number = number.unwrap_or("#");
        (name.replace('#', number) == signal).then(|| point.replace('#', number))
    });
    found.unwrap_or_else(|| signal.to_owned())
}

impl BuiltIn {
    /// Fresh machines: every slot is empty.
    ///
    /// # Errors
    ///
    /// When the shape is out of its range.
    pub fn new(shape: &MachineShape) -> Result<BuiltIn, RequestError> {
        let inside = processor_signals(shape).into_iter().map(|probe| {
            let point = point(&probe.signal.name);
            (probe, point)
        });
        Ok(BuiltIn {
            circuit: Circuit::in_lanes(&shape.request().design()?),
            inside: inside.collect(),
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
        self.inside.iter().map(|(probe, _)| probe.clone()).collect()
    }

    fn probe(&mut self, lane: usize, object: usize) -> Vec<i64> {
        let BuiltIn { circuit, inside } = self;
        let read = |(probe, point): &(ProbeSignal, String)| {
            let path = format!("processors_{object}.{point}");
            let bits = circuit.point(lane, &path);
            let bits = bits.unwrap_or_else(|| panic!("the machine has no point {path}"));
            probe.signal.value(bits)
        };
        inside.iter().map(read).collect()
    }
}
