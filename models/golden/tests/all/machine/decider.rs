use imogene_golden::machine::decider::{Visible, decide, latency};

#[test]
fn equal_depths_go_to_the_smaller_id_in_any_order() {
    let at = |depth, id| Visible {
        depth,
        id,
        number: id,
        normal: [0; 3],
    };
    let mut inputs = [at(5, 3), at(4, 9), at(4, 2), at(7, 0)];
    for _ in 0..4 {
        inputs.rotate_left(1);
        assert_eq!(decide(&inputs).id, 2);
    }
    assert_eq!([1, 2, 3, 4, 5, 10].map(latency), [0, 1, 2, 2, 3, 4]);
}
