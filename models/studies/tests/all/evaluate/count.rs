use imogene_algebra::vector::dot;
use imogene_studies::evaluate::count::{Tally, cost, number, numbers};

#[test]
fn every_operation_is_counted_once() {
    let tally = cost(|| {
        let [a, b] = numbers([3.0, 4.0]);
        let c = (a * a + b * b).root();
        assert_eq!(c.value, 5.0);
        assert_eq!((-(a - b) / c).value, 0.2);
        assert!(a.is_below(b) && !b.is_negative() && !a.is_zero());
        assert_eq!(a.or_greater(b).value, 4.0);
        assert_eq!(number(2.5).scaled(b).value, 10.0);
        assert_eq!(number(-2.5).floor().value, -3.0);
        assert_eq!(a.doubled().value, 6.0);
        assert_eq!(b.reciprocal().value, 0.25);
    });
    let expected = Tally {
        additions: 3,
        multiplications: 3,
        divisions: 2,
        roots: 1,
        tests: 4,
        roundings: 2,
    };
    assert_eq!(tally, expected);
    assert_eq!(tally.weighted(), 12 + 24);
}

#[test]
fn a_product_of_lists_has_one_addition_less() {
    let tally = cost(|| {
        let list = numbers([1.0, 2.0, 3.0, 4.0]);
        assert_eq!(dot(list, list).value, 30.0);
    });
    assert_eq!((tally.multiplications, tally.additions), (4, 3));
}
