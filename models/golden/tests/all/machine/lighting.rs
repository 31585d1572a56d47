use crate::common::*;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::{Lighting, light};

/// A volume from column 1 to 2 and from depth 100 on.
fn volume(kind: VolumeKind, source: u8, margin: u32) -> VolumeWords {
    slab((kind, source), [1, 2], 100, margin)
}

#[test]
fn shadows_clear_inside_and_lights_outside_in_any_order() {
    let format = Format::BASE;
    let mut frame = Frame::background(4, 1, format.z_max());
    frame.depth = vec![200, 100, 200, 200];
    let shade = volume(VolumeKind::Shadow, 0, 1);
    let spot = volume(VolumeKind::Light, 1, 0);
    let wanted = [0xfffd, 0xffff, 0xfffe, 0xfffd];
    for order in [[&shade, &spot], [&spot, &shade]] {
        assert_eq!(light(&frame, &order, &format, || ()).flags, wanted);
    }
    // One source, both kinds: lit inside the cone and outside the shadow.
    let shaded_spot = volume(VolumeKind::Shadow, 1, 1);
    let flags = light(&frame, &[&spot, &shaded_spot], &format, || ()).flags;
    assert_eq!(flags, [0xfffd, 0xffff, 0xfffd, 0xfffd]);
}

#[test]
fn a_background_pixel_is_in_no_shadow() {
    let format = Format::BASE;
    let frame = Frame::background(4, 1, format.z_max());
    let shade = volume(VolumeKind::Shadow, 0, 1);
    let lighting = light(&frame, &[&shade], &format, || ());
    assert_eq!(lighting, Lighting::full(&frame));
}
