//! One band of the screen: load, scan, compare.

use super::Options;
use super::golden::{GoldenMachine, probe_values};
use crate::engine::machine::{Machine, MachineDesign};
use crate::report::Report;
use crate::signal::Delay;
use crate::waveform::{Group, Sample, Trace};
use imogene_golden::machine::decider::Visible;
use imogene_golden::machine::frame::Frame;
use imogene_golden::object::load::{LoadWord, load_words};
use imogene_golden::object::quadric::QuadricWords;
use imogene_prepare::PreparedScene;
use std::sync::Arc;

pub(super) struct Band<'a> {
    pub scene: &'a PreparedScene,
    pub machine: &'a Arc<MachineDesign>,
    /// Clocks from `go` to the first pixel.
    pub latency: usize,
    /// The words of each slot, with as many planes as the slot has.
    pub objects: Vec<QuadricWords>,
    pub first_line: usize,
    pub lines: usize,
    pub options: &'a Options,
    /// The column and line at which the window of waveforms begins, if it has one, in a band that is traced.
    pub trace: Option<Option<(usize, usize)>>,
}

/// What a band gives: counts, the hardware's lines and the waveforms.
pub(super) type Part = (Report, Frame, Option<Trace>);

/// Values of the outputs of a beam machine: whether a pixel is there, its depth word, slot of the visible object,
/// number and normal of its visible face; `None` where the engine shows an undefined bit.
type Outputs = [Option<i64>; 7];

/// Loads a machine and runs a band on it.
pub(super) fn run(band: &Band, pixel_done: &impl Fn()) -> Part {
    let mut machine = Machine::of(band.machine);
    for object in 0..band.objects.len() {
        for word in band.load_words(object) {
            machine.clock_with(&[0, 0, 0, 1, object as u64, word.address.into(), word.bits]);
        }
    }
    let format = &band.scene.format;
    let [width, lines] = [band.scene.width.into(), band.lines as u64];
    let mut scan = Scan {
        band,
        golden: GoldenMachine::new(&band.objects, format, width as usize),
        expected: Delay::new(band.latency - 1),
        recorder: band.trace.map(|begin| Recorder::new(band, begin)),
        report: Report::default(),
        frame: Frame::background(width as usize, band.lines, format.z_max()),
    };
    for clock in 0..band.clocks() {
        machine.clock_with(&[u64::from(clock == 0), width, lines, 0, 0, 0, 0]);
        if scan.clock(clock, &mut machine) {
            pixel_done();
        }
    }
    let trace = scan.recorder.map(|recorder| recorder.trace);
    (scan.report, scan.frame, trace)
}

/// A band on its way through a machine.
struct Scan<'a> {
    band: &'a Band<'a>,
    golden: GoldenMachine,
    expected: Delay<Option<Visible>>,
    recorder: Option<Recorder>,
    report: Report,
    frame: Frame,
}

impl Scan<'_> {
    /// Compares one clock; true if the hardware gave a pixel.
    fn clock(&mut self, clock: usize, machine: &mut Machine) -> bool {
        let Scan { band, report, .. } = self;
        let outputs = &std::array::from_fn(|place| machine.at(place));
        let traced = band.trace.map(|_| band.options.traced);
        let next = (clock < band.pixels()).then(|| self.golden.pixel(traced));
        let (visible, values) = next.map_or((None, None), |(seen, values)| (Some(seen), values));
        let stated = self.expected.push(visible).flatten();
        let index = clock.wrapping_sub(band.latency - 1);
        band.score(outputs, stated, index, report);
        if let Some(recorder) = &mut self.recorder {
            let inside = machine.probe(band.options.traced);
            let golden = recorder.align(values.map(|values| probe_values(&values)));
            band.score_inside(clock, &inside.0, &golden, report);
            recorder.clock(outputs, stated, inside, golden, report);
        }
        let is_pixel = outputs[0] == Some(1) && index < band.pixels();
        if is_pixel {
            // An undefined word is a mismatch and is drawn as 0.
            let [_, depth, id, number, nx, ny, nz] = outputs.map(Option::unwrap_or_default);
            self.frame.depth[index] = depth;
            if depth != band.scene.format.z_max() {
                self.frame.id[index] = id as _;
                self.frame.number[index] = number as _;
                self.frame.normal[index] = [nx, ny, nz].map(|n| n as i16);
            }
        }
        report.cycles += 1;
        is_pixel
    }
}

impl Band<'_> {
    fn pixels(&self) -> usize {
        self.scene.width as usize * self.lines
    }

    /// Clocks from `go` to the last pixel.
    fn clocks(&self) -> usize {
        self.pixels() + self.latency - 1
    }

    /// Column and line on the screen of the pixel with this index in the band.
    fn pixel(&self, index: usize) -> (i64, i64) {
        let width = self.scene.width as usize;
        let line = self.first_line + index / width;
        ((index % width) as i64, line as i64)
    }

    /// The words of a slot, with the fault if it is there.
    fn load_words(&self, object: usize) -> Vec<LoadWord> {
        let words = &self.objects[object];
        let mut words = load_words(words, &self.scene.format, words.planes.len());
        let fault = self.options.fault;
        if let Some(fault) = fault.filter(|fault| usize::from(fault.object) == object) {
            let place = words.iter_mut().filter(|w| w.address == fault.address);
            place.for_each(|word| word.bits ^= 1 << fault.bit);
        }
        words
    }

    fn score(&self, outputs: &Outputs, stated: Option<Visible>, index: usize, report: &mut Report) {
        let pixel = stated.map(|_| self.pixel(index));
        let cycle = report.cycles;
        let outputs = self.machine.outputs.iter().zip(outputs);
        for ((signal, &hardware), golden) in outputs.zip(output_values(stated)) {
            let Some(golden) = golden else { continue };
            report.compare(cycle, pixel, &signal.name, hardware, golden);
        }
        report.pixels += u64::from(stated.is_some());
    }

    /// The inside of the traced processor counts like the outputs of the machine.
    fn score_inside(
        &self,
        clock: usize,
        inside: &[i64],
        golden: &[Option<i64>],
        report: &mut Report,
    ) {
        let (cycle, signals) = (report.cycles, &self.machine.inside);
        for ((probe, &hardware), golden) in signals.iter().zip(inside).zip(golden) {
            let Some(golden) = *golden else { continue };
            report.compare(
                cycle,
                Some(self.pixel(clock - probe.offset)),
                format_args!("processor_{}.{}", self.options.traced, probe.signal.name),
                Some(hardware),
                golden,
            );
        }
    }
}

/// What the golden machine states of the outputs: no pixel, or all of it.
fn output_values(stated: Option<Visible>) -> [Option<i64>; 7] {
    let Some(v) = stated else {
        return [Some(0), None, None, None, None, None, None];
    };
    let [nx, ny, nz] = v.normal.map(i64::from);
    [1, v.depth, v.id.into(), v.number.into(), nx, ny, nz].map(Some)
}

/// Keeps the outputs of the machine and the inside of one processor beside the golden values of the same pixel.
struct Recorder {
    trace: Trace,
    delays: Vec<Delay<Option<i64>>>,
}

impl Recorder {
    /// For a window that begins at this column and line, if there is one.
    fn new(band: &Band, begin: Option<(usize, usize)>) -> Recorder {
        let clocks = band.options.trace.as_ref().map_or(0, |trace| trace.clocks);
        let window = begin.map(|(column, line)| {
            let lines = line.saturating_sub(band.first_line);
            let from = lines * band.scene.width as usize + column;
            let last = band.clocks().saturating_sub(clocks as usize);
            let from = from.min(last) as u64;
            from..from.saturating_add(clocks)
        });
        let mut nets = band.machine.nets.clone();
        (nets.iter_mut()).for_each(|net| net.name = format!("inside.{}", net.name));
        let mut groups = vec![Group {
            name: "beam".into(),
            compared: band.machine.outputs.clone(),
            observed: nets,
            ..Group::default()
        }];
        let inside = band.machine.inside.iter();
        if inside.len() > 0 {
            groups.push(Group {
                name: format!("processor_{}", band.options.traced),
                compared: inside.clone().map(|probe| probe.signal.clone()).collect(),
                ..Group::default()
            });
        }
        Recorder {
            trace: Trace::new(groups, window.unwrap_or_default()),
            delays: inside.map(|probe| Delay::new(probe.offset)).collect(),
        }
    }

    /// The golden values that belong to the present clock, each delayed by its signal's place in the pipeline.
    fn align(&mut self, probe: Option<Vec<i64>>) -> Vec<Option<i64>> {
        let value = |k: usize| probe.as_ref().map(|values| values[k]);
        let delays = self.delays.iter_mut().enumerate();
        let aligned = delays.map(|(k, delay)| delay.push(value(k)).flatten());
        aligned.collect()
    }

    fn clock(
        &mut self,
        outputs: &Outputs,
        stated: Option<Visible>,
        (inside, nets): (Vec<i64>, Vec<Option<i64>>),
        golden: Vec<Option<i64>>,
        report: &Report,
    ) {
        let has_inside = !self.delays.is_empty();
        let samples = |_| {
            let machine = Sample {
                hardware: outputs.to_vec(),
                golden: output_values(stated).to_vec(),
                observed: nets,
                ..Sample::default()
            };
            let processor = || Sample {
                hardware: inside.into_iter().map(Some).collect(),
                golden,
                ..Sample::default()
            };
            let processor = has_inside.then(processor);
            [machine].into_iter().chain(processor).collect()
        };
        (self.trace).clock(report.cycles, report.mismatches > 0, samples);
    }
}
