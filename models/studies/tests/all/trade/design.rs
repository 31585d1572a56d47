use imogene_studies::trade::design::{Accuracy, Design, Space};

#[test]
fn points_have_names_of_their_own_and_those_of_the_same_pixels_stand_together() {
    for (space, least) in [(Space::Quick, 17), (Space::Full, 500), (Space::Roots, 24)] {
        let designs = space.designs(320);
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

#[test]
fn several_pixels_per_clock_want_lines_that_are_long_enough() {
    let lanes = |columns: u32| {
        let designs = Space::Full.designs(columns);
        let lanes = designs.iter().map(|design| design.pixels_per_clock);
        lanes.filter(|lanes| *lanes > 1).collect::<Vec<u32>>()
    };
    assert!(lanes(64).is_empty() && lanes(321).is_empty());
    assert!(lanes(320).contains(&4) && lanes(320).contains(&2));
    let short = lanes(100);
    assert!(!short.is_empty() && short.iter().all(|lanes| *lanes == 2));
}
