use imogene_studies::trade::design::{Accuracy, Design, Space};

#[test]
fn points_have_names_of_their_own_and_those_of_the_same_pixels_stand_together() {
    for (space, least) in [(Space::Quick, 17), (Space::Full, 500), (Space::Roots, 24)] {
        let designs = space.designs();
        assert!(designs.len() >= least, "{}", designs.len());
        let mut names: Vec<String> = designs.iter().map(Design::name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), designs.len());
        let mut groups: Vec<Accuracy> = designs.iter().map(|d| d.accuracy).collect();
        groups.dedup();
        let together = groups.len();
        groups.sort_unstable();
        groups.dedup();
        assert_eq!(groups.len(), together);
    }
}
