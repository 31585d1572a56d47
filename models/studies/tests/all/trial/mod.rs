//! The trial itself is tried: its own rounding and bounds are those of the preparation, everything is compared exactly
//! on smaller runs, and a bound that is too small is found.

mod exact;

use imogene_algebra::rational::{from_f64_exact, integer, power_of_two};
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_prepare::forms::{LinearForm, QuadraticForm};
use imogene_prepare::rounding::{linear_error, quadratic_error, round_linear, round_quadratic};
use imogene_studies::trial::case::Case;
use imogene_studies::trial::random::Random;
use imogene_studies::trial::tally::{Tally, Term};
use imogene_studies::trial::{FORMATS, TrialReport, place, places, run};
use imogene_testkit::is_full;
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;

fn of(widths: &MachineWords) -> Format {
    Format::fitted(widths).expect("a format")
}

fn formats() -> impl Iterator<Item = Format> {
    FORMATS.iter().map(of)
}

/// Tries every format and expects no violation; returns the reports.
fn tried(cases: u64, seed: u64, always_exactly: bool) -> Vec<TrialReport> {
    let run = |format: Format| run(&format, cases, seed, always_exactly, |_| ());
    let reports: Vec<TrialReport> = formats().map(run).collect();
    for report in &reports {
        let (label, first) = (report.label(), &report.tally.first_violations);
        assert_eq!(report.tally.violations, 0, "{label}: {first:?}");
        assert_eq!(report.cases, cases);
    }
    reports
}

#[test]
fn no_bound_is_exceeded_and_the_dominating_ones_are_tight() {
    // The million of the documentation is run by the command line's tests.
    let cases = if is_full() { 20_000 } else { 10_000 };
    for report in tried(cases, 4, false) {
        for t in &report.terms {
            let (fared, name) = (&t.fared, t.term.name());
            println!("{} | {name}: {fared:?}", report.label());
            let unused = t.term == Term::Truncation && report.guard_linear == 0;
            assert!(t.fared.tightness > 0.5 || unused, "{:?}", t.term);
        }
    }
}

#[test]
fn everything_compared_exactly() {
    let cases = if is_full() { 3_000 } else { 300 };
    for report in tried(cases, 2, true) {
        assert_eq!(report.tally.decided_exactly, report.tally.comparisons);
    }
}

fn exact_forms(case: &Case) -> (LinearForm, QuadraticForm) {
    let (f1, f2) = (case.f1.form(), case.f2.form());
    let unit = |guards: u32| power_of_two(guards).recip();
    let centred = LinearForm::of_array(f1).scaled(&unit(case.format.guard_linear));
    let centred2 = QuadraticForm::of_array(f2).scaled(&unit(case.format.guard_quadratic));
    let (x, y) = (integer(-case.anchor.x), integer(-case.anchor.y));
    (centred.about(&x, &y), centred2.about(&x, &y))
}

/// Equal up to the rounding upwards of a few operations.
fn assert_just_above(bound: f64, exact: &BigRational) {
    let above = from_f64_exact(bound);
    assert!(above >= *exact, "{bound} below");
    let slack = from_f64_exact(1.0 + 1e-14);
    assert!(above <= exact * slack, "{bound} too far above");
}

proptest! {
    /// The trial's 128-bit rounding and residual bounds are those of the preparation, in big rationals on the screen's
    /// coordinates.
    #[test]
    fn cases_are_rounded_and_bounded_as_the_preparation_does(seed in any::<u64>(), which in 0usize..FORMATS.len()) {
        let format = of(&FORMATS[which]);
        let case = Case::draw(&format, &mut Random::of_case(seed, 0));
        let (f1, f2) = exact_forms(&case);
        let (g1, g2) = (format.guard_linear, format.guard_quadratic);
        let window = case.words.screen_box;
        let word1 = round_linear(&f1.scaled(&power_of_two(g1)), case.anchor).expect("fits");
        let word2 = round_quadratic(&f2.scaled(&power_of_two(g2)), case.anchor).expect("fits");
        prop_assert_eq!(word1, case.words.f1);
        prop_assert_eq!(word2, case.words.f2);
        assert_just_above(case.bounds.f1, &linear_error(&word1, &f1, g1, &window));
        assert_just_above(case.bounds.f2, &quadratic_error(&word2, &f2, g2, &window));
    }

    /// What the preparation would refuse is not tried: f2, and f1 with the root, stay within their words on the whole
    /// box.
    #[test]
    fn cases_fit_their_words(seed in any::<u64>(), which in 0usize..FORMATS.len()) {
        let format = of(&FORMATS[which]);
        let case = Case::draw(&format, &mut Random::of_case(seed, 1));
        let window = case.words.screen_box;
        let unit = |guards: u32| power_of_two(guards).recip();
        let f2 = QuadraticForm::of_words(&case.words.f2).scaled(&unit(format.guard_quadratic));
        let most = f2.max_abs_on(&window);
        prop_assert!(most < power_of_two(format.quadratic - 1));
        let root = BigRational::from_integer(most.ceil().to_integer().sqrt() + 1);
        let f1 = LinearForm::of_words(&case.words.f1).scaled(&unit(format.guard_linear));
        prop_assert!(f1.max_abs_on(&window) + root < power_of_two(format.sum - 1));
        // The root that the normal takes is not masked off, and the sum stays in its word.
        let normal = &case.words.normal;
        let shifted = f2.range_on(&window).1.max(integer(0)).ceil().to_integer().sqrt() >> normal.shift;
        prop_assert!(shifted <= BigInt::from(format.greatest_normal()));
        for (g, k) in normal.g.iter().zip(normal.k) {
            let change = BigInt::from(k.unsigned_abs()) * &shifted / (1 << format.product_fraction()) + 1;
            let most = LinearForm::of_words(g).max_abs_on(&window) + BigRational::from_integer(change);
            prop_assert!(most < power_of_two(format.normal_linear - 1));
        }
        let ScreenBox { x0, x1, y0, y1 } = window;
        prop_assert!(x0 >= 0 && y0 >= 0 && x1 < 4096 && y1 < 4096 && x0 <= x1 && y0 <= y1);
    }
}

/// A bound that is one part in a thousand too small does not pass.
#[test]
fn a_bound_that_is_too_small_is_found() {
    for format in formats() {
        let mut tally = Tally::default();
        for number in 0..200 {
            let mut random = Random::of_case(3, number);
            let mut case = Case::draw(&format, &mut random);
            case.bounds.f1 *= 0.999;
            case.bounds.f2 *= 0.999;
            for at in places(&case, &mut random) {
                place::try_pixel(&case, at, &mut tally);
            }
        }
        assert!(tally.violations > 50, "{format:?}");
        assert!(!tally.first_violations.is_empty());
    }
}
