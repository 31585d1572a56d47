//! One band of the screen: load, scan, compare.

use super::golden::{GoldenMachine, probe_values};
use super::{Fault, TraceRequest};
use crate::engine::{Engine, MachineInputs, MachineOutputs, MachineShape, ProbeSignal};
use crate::report::{Mismatch, Report};
use crate::signal::{Delay, Signal};
use crate::trace::{Group, Sample, Trace};
use imogene_models::machine::decider::Visible;
use imogene_models::machine::frame::Frame;
use imogene_models::object::load::{LoadWord, load_words};
use imogene_models::object::quadric::QuadricWords;
use imogene_models::prepare::PreparedScene;
use std::ops::Range;

/// Clocks recorded after the first mismatch, when that lies beyond the window asked for.
const AFTER_MISMATCH: u64 = 200;

/// What one band runs.
pub(super) struct Band<'a> {
    pub scene: &'a PreparedScene,
    /// Outputs of the machine.
    pub outputs: Vec<Signal>,
    /// Clocks from `go` to the first pixel.
    pub latency: usize,
    /// The words of each slot, with as many planes as the slot has.
    pub objects: Vec<QuadricWords>,
    pub first_line: usize,
    pub lines: usize,
    pub fault: Option<Fault>,
    pub trace: Option<&'a TraceRequest>,
}

/// Width of a load word of this machine, if the address exists.
pub(super) fn word_width(address: u8, shape: &MachineShape) -> Option<u32> {
    let format = &shape.format;
    let planes = 24 + 7 * shape.planes;
    match usize::from(address) {
        0..=2 => Some(format.pe1_width()),
        3..=8 => Some(format.pe2_width()),
        9..=17 => Some(format.normal_linear),
        18..=20 => Some(format.normal),
        21 | 22 => Some(24),
        23 => Some(7),
        a if a < planes => Some(match (a - 24) % 7 {
            0 => 2,
            1..=3 => format.plane,
            _ => format.normal,
        }),
        _ => None,
    }
}

impl Band<'_> {
    /// Runs the band; returns counts, the hardware's lines and the waveforms.
    pub(super) fn run(
        &self,
        engine: &mut impl Engine,
        pixel_done: &impl Fn(),
    ) -> (Report, Frame, Option<Trace>) {
        self.load(engine);
        let (width, height) = (self.scene.width as usize, self.lines);
        let pixels = width * height;
        let first_pixel = self.latency - 1;
        let traced = self.trace.map(|request| request.object);
        let mut golden = GoldenMachine::new(&self.objects, &self.scene.format, width);
        let mut expected = Delay::new(first_pixel);
        let mut recorder = self
            .trace
            .map(|request| Recorder::new(request, self, engine.inside()));
        let mut report = Report::default();
        let mut frame = Frame::background(width, height, self.scene.format.z_max());
        for clock in 0..pixels + first_pixel {
            let outputs = engine.clock(MachineInputs {
                go: clock == 0,
                width: width as u16,
                height: height as u16,
            });
            let next = (clock < pixels).then(|| golden.pixel(traced));
            let (visible, probe) = match next {
                Some((visible, probe)) => (Some(visible), probe),
                None => (None, None),
            };
            let stated = expected.push(visible).flatten();
            let index = clock.wrapping_sub(first_pixel);
            self.score(&outputs, stated, index, &mut report);
            if let Some(recorder) = &mut recorder {
                let inside = engine.probe(recorder.object);
                let golden = recorder.align(probe.map(|p| probe_values(&p)));
                self.score_inside(recorder, clock, &inside, &golden, &mut report);
                recorder.clock(&outputs, stated, inside, golden, &report);
            }
            if outputs.valid() && index < pixels {
                store(&mut frame, index, &outputs, self.scene.format.z_max());
                pixel_done();
            }
            report.cycles += 1;
        }
        (report, frame, recorder.map(|r| r.trace))
    }

    /// Column and line on the screen of the pixel with this index in the band.
    fn pixel(&self, index: usize) -> (i64, i64) {
        let width = self.scene.width as usize;
        (
            (index % width) as i64,
            (self.first_line + index / width) as i64,
        )
    }

    fn load(&self, engine: &mut impl Engine) {
        for (object, words) in self.objects.iter().enumerate() {
            for mut word in load_words(words, &self.scene.format, words.planes.len()) {
                self.inject(object, &mut word);
                engine.load(object as u8, &word);
            }
        }
    }

    fn inject(&self, object: usize, word: &mut LoadWord) {
        if let Some(fault) = self.fault
            && (usize::from(fault.object), fault.address) == (object, word.address)
        {
            word.bits ^= 1 << fault.bit;
        }
    }

    fn score(
        &self,
        outputs: &MachineOutputs,
        stated: Option<Visible>,
        index: usize,
        report: &mut Report,
    ) {
        let pixel = stated.map(|_| self.pixel(index));
        let cycle = report.cycles;
        let golden = output_values(stated);
        for ((signal, hardware), golden) in self.outputs.iter().zip(outputs.values).zip(golden) {
            let Some(golden) = golden else { continue };
            let mismatch = || Mismatch {
                cycle,
                pixel,
                signal: signal.name.clone(),
                hardware,
                golden,
            };
            report.compare(mismatch, hardware == Some(golden));
        }
        report.pixels += u64::from(stated.is_some());
    }
}

impl Band<'_> {
    /// The inside of the traced processor counts like the outputs of the machine.
    fn score_inside(
        &self,
        recorder: &Recorder,
        clock: usize,
        inside: &[i64],
        golden: &[Option<i64>],
        report: &mut Report,
    ) {
        let cycle = report.cycles;
        for ((probe, &hardware), golden) in recorder.signals.iter().zip(inside).zip(golden) {
            let Some(golden) = *golden else { continue };
            let mismatch = || Mismatch {
                cycle,
                pixel: Some(self.pixel(clock - probe.offset)),
                signal: format!("processor_{}.{}", recorder.object, probe.signal.name),
                hardware: Some(hardware),
                golden,
            };
            report.compare(mismatch, hardware == golden);
        }
    }
}

/// What the golden machine states of the outputs: no pixel, or all of it.
fn output_values(stated: Option<Visible>) -> [Option<i64>; 7] {
    let Some(v) = stated else {
        let mut none = [None; 7];
        none[0] = Some(0);
        return none;
    };
    let [nx, ny, nz] = v.normal.map(i64::from);
    [1, v.depth, v.id.into(), v.number.into(), nx, ny, nz].map(Some)
}

/// Keeps a pixel; an undefined word is a mismatch and is drawn as 0.
fn store(frame: &mut Frame, index: usize, outputs: &MachineOutputs, z_max: i64) {
    let [_, depth, id, number, nx, ny, nz] = outputs.values.map(Option::unwrap_or_default);
    frame.depth[index] = depth;
    if depth != z_max {
        frame.id[index] = id as _;
        frame.number[index] = number as _;
        frame.normal[index] = [nx, ny, nz].map(|n| n as i16);
    }
}

/// Keeps the waveforms: the machine's outputs and the inside of one processor, golden values delayed to the clock at which the
/// hardware shows the same pixel.
struct Recorder {
    trace: Trace,
    object: usize,
    window: Range<u64>,
    signals: Vec<ProbeSignal>,
    delays: Vec<Delay<Option<i64>>>,
    mismatch_seen: bool,
}

impl Recorder {
    fn new(request: &TraceRequest, band: &Band, signals: Vec<ProbeSignal>) -> Recorder {
        // The middle line of the traced object.
        let line = super::middle_line(&band.objects[request.object]) as u64;
        let from = line * u64::from(band.scene.width);
        let mut groups = vec![Group {
            name: "beam".into(),
            stimulus: vec![],
            compared: band.outputs.clone(),
        }];
        if !signals.is_empty() {
            groups.push(Group {
                name: format!("processor_{}", request.object),
                stimulus: vec![],
                compared: signals.iter().map(|s| s.signal.clone()).collect(),
            });
        }
        Recorder {
            trace: Trace::new(groups),
            object: request.object,
            window: from..from + request.clocks,
            delays: signals.iter().map(|s| Delay::new(s.offset)).collect(),
            signals,
            mismatch_seen: false,
        }
    }

    /// The golden values that belong to the present clock, each delayed by its signal's place in the pipeline.
    fn align(&mut self, probe: Option<Vec<i64>>) -> Vec<Option<i64>> {
        self.delays
            .iter_mut()
            .enumerate()
            .map(|(k, delay)| delay.push(probe.as_ref().map(|values| values[k])).flatten())
            .collect()
    }

    fn clock(
        &mut self,
        outputs: &MachineOutputs,
        stated: Option<Visible>,
        inside: Vec<i64>,
        golden: Vec<Option<i64>>,
        report: &Report,
    ) {
        if report.mismatches > 0 && !self.mismatch_seen {
            self.mismatch_seen = true;
            let end = report.cycles + AFTER_MISMATCH;
            self.window = self.window.start.min(report.cycles)..self.window.end.max(end);
        }
        let machine = Sample {
            stimulus: vec![],
            hardware: outputs.values.to_vec(),
            golden: output_values(stated).to_vec(),
        };
        let mut samples = vec![machine];
        if !self.signals.is_empty() {
            samples.push(Sample {
                stimulus: vec![],
                hardware: inside.into_iter().map(Some).collect(),
                golden,
            });
        }
        if self.window.contains(&report.cycles) {
            self.trace.record(report.cycles, samples);
        } else {
            self.trace.remember(report.cycles, samples);
        }
    }
}
