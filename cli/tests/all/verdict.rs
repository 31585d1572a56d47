use crate::common::assert_has;
use imogene::failure::Failure;
use imogene::verdict::{of_bounds, of_levels};
use imogene_golden::format::Format;
use imogene_golden::machine::shader::ShaderWidths;
use imogene_studies::shading_trial::errors;
use imogene_studies::trial;
use imogene_studies::trial::{FORMATS, Term, Violation};

#[test]
fn an_error_of_two_levels_fails_the_check_and_is_named() {
    let mut errors = errors(&ShaderWidths::default(), 4096, 1, |_| {});
    assert!(of_levels(&errors).is_ok());
    errors.beyond = 3;
    let Err(Failure::Check(message)) = of_levels(&errors) else {
        panic!("not a failed check");
    };
    assert!(message.contains("3 levels"), "{message}");
}

#[test]
fn an_error_beyond_its_bound_fails_the_check_and_is_named() {
    let format = Format::fitted(&FORMATS[4]).unwrap();
    let mut report = trial::run(&format, 1, 1, false, |_| ());
    report.tally.violations = 1;
    report.tally.first_violations = vec![Violation {
        term: Term::Depth,
        case: 17,
        pixel: (3, 4),
        observed: 2.5,
        bound: 2.0,
    }];
    let Err(Failure::Check(message)) = of_bounds(9, &[report]) else {
        panic!("not a failed check");
    };
    let widths = "widths depth=20,root=20,plane=32,normal=16,g1=2,g2=4,dropped=0";
    assert_has(&message, widths);
    assert_has(&message, "case 17 of seed 9 | (3, 4) | 2.5e0 beyond 2e0");
}
