//! Figures against those of a baseline, with a tolerance.

use crate::report::Figures;
use serde::Serialize;

/// How much worse a figure may be, in percent of the baseline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Growth of a resource.
    pub resources: f64,
    /// Fall of the clock.
    pub clock: f64,
}

/// What a change means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// The figure is that of the baseline.
    Same,
    /// Less cost or more clock, by more than the tolerance.
    Better,
    /// A change within the tolerance.
    Within,
    /// More cost or less clock, by more than the tolerance.
    Worse,
}

/// One figure beside that of the baseline.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    /// Name of the figure.
    pub measure: &'static str,
    /// In the baseline.
    pub baseline: String,
    /// Now.
    pub now: String,
    /// Change in percent of the baseline; none where one of the two is none or the baseline is 0.
    pub percent: Option<f64>,
    /// What it means.
    pub verdict: Verdict,
}

/// Compares latency and figures; the clock is left out if it was not measured this time.
pub fn compare(
    baseline: (usize, &Figures),
    now: (usize, &Figures),
    is_clock_measured: bool,
    tolerance: Tolerance,
) -> Vec<Change> {
    // Latency is part of the contract of a unit: every clock more is one too many.
    let latency = count("latency", Some(baseline.0 as u64), Some(now.0 as u64), 0.0);
    let counts = baseline.1.counts().into_iter().zip(now.1.counts());
    let counts = counts
        .filter_map(|((name, before), (_, now))| count(name, before, now, tolerance.resources));
    let clock = clock(baseline.1, now.1, tolerance.clock).filter(|_| is_clock_measured);
    latency.into_iter().chain(counts).chain(clock).collect()
}

/// The worst of several changes.
pub fn worst(changes: &[Change]) -> Verdict {
    let verdicts = changes.iter().map(|change| change.verdict);
    verdicts.max().unwrap_or(Verdict::Same)
}

fn count(
    measure: &'static str,
    baseline: Option<u64>,
    now: Option<u64>,
    tolerance: f64,
) -> Option<Change> {
    let text = |count: Option<u64>| count.map_or_else(|| "none".to_owned(), |c| c.to_string());
    let (verdict, percent) = match (baseline, now) {
        (None, None) => return None,
        (Some(before), Some(after)) => {
            let (before, after) = (before as f64, after as f64);
            (cost(before, after, tolerance), growth(before, after))
        }
        // A figure that only one side has cannot have been checked.
        _ => (Verdict::Worse, None),
    };
    Some(Change {
        measure,
        baseline: text(baseline),
        now: text(now),
        percent,
        verdict,
    })
}

fn clock(baseline: &Figures, now: &Figures, tolerance: f64) -> Option<Change> {
    let text = |figures: &Figures| match (figures.fmax_mhz, &figures.does_not_fit) {
        (Some(clock), _) => format!("{clock:.1} MHz"),
        (None, Some(excess)) => format!("does not fit ({excess})"),
        (None, None) => "none".to_owned(),
    };
    let (verdict, percent) = match (baseline.fmax_mhz, now.fmax_mhz) {
        // A clock that falls is a cost that grows.
        (Some(before), Some(after)) => (cost(-before, -after, tolerance), growth(before, after)),
        (None, None) if baseline.does_not_fit.is_some() == now.does_not_fit.is_some() => {
            baseline.does_not_fit.as_ref()?;
            (Verdict::Same, None)
        }
        (None, Some(_)) if baseline.does_not_fit.is_some() => (Verdict::Better, None),
        _ => (Verdict::Worse, None),
    };
    Some(Change {
        measure: "Fmax",
        baseline: text(baseline),
        now: text(now),
        percent,
        verdict,
    })
}

fn cost(before: f64, after: f64, tolerance: f64) -> Verdict {
    // Multiplied out, so that a change of exactly the tolerance is within it.
    let (change, limit) = ((after - before) * 100.0, tolerance * before.abs());
    if change == 0.0 {
        Verdict::Same
    } else if change > limit {
        Verdict::Worse
    } else if change < -limit {
        Verdict::Better
    } else {
        Verdict::Within
    }
}

fn growth(before: f64, after: f64) -> Option<f64> {
    (before != 0.0).then(|| (after - before) / before * 100.0)
}
