use crate::common::slab;
use imogene_golden::format::Format;
use imogene_golden::object::volume::{VolumeKind, polyhedral_latency, quadric_latency};

#[test]
fn latencies() {
    assert_eq!(quadric_latency(&Format::BASE, 2), 17);
    assert_eq!(polyhedral_latency(), 4);
}

#[test]
fn flags_only_ever_fall_so_the_order_of_volumes_does_not_matter() {
    let volume = |kind, source| slab((kind, source), [0, 0], 0, 0);
    let lamp = volume(VolumeKind::Light, 3);
    let shade = volume(VolumeKind::Shadow, 3);
    let all = u16::MAX;
    for lit in [false, true] {
        for shaded in [false, true] {
            let lamp_first = shade.after(lamp.after(all, lit), shaded);
            assert_eq!(lamp_first, lamp.after(shade.after(all, shaded), lit));
            let bit = if lit && !shaded { all } else { all & !(1 << 3) };
            assert_eq!(lamp_first, bit);
        }
    }
    assert_eq!(volume(VolumeKind::Shadow, 15).after(all, true), 0x7fff);
}
