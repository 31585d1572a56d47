//! Waveforms of a machine: its bus and its pins, where in the picture it is, and nets inside.
//!
//! A clock shows what the next rising edge meets: the outputs since the last edge, and the inputs set for the next.

use crate::engine::machine::Machine;
use crate::signal::Signal;
use crate::waveform::{Group, Place, Sample, Trace, WaveformRequest, WindowStart};

/// Where a machine is in its pictures.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Spot {
    /// Frame, counted from 1; 0 before the first.
    pub frame: u32,
    /// It shows a scene.
    pub is_scene: bool,
    /// Column and line, where there is a pixel.
    pub pixel: Option<(usize, usize)>,
}

impl Spot {
    fn is_at(&self, place: &Place) -> bool {
        let is_frame = place
            .frame
            .map_or(self.is_scene, |frame| frame == self.frame);
        is_frame && self.pixel == Some((place.column, place.line))
    }

    /// The values of [`SPOT`].
    fn values(&self) -> [Option<i64>; 3] {
        let (column, line) = self.pixel.unzip();
        let [column, line] = [column, line].map(|n| n.map(|n| n as i64));
        [Some(self.frame.into()), column, line]
    }
}

/// The signals of a [`Spot`], and their bits.
const SPOT: [(&str, u32); 3] = [
    ("place.frame", 32),
    ("place.column", 16),
    ("place.line", 16),
];

pub(super) struct Waves {
    trace: Trace,
    clocks: u64,
    /// Where the window begins, until it has begun.
    awaited: Option<Place>,
    /// Nets inside are read on every clock, in case a mismatch follows: most of the time of a run that has many.
    reads_ahead: bool,
    /// Places among the outputs of those that are compared, and of the others.
    compared: Vec<usize>,
    others: Vec<usize>,
}

impl Waves {
    /// Of a machine of whose outputs some are compared.
    pub(super) fn new(request: &WaveformRequest, hardware: &Machine, compared: &[&str]) -> Waves {
        let outputs = &hardware.design.outputs;
        let named = |place: &usize| compared.contains(&outputs[*place].name.as_str());
        let others: Vec<usize> = (0..outputs.len()).filter(|place| !named(place)).collect();
        let compared: Vec<usize> = compared.iter().map(|name| hardware.output(name)).collect();
        let within = |scope: &str, signal: &Signal| Signal {
            name: format!("{scope}.{}", signal.name),
            ..*signal
        };
        let spot = SPOT.map(|(name, width)| Signal::new(name, width, false));
        let plain = others.iter();
        let plain = plain.map(|place| within("outputs", &outputs[*place]));
        let nets = hardware.design.nets.iter();
        let nets = nets.map(|net| within("inside", net));
        let shown = compared.iter().map(|place| outputs[*place].clone());
        let group = Group {
            name: hardware.design.name.clone(),
            stimulus: hardware.design.inputs.clone(),
            compared: shown.collect(),
            observed: spot.into_iter().chain(plain).chain(nets).collect(),
        };
        let (window, awaited) = match request.from {
            WindowStart::Usual => (0..request.clocks, None),
            WindowStart::At(place) => (0..0, Some(place)),
            WindowStart::Mismatch => (0..0, None),
        };
        Waves {
            trace: Trace::new(vec![group], window),
            clocks: request.clocks,
            awaited,
            reads_ahead: request.from == WindowStart::Mismatch,
            compared,
            others,
        }
    }

    /// Takes the next clock: where the machine is, what the compared outputs should be, and whether one has differed.
    pub(super) fn clock(
        &mut self,
        hardware: &mut Machine,
        spot: &Spot,
        golden: &[Option<i64>],
        differs: bool,
    ) {
        let clock = hardware.clocks;
        if self.awaited.is_some_and(|place| spot.is_at(&place)) {
            self.awaited = None;
            self.trace.open(clock..clock.saturating_add(self.clocks));
        }
        let (compared, others) = (&self.compared, &self.others);
        let reads_ahead = self.reads_ahead;
        self.trace.clock(clock, differs, |is_recorded| {
            let found = |places: &[usize]| -> Vec<_> {
                places.iter().map(|place| hardware.at(*place)).collect()
            };
            let (compared, others) = (found(compared), found(others));
            let nets = match is_recorded || reads_ahead {
                true => hardware.probe(0).1,
                false => vec![],
            };
            vec![Sample {
                stimulus: hardware.inputs(),
                hardware: compared,
                golden: golden.to_vec(),
                observed: [&spot.values()[..], &others, &nets].concat(),
            }]
        });
    }

    /// What was kept; `None` if no clock was.
    pub(super) fn finish(self) -> Option<Trace> {
        Some(self.trace).filter(|trace| !trace.is_empty())
    }
}
