//! What a sweep is: a family of scenes with a parameter, its grid of values, and the scenes that the values make.

use super::grid::number;
use imogene_golden::format::Format;
use imogene_scene::SceneFile;
use num_rational::BigRational;
use serde::Serialize;

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
    /// What is special.
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
    const fn of(label: &'static str, logarithmic: bool, falling: bool) -> Axis {
        Axis {
            label,
            logarithmic,
            falling,
        }
    }

    pub(super) const fn linear(label: &'static str) -> Axis {
        Axis::of(label, false, false)
    }

    pub(super) const fn growing(label: &'static str) -> Axis {
        Axis::of(label, true, false)
    }

    pub(super) const fn falling(label: &'static str) -> Axis {
        Axis::of(label, true, true)
    }
}

/// One scene of a sweep.
pub(super) struct Step {
    pub series: usize,
    pub parameter: String,
    pub scene: SceneFile,
    /// The format, or why there is none.
    pub format: Result<Format, String>,
}

impl Sweep {
    /// True if every depth word is tried, so that the one asked for has no effect.
    pub fn has_own_formats(&self) -> bool {
        matches!(self.rule, Rule::Formats(_))
    }

    /// Every step, series by series.
    pub(super) fn steps(&self, format: Format) -> Vec<Step> {
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
}
