use imogene_synth::Figures;
use imogene_synth::regression::Verdict::{Better, Same, Within, Worse};
use imogene_synth::regression::{Change, Tolerance, Verdict, compare, worst};

/// What may be worse unless the command line says otherwise.
pub const USUAL: Tolerance = Tolerance {
    resources: 2.0,
    clock: 10.0,
};

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

fn with(change: impl Fn(&mut Figures)) -> Figures {
    let mut now = figures();
    change(&mut now);
    now
}

fn changes(before: &Figures, now: &Figures) -> Vec<Change> {
    compare((3, before), (3, now), true, USUAL)
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
        (fill, "Fmax", Worse),
    ];
    for (change, measure, verdict) in cases {
        let now = with(change);
        assert_eq!(verdicts(&now), [(measure, verdict)], "{now:?}");
    }
    let without = with(|now| now.cells = None);
    assert_eq!(worst(&changes(&without, &figures())), Worse);
}

#[test]
fn the_first_multiplier_is_worse_at_every_tolerance() {
    let now = with(|now| now.dsp = Some(1));
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
        let changes = compare((100, &figures()), now, true, USUAL);
        assert_eq!(changes[0].verdict, verdict);
    }
}

/// Clock and excess of a design that does not fit.
fn fill(now: &mut Figures) {
    now.fmax_mhz = None;
    now.does_not_fit = Some("9000 ICESTORM_LC of 7680".into());
}

#[test]
fn a_design_that_fits_again_is_better_and_one_that_still_does_not_the_same() {
    let full = with(fill);
    let back = changes(&full, &figures());
    assert_eq!(back.last().map(|c| c.verdict), Some(Better));
    assert_eq!(worst(&changes(&full, &full)), Same);
}

#[test]
fn a_clock_that_was_not_measured_is_not_compared() {
    let now = with(|now| now.fmax_mhz = None);
    let changes = compare((3, &figures()), (3, &now), false, USUAL);
    assert!(changes.iter().all(|change| change.measure != "Fmax"));
}
