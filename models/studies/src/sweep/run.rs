//! A sweep is run: every step is prepared, or refused, drawn and measured.

use super::family::{Rule, Step, Sweep};
use super::measure::{Figures, measure};
use super::naive;
use super::record::{Record, SweepResult, gives_out};
use imogene_golden::format::Format;
use imogene_prepare::{Framing, prepare_for_roots};
use rayon::prelude::*;

impl Sweep {
    /// Runs every step; `done` is called once for each, from any thread.
    pub fn run(&self, format: Format, done: impl Fn() + Sync) -> SweepResult {
        self.run_some(format, |_| true, done)
    }

    /// Runs the steps whose parameter is wanted.
    pub fn run_some(
        &self,
        format: Format,
        wanted: impl Fn(&str) -> bool,
        done: impl Fn() + Sync,
    ) -> SweepResult {
        let mut steps = self.steps(format);
        steps.retain(|step| wanted(&step.parameter));
        let record = |step: &Step| {
            let record = self.record(step);
            done();
            record
        };
        let records: Vec<Record> = steps.par_iter().map(record).collect();
        SweepResult {
            name: self.name,
            title: self.title,
            about: self.about,
            axis: self.axis,
            depth_word: (!self.has_own_formats()).then_some(format.depth),
            series: self.series,
            gives_out: gives_out(self.series, &records),
            violations: records.iter().flat_map(violations).collect(),
            records,
        }
    }

    fn record(&self, step: &Step) -> Record {
        let drawn = draw(step);
        let with_naive = matches!(self.rule, Rule::Naive);
        Record {
            series: self.series[step.series],
            parameter: step.parameter.clone(),
            value: step.parameter.parse().expect("parameters are decimals"),
            refused: drawn.as_ref().err().cloned(),
            figures: drawn.ok(),
            naive: with_naive.then(|| naive::compare(&step.scene)),
        }
    }
}

/// The figures, or the refusal.
fn draw(step: &Step) -> Result<Figures, String> {
    let format = step.format.clone()?;
    let image = step.scene.image;
    let framed = step.scene.frame(image.width, image.height);
    let framed = framed.map_err(|error| error.to_string())?;
    let prepared = prepare_for_roots(&framed, format).map_err(|error| error.to_string())?;
    Ok(measure(&framed, &prepared))
}

fn violations(record: &Record) -> Vec<String> {
    let found = record.figures.iter().flat_map(|f| &f.violations);
    let placed = found.map(|v| format!("{}, {}: {v}", record.series, record.parameter));
    placed.collect()
}
