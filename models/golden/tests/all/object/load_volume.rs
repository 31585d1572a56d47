use crate::common::*;
use imogene_contract::volume;
use imogene_golden::object::load_volume::load_volume;

#[test]
fn words_stand_at_their_addresses() {
    let (kind, depth) = (PlaneKind::Back, Linear::new(3, -1, 4));
    let words = VolumeWords {
        kind: VolumeKind::Light,
        source: 5,
        screen_box: ScreenBox::of([1, 6], [2, 4]),
        margin: 77,
        quadric: Some(VolumeQuadric {
            class: Class::Front,
            f1: Linear::new(-1, 0, 9),
            shift: 8,
            ..VolumeQuadric::EVERYWHERE
        }),
        planes: vec![VolumePlane { kind, depth }],
    };
    let list = load_volume(&words, &Format::BASE, 2);
    assert_eq!(list.len(), volume::words(2));
    let addresses = list.iter().map(|w| usize::from(w.address));
    assert!(addresses.eq(0..list.len()));
    let bits: Vec<u64> = list.iter().map(|w| w.bits).collect();
    assert_eq!(bits[..3], [(1 << 26) - 1, 0, 9]);
    let expected = [1 | 6 << 12, 2 | 4 << 12, 1 | 8 << 2 | 1 << 6 | 5 << 7, 77];
    assert_eq!(bits[9..13], expected);
    assert_eq!(bits[13..], [2, 3, (1 << 36) - 1, 4, 0, 0, 0, 0]);

    let planes_alone = VolumeWords {
        quadric: None,
        kind: VolumeKind::Shadow,
        ..words
    };
    let list = load_volume(&planes_alone, &Format::BASE, 2);
    assert!(list[..9].iter().all(|word| word.bits == 0));
    assert_eq!(list[11].bits, 3 | 5 << 7);
}
