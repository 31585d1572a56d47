use imogene_contract::{Request, Unit};
use imogene_package::census::{Census, census};

#[test]
fn parts_of_the_quadric_processor() {
    let parts = census(&Request::new(Unit::QuadricProcessor)).unwrap();
    let expected = Census {
        pe1: 1 + 3 + 3,
        pe2: 1,
        roots: 1,
        multipliers: 3,
    };
    assert_eq!(parts, expected);
    let machine = census(&Request::new(Unit::Beam)).unwrap();
    assert_eq!((machine.pe1, machine.roots), (28, 4));
}
