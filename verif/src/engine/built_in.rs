//! The built-in engine: the simulator of the circuits themselves, in process, no outside tool.

use super::{Engine, MachineInputs, MachineOutputs, MachineShape, ProbeSignal, processor_signals};
use crate::signal::Signal;
use imogene_hdl::{Port, Simulator};
use imogene_models::object::load::LoadWord;
use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::{EmitError, EmitRequest, design};

/// A beam machine in its own simulator.
pub struct BuiltIn {
    simulator: Simulator,
    /// `go`, `width`, `height`, and the load bus.
    inputs: [Port; 7],
    outputs: Vec<(Signal, Port)>,
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
    /// A fresh machine: every slot is empty.
    ///
    /// # Errors
    ///
    /// When the shape is out of its range.
    pub fn new(shape: &MachineShape) -> Result<BuiltIn, EmitError> {
        let request = EmitRequest {
            depth_word: shape.depth_word as usize,
            planes: shape.planes,
            rows_per_stage: shape.rows_per_stage,
            objects: shape.objects,
            ..EmitRequest::new(Unit::Beam)
        };
        let simulator = Simulator::new(&design(&request)?);
        let inputs = [
            "go",
            "width",
            "height",
            "load_valid",
            "load_object",
            "load_address",
            "load_data",
        ];
        let outputs = MachineOutputs::signals(shape.depth_word).into_iter();
        let inside = processor_signals(shape).into_iter().map(|probe| {
            let point = point(&probe.signal.name);
            (probe, point)
        });
        Ok(BuiltIn {
            inputs: inputs.map(|name| simulator.port(name)),
            outputs: outputs
                .map(|signal| {
                    let port = simulator.port(&signal.name);
                    (signal, port)
                })
                .collect(),
            inside: inside.collect(),
            simulator,
        })
    }

    fn step(&mut self, words: [u64; 7]) {
        for (port, word) in self.inputs.iter().zip(words) {
            self.simulator.set(*port, word);
        }
        self.simulator.clock();
    }
}

impl Engine for BuiltIn {
    fn load(&mut self, object: u8, word: &LoadWord) {
        self.step([0, 0, 0, 1, object.into(), word.address.into(), word.bits]);
    }

    fn clock(&mut self, inputs: MachineInputs) -> MachineOutputs {
        let [width, height] = [inputs.width, inputs.height].map(u64::from);
        self.step([inputs.go.into(), width, height, 0, 0, 0, 0]);
        let mut outputs = MachineOutputs::default();
        for (value, (signal, port)) in outputs.values.iter_mut().zip(&self.outputs) {
            *value = Some(signal.value(self.simulator.get(*port)));
        }
        outputs
    }

    fn inside(&self) -> Vec<ProbeSignal> {
        self.inside.iter().map(|(probe, _)| probe.clone()).collect()
    }

    fn probe(&mut self, object: usize) -> Vec<i64> {
        let BuiltIn {
            simulator, inside, ..
        } = self;
        let read = |(probe, point): &(ProbeSignal, String)| {
            let path = format!("processors_{object}.{point}");
            let found = simulator.point(&path);
            let port = found.unwrap_or_else(|| panic!("the machine has no point {path}"));
            probe.signal.value(simulator.get(port))
        };
        inside.iter().map(read).collect()
    }
}
