use imogene_golden::format::Format;
use imogene_golden::object::load_volume::{FIRST_PLANE, PLANE_WORDS, load_volume};
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::volume::{VolumeKind, VolumePlane, VolumeQuadric, VolumeWords};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;

#[test]
fn words_stand_at_their_addresses() {
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
        planes: vec![VolumePlane {
            kind: PlaneKind::Back,
            depth: Linear::new(3, -1, 4),
        }],
    };
    let list = load_volume(&words, &Format::BASE, 2);
    assert_eq!(list.len(), usize::from(FIRST_PLANE + 2 * PLANE_WORDS));
    assert!(
        list.iter()
            .enumerate()
            .all(|(i, w)| usize::from(w.address) == i)
    );
    let bits: Vec<u64> = list.iter().map(|w| w.bits).collect();
    assert_eq!(bits[..3], [(1 << 26) - 1, 0, 9]);
    assert_eq!(
        bits[9..13],
        [1 | 6 << 12, 2 | 4 << 12, 1 | 8 << 2 | 1 << 6 | 5 << 7, 77]
    );
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
