//! What a sweep is: a family of scenes with a parameter, its grid of values, and the scenes that the values make; and
//! its run: every step is prepared, or refused, drawn and measured.

use super::grid::number;
use super::measure::{Figures, measure};
use super::naive;
use super::record::{Axis, Record, SweepResult, gives_out};
use imogene_golden::format::Format;
use imogene_prepare::{Framing, prepare_for_roots};
use imogene_scene::SceneFile;
use num_rational::BigRational;
use rayon::prelude::*;

/// One family of scenes with a parameter that goes to its extreme.
pub struct Sweep {
    /// Name on the command line.
    pub name: &'static str,
    /// One line.
    pub title: &'static str,
    /// What it does and what it shows.
    pub about: &'static str,
    /// The axis of the parameter.
    pub axis: Axis,
    /// What is drawn at the same values in different ways.
    pub series: &'static [&'static str],
    /// Values of the parameter as decimals.
    pub(super) values: fn() -> Vec<String>,
    /// The scene of a series at a value.
    pub(super) scene: fn(usize, &BigRational) -> SceneFile,
    pub(super) rule: Rule,
}

/// What a sweep does otherwise than most.
pub(super) enum Rule {
    /// Nothing: every series has every value, in the format asked for.
    Plain,
    /// A series does not have every value.
    Only(fn(usize, f64) -> bool),
    /// The same picture is also computed in floating point.
    Naive,
    /// A value is a depth word, and each series has guard bits of its own: the format, or why there is none.
    Formats(fn(usize, u32) -> Result<Format, String>),
}

struct Step {
    series: usize,
    parameter: String,
    scene: SceneFile,
    /// The format, or why there is none.
    format: Result<Format, String>,
}

impl Sweep {
    /// True if every depth word is tried, so that the one asked for has no effect.
    pub fn has_own_formats(&self) -> bool {
        matches!(self.rule, Rule::Formats(_))
    }

    /// Every step, series by series.
    fn steps(&self, format: Format) -> Vec<Step> {
        let values = (self.values)();
        let of = |series: usize| {
            values.iter().filter_map(move |parameter| {
                let value = || parameter.parse().expect("parameters are decimals");
                let format = match &self.rule {
                    Rule::Only(has) if !has(series, value()) => return None,
                    Rule::Formats(format) => format(series, value() as u32),
                    _ => Ok(format),
                };
                Some(Step {
                    series,
                    parameter: parameter.clone(),
                    scene: (self.scene)(series, &number(parameter)),
                    format,
                })
            })
        };
        (0..self.series.len()).flat_map(of).collect()
    }

    /// The scenes in the order of the records: series, parameter and scene.
    pub fn scenes(&self, format: Format) -> Vec<(&'static str, String, SceneFile)> {
        let steps = self.steps(format).into_iter();
        let scene = |step: Step| (self.series[step.series], step.parameter, step.scene);
        steps.map(scene).collect()
    }

    /// Runs the steps whose parameter is wanted; `done` is called once for each, from any thread.
    pub fn run(
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
        let measured = || {
            let format = step.format.clone()?;
            let image = step.scene.image;
            let framed = step.scene.frame(image.width, image.height);
            let framed = framed.map_err(|error| error.to_string())?;
            let prepared = prepare_for_roots(&framed, format).map_err(|error| error.to_string())?;
            Ok(measure(&framed, &prepared))
        };
        let measured: Result<Figures, String> = measured();
        let with_naive = matches!(self.rule, Rule::Naive);
        Record {
            series: self.series[step.series],
            parameter: step.parameter.clone(),
            value: step.parameter.parse().expect("parameters are decimals"),
            refused: measured.as_ref().err().cloned(),
            figures: measured.ok(),
            naive: with_naive.then(|| naive::compare(&step.scene)),
        }
    }
}

fn violations(record: &Record) -> impl Iterator<Item = String> {
    let found = record.figures.iter().flat_map(|f| &f.violations);
    found.map(|v| format!("{}, {}: {v}", record.series, record.parameter))
}
