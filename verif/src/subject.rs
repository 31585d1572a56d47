//! A unit under co-simulation: ports, hardware and golden model behind one interface, and the scoreboard over them.

use crate::report::Report;
use crate::signal::Signal;
use crate::waveform::{Group, Sample, Trace};
use proptest::strategy::BoxedStrategy;
use rayon::prelude::*;
use std::time::Instant;

/// One clock's values of the input ports, in their order.
pub type Inputs = Vec<i64>;

/// A golden model: inputs before the edge, outputs after it, `None` where nothing is stated, as in an invalid clock.
pub type Golden = Box<dyn FnMut(&[i64]) -> Vec<Option<i64>> + Send>;

/// Runs of a design side by side, at the price of one: each has its lane, and inputs and outputs of its own.
pub trait Hardware: Send {
    /// One clock of all lanes, each with its inputs; fewer than there are lanes will do.
    fn clock(&mut self, inputs: &[&[i64]]);

    /// The outputs of a lane after it, in the place of others; `None` where the engine shows an undefined bit.
    fn outputs(&mut self, lane: usize, found: &mut Vec<Option<i64>>);
}

/// Lanes of an engine that has some.
pub const LANES: usize = 8;

/// A random stimulus.
pub type Stimuli = BoxedStrategy<Vec<Inputs>>;

/// Random stimulus of about so many clocks, biased to the edges.
pub type Stimulus = Box<dyn Fn(&Subject, usize) -> Stimuli + Sync>;

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
    /// Runs of the hardware that the engine can do side by side: 1 or [`LANES`].
    pub lanes: usize,
    /// Fresh hardware for as many runs.
    pub hardware: Box<dyn Fn(usize) -> Box<dyn Hardware> + Sync>,
    /// A fresh instance of the golden model.
    pub golden: Box<dyn Fn() -> Golden + Sync>,
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
    /// Runs hardware and golden model over a stimulus and compares every output on every clock.
    ///
    /// `record` also keeps the waveforms.
    pub fn run(&self, stimulus: &[Inputs], record: bool) -> Outcome {
        let mut outcomes = self.run_all(&[stimulus], record);
        outcomes.pop().expect("of the one stimulus")
    }

    /// The same over several stimuli, each from reset; those that the engine has lanes for run side by side.
    pub fn run_all<S: AsRef<[Inputs]> + Sync>(&self, stimuli: &[S], record: bool) -> Vec<Outcome> {
        let groups = stimuli.par_chunks(self.lanes);
        let outcomes = groups.flat_map_iter(|group| self.run_group(group, record));
        outcomes.collect()
    }

    fn run_group<S: AsRef<[Inputs]>>(&self, stimuli: &[S], record: bool) -> Vec<Outcome> {
        let group = || Group {
            name: self.name.clone(),
            stimulus: self.inputs.clone(),
            compared: self.outputs.clone(),
            ..Group::default()
        };
        let trace = || record.then(|| Trace::new(vec![group()], 0..u64::MAX));
        let mut traces: Vec<Option<Trace>> = stimuli.iter().map(|_| trace()).collect();
        let each = stimuli.iter().map(|stimulus| stimulus.as_ref().iter());
        let reports = self.compare(each.collect(), |lane, cycle, seen| {
            if let Some(trace) = &mut traces[lane] {
                let sample = Sample {
                    stimulus: seen.stimulus.to_vec(),
                    hardware: seen.hardware.to_vec(),
                    golden: seen.golden.to_vec(),
                    observed: vec![],
                };
                trace.clock(cycle, false, |_| vec![sample]);
            }
        });
        reports.into_iter().zip(traces).collect()
    }

    /// The same over a stimulus that is made clock by clock; `seen` takes what was compared.
    pub fn run_each(
        &self,
        stimulus: impl IntoIterator<Item = Inputs>,
        mut seen: impl FnMut(Seen),
    ) -> Report {
        let stimuli = vec![stimulus.into_iter()];
        let mut reports = self.compare(stimuli, |_, _, clock| seen(clock));
        reports.pop().expect("of the one stimulus")
    }

    /// Runs as many stimuli as there are lanes, or fewer; `seen` takes the lane, the clock and what was compared.
    fn compare<I: Iterator<Item: AsRef<[i64]>>>(
        &self,
        stimuli: Vec<I>,
        mut seen: impl FnMut(usize, u64, Seen),
    ) -> Vec<Report> {
        let started = Instant::now();
        let mut hardware = (self.hardware)(stimuli.len());
        let run = |mut stimulus: I| Run {
            inputs: stimulus.next(),
            stimulus,
            golden: (self.golden)(),
            report: self.report(),
        };
        let mut runs: Vec<Run<I>> = stimuli.into_iter().map(run).collect();
        let nothing = vec![0; self.inputs.len()];
        let mut found = vec![];
        while runs.iter().any(|run| run.inputs.is_some()) {
            let inputs = runs.iter().map(|run| match &run.inputs {
                Some(inputs) => inputs.as_ref(),
                None => &nothing,
            });
            hardware.clock(&inputs.collect::<Vec<_>>());
            for (lane, run) in runs.iter_mut().enumerate() {
                let Some(inputs) = &run.inputs else { continue };
                hardware.outputs(lane, &mut found);
                let clock = Seen {
                    stimulus: inputs.as_ref(),
                    hardware: &found,
                    golden: &(run.golden)(inputs.as_ref()),
                };
                seen(lane, run.report.cycles, clock);
                self.score(&clock, &mut run.report);
                run.report.cycles += 1;
                run.inputs = run.stimulus.next();
            }
        }
        let seconds = started.elapsed().as_secs_f64();
        let reports = runs.into_iter().map(|mut run| {
            run.report.timed(seconds);
            run.report
        });
        reports.collect()
    }

    /// Of nothing yet.
    pub(crate) fn report(&self) -> Report {
        Report {
            subject: self.name.clone(),
            engine: self.engine.into(),
            ..Report::default()
        }
    }

    fn score(&self, clock: &Seen, report: &mut Report) {
        let cycle = report.cycles;
        let mut stated = false;
        for (index, golden) in clock.golden.iter().enumerate() {
            let Some(golden) = *golden else { continue };
            stated = true;
            let hardware = clock.hardware[index];
            report.compare(cycle, None, &self.outputs[index].name, hardware, golden);
        }
        report.pixels += u64::from(stated);
    }
}

/// A stimulus on its way through a lane, and the inputs of the next clock; none when it is over.
struct Run<I: Iterator> {
    stimulus: I,
    inputs: Option<I::Item>,
    golden: Golden,
    report: Report,
}

/// A report, and the waveforms if they were asked for.
pub type Outcome = (Report, Option<Trace>);

/// What was compared in a clock.
#[derive(Clone, Copy)]
pub struct Seen<'a> {
    /// Inputs.
    pub stimulus: &'a [i64],
    /// Outputs of the hardware.
    pub hardware: &'a [Option<i64>],
    /// What the golden model states of them.
    pub golden: &'a [Option<i64>],
}
