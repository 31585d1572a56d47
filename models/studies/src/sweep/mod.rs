//! Sweeps: families of scenes in which one number goes to its extreme, each step measured against the exact picture.
//!
//! A sweep is a list of scenes built in memory from exact decimals. Every step is prepared, or refused with the message that a user would see; what is
//! drawn by the golden model is compared at every pixel with the exact reference, and the error stands beside the bound that was proven before a pixel was
//! drawn. Three rules hold at every step, or the sweep fails: no error exceeds its bound; every pixel that shows another face than the truth was
//! announced as undecided; and where the format gives out the scene is refused.

mod families;
mod grid;
mod measure;
pub mod naive;
mod page;
mod plot;
mod truth;

pub use measure::{Bounds, Figures, Observed, Ratios};
pub use page::{heading, markdown, section};
pub use plot::{PlotError, plot};

use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_prepare::prepare_for_roots;
use imogene_scene::SceneFile;
use naive::Naive;
use rayon::prelude::*;
use serde::Serialize;
use thiserror::Error;

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
    /// True if every depth word is tried, so that the one asked for has no effect.
    pub has_own_formats: bool,
    /// The scenes.
    steps: fn(Format) -> Vec<Step>,
}

/// How the parameter is plotted.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Axis {
    /// What it is, with its unit.
    pub label: &'static str,
    /// Powers of ten at equal distances.
    pub logarithmic: bool,
    /// Small values on the right: the extreme is at the right end of every plot.
    pub falling: bool,
}

impl Axis {
    const fn linear(label: &'static str) -> Axis {
        Axis {
            label,
            logarithmic: false,
            falling: false,
        }
    }

    const fn growing(label: &'static str) -> Axis {
        Axis {
            label,
            logarithmic: true,
            falling: false,
        }
    }

    const fn falling(label: &'static str) -> Axis {
        Axis {
            label,
            logarithmic: true,
            falling: true,
        }
    }
}

/// One scene of a sweep.
struct Step {
    series: usize,
    parameter: String,
    scene: SceneFile,
    /// The format, or why there is none.
    format: Result<Format, String>,
    /// Whether the same picture is also computed in floating point.
    with_naive: bool,
}

/// What a step came to; the keys are stable.
#[derive(Clone, Debug, Serialize)]
pub struct Record {
    /// Which of the sweep's series.
    pub series: &'static str,
    /// The parameter as a decimal.
    pub parameter: String,
    /// The same as a number.
    pub value: f64,
    /// The refusal, if the scene was not accepted.
    pub refused: Option<String>,
    /// What was measured, if it was.
    pub figures: Option<Figures>,
    /// What floating point makes of the same scene, where that is asked.
    pub naive: Option<Naive>,
}

/// What is said before a scene is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Notice {
    /// The preparation refuses it: no word would be right.
    Refused,
    /// It is prepared, and `imogene check` fails: a silhouette may be displaced by a pixel or more.
    CheckFails,
    /// It is prepared, and the check says that no pixel shows it.
    NothingDrawn,
}

/// Where the format gives out in a series: a run of values with one notice; the keys are stable.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct GivesOut {
    /// Which of the sweep's series.
    pub series: &'static str,
    /// In which way.
    pub by: Notice,
    /// The value before, if it was accepted and drawn.
    pub last_accepted: Option<String>,
    /// The first value with the notice.
    pub first: String,
    /// The last one.
    pub last: String,
    /// The message at the first value.
    pub message: String,
}

/// A whole sweep; the keys are stable.
#[derive(Clone, Debug, Serialize)]
pub struct SweepResult {
    /// Its name.
    pub name: &'static str,
    /// One line.
    pub title: &'static str,
    /// What it does and what it shows.
    pub about: &'static str,
    /// The parameter.
    pub axis: Axis,
    /// Depth word that was asked for; none if the sweep tries them all.
    pub depth_word: Option<u32>,
    /// The names of the series.
    pub series: &'static [&'static str],
    /// One for each step, series by series.
    pub records: Vec<Record>,
    /// Runs of values with a notice.
    pub gives_out: Vec<GivesOut>,
    /// Everything that breaks a rule; empty if all holds.
    pub violations: Vec<String>,
}

/// A name that is no sweep.
#[derive(Debug, Error, PartialEq, Eq)]
#[error("there is no sweep `{name}`; the sweeps are {names}", names = names().join(", "))]
pub struct UnknownSweep {
    /// As given.
    pub name: String,
}

/// Every sweep, in the order of the documentation.
pub fn all() -> &'static [Sweep] {
    families::ALL
}

/// Their names.
pub fn names() -> Vec<&'static str> {
    all().iter().map(|sweep| sweep.name).collect()
}

/// The sweep of a name.
pub fn find(name: &str) -> Result<&'static Sweep, UnknownSweep> {
    let found = all().iter().find(|sweep| sweep.name == name);
    found.ok_or_else(|| UnknownSweep { name: name.into() })
}

impl Sweep {
    /// The scenes in the order of the records: series, parameter and scene.
    pub fn scenes(&self, format: Format) -> Vec<(&'static str, String, SceneFile)> {
        let steps = (self.steps)(format).into_iter();
        let scene = |step: Step| (self.series[step.series], step.parameter, step.scene);
        steps.map(scene).collect()
    }

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
        let mut steps = (self.steps)(format);
        steps.retain(|step| wanted(&step.parameter));
        let records: Vec<Record> = steps
            .par_iter()
            .map(|step| {
                let record = self.record(step);
                done();
                record
            })
            .collect();
        SweepResult {
            name: self.name,
            title: self.title,
            about: self.about,
            axis: self.axis,
            depth_word: (!self.has_own_formats).then_some(format.depth),
            series: self.series,
            gives_out: gives_out(self.series, &records),
            violations: violations(&records),
            records,
        }
    }

    fn record(&self, step: &Step) -> Record {
        let (figures, refused) = match step.draw() {
            Ok(figures) => (Some(figures), None),
            Err(message) => (None, Some(message)),
        };
        Record {
            series: self.series[step.series],
            parameter: step.parameter.clone(),
            value: step.parameter.parse().expect("parameters are decimals"),
            refused,
            figures,
            naive: step.with_naive.then(|| naive::compare(&step.scene)),
        }
    }
}

impl Step {
    /// The figures, or the refusal.
    fn draw(&self) -> Result<Figures, String> {
        let format = self.format.clone()?;
        let image = self.scene.image;
        let framed = self.scene.frame(image.width, image.height);
        let framed = framed.map_err(|error| error.to_string())?;
        let prepared = prepare_for_roots(&framed, format).map_err(|error| error.to_string())?;
        Ok(measure::measure(&framed, &prepared))
    }
}

impl Record {
    /// Why nothing is drawn, or not within a pixel; none if all is well.
    pub fn notice(&self) -> Option<(Notice, String)> {
        if let Some(message) = &self.refused {
            return Some((Notice::Refused, message.clone()));
        }
        let figures = self.figures.as_ref()?;
        if let Some(message) = &figures.check_failed {
            Some((Notice::CheckFails, message.clone()))
        } else if figures.covered == 0 {
            Some((Notice::NothingDrawn, figures.problems.join("; ")))
        } else {
            None
        }
    }

    /// What notices for the same reason have in common: everything but the figures of the message.
    fn reason(&self) -> Option<(Notice, String)> {
        let (by, message) = self.notice()?;
        let words = message.chars().filter(|c| c.is_alphabetic());
        Some((by, words.collect()))
    }
}

/// The runs of records with the same notice, or with none.
fn runs<'a>(records: &[&'a Record]) -> Vec<Vec<&'a Record>> {
    let same = |a: &&Record, b: &&Record| a.reason() == b.reason();
    records.chunk_by(same).map(<[_]>::to_vec).collect()
}

fn gives_out(series: &[&'static str], records: &[Record]) -> Vec<GivesOut> {
    let mut found = vec![];
    for name in series {
        let steps: Vec<&Record> = records.iter().filter(|r| r.series == *name).collect();
        let mut before: Option<&Record> = None;
        for run in runs(&steps) {
            let (first, last) = (run[0], run[run.len() - 1]);
            if let Some((by, message)) = first.notice() {
                found.push(GivesOut {
                    series: name,
                    by,
                    last_accepted: before
                        .filter(|b| b.notice().is_none())
                        .map(|b| b.parameter.clone()),
                    first: first.parameter.clone(),
                    last: last.parameter.clone(),
                    message,
                });
            }
            before = Some(last);
        }
    }
    found
}

fn violations(records: &[Record]) -> Vec<String> {
    let of = |record: &Record| {
        let place = format!("{}, {}", record.series, record.parameter);
        let found = record.figures.iter().flat_map(|f| &f.violations);
        found.map(|v| format!("{place}: {v}")).collect::<Vec<_>>()
    };
    records.iter().flat_map(of).collect()
}
