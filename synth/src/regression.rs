//! Figures against those of a baseline, with a tolerance.

use crate::figures::Figures;
use serde::Serialize;

/// How much worse a figure may be, in percent of the baseline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Growth of a resource.
    pub resources: f64,
    /// Fall of the clock.
    pub clock: f64,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self {
            resources: 2.0,
            clock: 10.0,
        }
    }
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
    let latency = |clocks: usize| Some(clocks as u64);
    // Latency is part of the contract of a unit: every clock more is one too many.
    let latency = count("latency", latency(baseline.0), latency(now.0), 0.0);
    let counts = baseline.1.counts().into_iter().zip(now.1.counts());
    let counts = counts
        .filter_map(|((name, before), (_, now))| count(name, before, now, tolerance.resources));
    let clock = is_clock_measured
        .then(|| clock(baseline.1, now.1, tolerance.clock))
        .flatten();
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

#[cfg(test)]
mod tests {
    use super::Verdict::{Better, Same, Within, Worse};
    use super::*;

    fn figures() -> Figures {
        Figures {
            lut: Some(100),
            ff: Some(50),
            carry: Some(10),
            dsp: Some(0),
            bram: Some(0),
            cells: Some(150),
            transistors: None,
            fmax_mhz: Some(100.0),
            does_not_fit: None,
        }
    }

    fn changes(before: &Figures, now: &Figures) -> Vec<Change> {
        compare((3, before), (3, now), true, Tolerance::default())
    }

    fn verdicts(now: &Figures) -> Vec<(&'static str, Verdict)> {
        let changes = changes(&figures(), now).into_iter();
        let changes = changes.map(|change| (change.measure, change.verdict));
        changes.filter(|(_, verdict)| *verdict != Same).collect()
    }

    #[test]
    fn equal_figures_are_the_same() {
        let changes = changes(&figures(), &figures());
        let measures: Vec<_> = changes.iter().map(|change| change.measure).collect();
        let expected = "latency LUT FF carry DSP BRAM cells Fmax";
        assert_eq!(measures.join(" "), expected);
        assert_eq!(worst(&changes), Same);
    }

    #[test]
    fn a_figure_may_get_worse_by_its_own_tolerance_and_no_further() {
        type Changed = fn(&mut Figures);
        let cases: [(Changed, &str, Verdict); 11] = [
            (|now| now.lut = Some(102), "LUT", Within),
            (|now| now.lut = Some(103), "LUT", Worse),
            (|now| now.lut = Some(98), "LUT", Within),
            (|now| now.lut = Some(97), "LUT", Better),
            (|now| now.fmax_mhz = Some(90.0), "Fmax", Within),
            (|now| now.fmax_mhz = Some(89.999), "Fmax", Worse),
            (|now| now.fmax_mhz = Some(110.0), "Fmax", Within),
            (|now| now.fmax_mhz = Some(110.001), "Fmax", Better),
            // A figure that only one side has.
            (|now| now.cells = None, "cells", Worse),
            (|now| now.fmax_mhz = None, "Fmax", Worse),
            (
                |now| (now.fmax_mhz, now.does_not_fit) = full(),
                "Fmax",
                Worse,
            ),
        ];
        for (change, measure, verdict) in cases {
            let mut now = figures();
            change(&mut now);
            assert_eq!(verdicts(&now), [(measure, verdict)], "{now:?}");
        }
        let without = Figures {
            cells: None,
            ..figures()
        };
        assert_eq!(worst(&changes(&without, &figures())), Worse);
    }

    #[test]
    fn the_first_multiplier_is_worse_at_every_tolerance() {
        let now = Figures {
            dsp: Some(1),
            ..figures()
        };
        let all = Tolerance {
            resources: 1e6,
            clock: 1e6,
        };
        let changes = compare((3, &figures()), (3, &now), true, all);
        assert_eq!(worst(&changes), Worse);
        assert_eq!(verdicts(&now), [("DSP", Worse)]);
    }

    #[test]
    fn a_clock_more_of_latency_is_worse_and_one_less_better() {
        for (latency, verdict) in [(101, Worse), (99, Better)] {
            let now = (latency, &figures());
            let changes = compare((100, &figures()), now, true, Tolerance::default());
            assert_eq!(changes[0].verdict, verdict);
        }
    }

    /// Clock and excess of a design that does not fit.
    fn full() -> (Option<f64>, Option<String>) {
        (None, Some("9000 ICESTORM_LC of 7680".into()))
    }

    #[test]
    fn a_design_that_fits_again_is_better_and_one_that_still_does_not_the_same() {
        let (fmax_mhz, does_not_fit) = full();
        let full = Figures {
            fmax_mhz,
            does_not_fit,
            ..figures()
        };
        let back = changes(&full, &figures());
        assert_eq!(back.last().map(|c| c.verdict), Some(Better));
        assert_eq!(worst(&changes(&full, &full)), Same);
    }

    #[test]
    fn a_clock_that_was_not_measured_is_not_compared() {
        let now = Figures {
            fmax_mhz: None,
            ..figures()
        };
        let changes = compare((3, &figures()), (3, &now), false, Tolerance::default());
        assert!(changes.iter().all(|change| change.measure != "Fmax"));
    }
}
