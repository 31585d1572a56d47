use imogene_synth::Resources;
use imogene_synth::fitted::estimate::{Kin, between};

fn of(lut: u64) -> Resources {
    Resources {
        lut,
        ff: 7,
        ..Resources::default()
    }
}

#[test]
fn a_module_lies_between_the_nearest_of_its_kind() {
    let kin = Kin::from([(10, of(100)), (20, of(300)), (40, of(400))]);
    let luts = [5, 10, 15, 20, 30, 50].map(|bits| between(&kin, bits).lut);
    assert_eq!(luts, [0, 100, 200, 300, 350, 450]);
    assert_eq!(between(&kin, 33).ff, 7);
    // One alone says all that is known.
    assert_eq!(between(&Kin::from([(10, of(100))]), 99).lut, 100);
}
