//! The shading processor with every number of lights.

use imogene_verif::unit::{Parameters, subject};

#[test]
fn every_number_of_lights() {
    for lights in 1..=4 {
        let parameters = Parameters {
            lights: Some(lights),
            ..Parameters::default()
        };
        let subject = subject("shading_processor", parameters).unwrap();
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
