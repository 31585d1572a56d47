use imogene_golden::machine::card_decider::{latency, starts};
use imogene_golden::machine::decider;

#[test]
fn skew_and_latency_of_cards() {
    assert_eq!(starts(3, 2), [0, 1, 2, 0, 1, 2]);
    assert_eq!((latency(4, 1), latency(4, 2), latency(4, 5)), (4, 5, 7));
    assert_eq!(latency(1, 8), decider::latency(8) + 1);
}
