//! A unit under co-simulation: its ports, its hardware and its golden model behind one interface, and the scoreboard
//! over them.

use crate::random::generator;
use crate::report::Report;
use crate::signal::Signal;
use crate::waveform::{Group, Sample, Trace};
use proptest::strategy::{BoxedStrategy, Strategy, ValueTree};
use proptest::test_runner::{Config, TestRunner};
use std::hint::black_box;
use std::time::Instant;

/// One clock's values of the input ports, in their order.
pub type Inputs = Vec<i64>;

/// A clocked design or its golden model: inputs before the edge, outputs after it. An output is `None` where the engine
/// shows an undefined bit, or where the golden model states nothing (before the first start, in an invalid clock).
pub trait Clocked: Send {
    /// One clock.
    fn clock(&mut self, inputs: &[i64]) -> Vec<Option<i64>>;

    /// So many clocks, after each of which the outputs are read and left aside.
    fn run(&mut self, stimulus: &[Inputs]) {
        for inputs in stimulus {
            black_box(self.clock(inputs));
        }
    }
}

impl<F: FnMut(&[i64]) -> Vec<Option<i64>> + Send> Clocked for F {
    fn clock(&mut self, inputs: &[i64]) -> Vec<Option<i64>> {
        self(inputs)
    }
}

/// Makes fresh instances of a design, or of its golden model.
pub type Maker = Box<dyn Fn() -> Box<dyn Clocked> + Sync>;

/// Random stimulus of about so many clocks, biased to the edges.
pub type Stimulus = Box<dyn Fn(&Subject, usize) -> BoxedStrategy<Vec<Inputs>> + Sync>;

/// A unit with both descriptions and a stimulus that reaches its edges.
pub struct Subject {
    /// Name of the unit, as in `imogene units`.
    pub name: String,
    /// Engine that runs the hardware.
    pub engine: &'static str,
    /// Input ports, without the clock.
    pub inputs: Vec<Signal>,
    /// Output ports.
    pub outputs: Vec<Signal>,
    /// A fresh instance of the hardware.
    pub hardware: Maker,
    /// A fresh instance of the golden model.
    pub golden: Maker,
    /// Random stimulus of about this many clocks, biased to the edges.
    pub stimulus: Stimulus,
    /// Clocks of a stimulus that reaches every state, where that is many.
    pub longest: usize,
    /// Clocks from an input to its result.
    pub latency: usize,
    /// Options of the command line that give this configuration.
    pub options: String,
}

impl Subject {
    /// A stimulus of about `clocks` clocks, the same for the same seed.
    pub fn seeded_stimulus(&self, clocks: usize, seed: u64) -> Vec<Inputs> {
        let mut runner = TestRunner::new_with_rng(Config::default(), generator(seed));
        (self.stimulus)(self, clocks)
            .new_tree(&mut runner)
            .expect("stimulus strategies reject nothing")
            .current()
    }

    /// Runs hardware and golden model over a stimulus and compares every output on every clock.
    ///
    /// `record` also keeps the waveforms.
    pub fn run(&self, stimulus: &[Inputs], record: bool) -> (Report, Option<Trace>) {
        let group = || Group {
            name: self.name.clone(),
            stimulus: self.inputs.clone(),
            compared: self.outputs.clone(),
            ..Group::default()
        };
        let mut trace = record.then(|| Trace::new(vec![group()], 0..u64::MAX));
        let mut cycle = 0;
        let report = self.run_each(stimulus.iter().cloned(), |sample| {
            if let Some(trace) = &mut trace {
                trace.clock(cycle, false, |_| vec![sample]);
            }
            cycle += 1;
        });
        (report, trace)
    }

    /// The same over a stimulus that is made clock by clock; `seen` takes what was compared.
    pub fn run_each(
        &self,
        stimulus: impl IntoIterator<Item = Inputs>,
        mut seen: impl FnMut(Sample),
    ) -> Report {
        let started = Instant::now();
        let mut hardware = (self.hardware)();
        let mut golden = (self.golden)();
        let mut report = Report {
            subject: self.name.clone(),
            engine: self.engine.into(),
            ..Report::default()
        };
        for inputs in stimulus {
            let sample = Sample {
                hardware: hardware.clock(&inputs),
                golden: golden.clock(&inputs),
                stimulus: inputs,
                observed: vec![],
            };
            self.score(&sample, &mut report);
            seen(sample);
            report.cycles += 1;
        }
        report.timed(started.elapsed().as_secs_f64());
        report
    }

    fn score(&self, sample: &Sample, report: &mut Report) {
        let cycle = report.cycles;
        let mut stated = false;
        for (index, golden) in sample.golden.iter().enumerate() {
            let Some(golden) = *golden else { continue };
            stated = true;
            let hardware = sample.hardware[index];
            report.compare(cycle, None, &self.outputs[index].name, hardware, golden);
        }
        report.pixels += u64::from(stated);
    }
}
