//! A beam machine in any engine.

use super::design::{DesignError, Instance};
use super::machine::MachineDesign;
use super::{Engine, ProbeSignal};
use imogene_golden::object::load::LoadWord;
use imogene_rtl::emit::machine::MachineRequest;

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
    /// Compiles a machine; each slot has these signals inside, which the built-in engine shows.
    pub fn compile(
        engine: Engine,
        request: &MachineRequest,
        mut inside: Vec<ProbeSignal>,
    ) -> Result<BeamDesign, DesignError> {
        if engine != Engine::BuiltIn {
            inside.clear();
        }
        let slots = 0..request.slots.len();
        let points = slots.flat_map(|slot| inside.iter().map(move |probe| path(slot, probe)));
        let points: Vec<String> = points.collect();
        Ok(BeamDesign {
            machine: MachineDesign::compile(engine, request, &points)?,
            engine,
            inside,
        })
    }

    /// A fresh machine: every slot is empty.
    pub fn machine(&self) -> Beam<'_> {
        Beam {
            instance: self.machine.instance(),
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

    /// One clock without a write: whether a zone starts, its pixels per line and its lines.
    pub fn clock(&mut self, [go, width, height]: [u64; 3]) -> Outputs {
        let mut found = [None; 7];
        let words = [go, width, height, 0, 0, 0, 0];
        self.instance.clock(&words, &mut found);
        let signals = &self.design.machine.outputs;
        std::array::from_fn(|k| found[k].map(|bits| signals[k].value(bits)))
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
