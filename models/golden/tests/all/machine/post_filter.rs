use imogene_golden::machine::post_filter::Kernel;

fn grey(lines: &[&[u8]]) -> Vec<Vec<[u8; 3]>> {
    let line = |line: &&[u8]| line.iter().map(|v| [*v; 3]).collect();
    lines.iter().map(line).collect()
}

#[test]
fn a_point_spreads_by_the_weights() {
    let point = grey(&[&[0, 0, 0, 0], &[0, 160, 0, 0], &[0, 0, 0, 0]]);
    let spread = grey(&[&[10, 20, 10, 0], &[20, 40, 20, 0], &[10, 20, 10, 0]]);
    assert_eq!(Kernel::Binomial.picture(&point), spread);
    let spread = grey(&[&[0, 0, 0, 0], &[0, 40, 40, 0], &[0, 40, 40, 0]]);
    assert_eq!(Kernel::Box.picture(&point), spread);
    assert_eq!(Kernel::Pass.picture(&point), point);
}

#[test]
fn halves_are_rounded_up_and_edges_repeat() {
    assert_eq!(Kernel::Box.picture(&grey(&[&[0, 1]])), grey(&[&[0, 1]]));
    let row = grey(&[&[0, 2, 4]]);
    assert_eq!(Kernel::Binomial.picture(&row), grey(&[&[1, 2, 4]]));
}
