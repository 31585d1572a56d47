//! The shading processor with every number of lights.

use imogene_contract::{Request, Unit};
use imogene_verif::unit::subject;

#[test]
fn every_number_of_lights() {
    for lights in 1..=4 {
        let request = Request {
            lights,
            ..Request::new(Unit::ShadingProcessor)
        };
        let subject = subject(&request).unwrap();
        // Small numbers before a logarithm are rare.
        for seed in 0..if lights == 1 { 100 } else { 8 } {
            let stimulus = subject.seeded_stimulus(500, seed);
            let (report, _) = subject.run(&stimulus, false);
            assert_eq!(
                report.mismatches, 0,
                "{lights} lights, seed {seed}: {:?}",
                report.first_mismatches
            );
            assert!(report.comparisons > 500);
        }
    }
}
