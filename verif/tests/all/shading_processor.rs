//! The shading processor with several numbers of lights, at points or directional.

use super::{request, run};
use imogene_verif::unit::subject;

#[test]
fn every_number_of_lights() {
    let all = [(1, 1), (2, 1), (3, 3), (4, 2)].map(|(lights, some)| [(lights, 0), (lights, some)]);
    for (lights, suns) in all.concat() {
        let options = [("lights", lights), ("suns", suns)];
        let subject = subject(&request("shading_processor", 24, &options)).unwrap();
        // Small numbers before a logarithm are rare.
        let reports = run(&subject, if lights == 1 { 100 } else { 8 }, 500);
        assert!(reports.iter().all(|report| report.comparisons > 500));
    }
}
