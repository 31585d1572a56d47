//! The shading processor with several numbers of lights, at points or directional.

use imogene_contract::{Request, Unit};
use imogene_verif::unit::subject;

#[test]
fn every_number_of_lights() {
    for (lights, suns) in [
        (1, 0),
        (1, 1),
        (2, 0),
        (2, 1),
        (3, 0),
        (3, 3),
        (4, 0),
        (4, 2),
    ] {
        let request = Request {
            lights,
            suns,
            ..Request::new(Unit::ShadingProcessor)
        };
        let subject = subject(&request).unwrap();
        // Small numbers before a logarithm are rare.
        let seeds = 0..if lights == 1 { 100 } else { 8 };
        let stimuli = seeds.map(|seed| subject.seeded_stimulus(500, seed));
        let outcomes = subject.run_all(&stimuli.collect::<Vec<_>>(), false);
        for (seed, (report, _)) in outcomes.into_iter().enumerate() {
            assert_eq!(
                report.mismatches, 0,
                "{lights} lights, {suns} suns, seed {seed}: {:?}",
                report.first_mismatches
            );
            assert!(report.comparisons > 500);
        }
    }
}
