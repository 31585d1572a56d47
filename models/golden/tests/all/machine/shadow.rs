use crate::common::*;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::{ALL_SOURCES, light};
use imogene_golden::machine::shadow::{ShadowWords, flags, latency};

fn any_volumes(count: usize) -> impl Strategy<Value = Vec<(ShadowWords, bool)>> {
    let kind = prop_oneof![Just(VolumeKind::Light), Just(VolumeKind::Shadow)];
    let words = (kind, 0u8..4, any::<bool>()).prop_map(|(kind, source, enabled)| ShadowWords {
        kind,
        source,
        enabled,
    });
    proptest::collection::vec((words, any::<bool>()), count)
}

proptest! {
    /// The sentence that defines the flags, source by source.
    #[test]
    fn a_source_shines_outside_its_shadows_and_inside_its_lights(
        list in any_volumes(9), before in any::<u16>(),
    ) {
        let (volumes, inside): (Vec<_>, Vec<_>) = list.iter().copied().unzip();
        let found = flags(before, &volumes, &inside);
        for s in 0..16 {
            let mut own = list.iter().filter(|(v, _)| v.enabled && v.source == s);
            let shines = own.all(|(v, inside)| *inside == (v.kind == VolumeKind::Light));
            prop_assert_eq!(found >> s & 1 == 1, shines && before >> s & 1 == 1);
        }
    }

    /// A machine with fewer volume processors than volumes takes several passes.
    #[test]
    fn passes_and_order_do_not_matter(
        (list, shuffled) in any_volumes(12).prop_flat_map(|list| (Just(list.clone()), Just(list).prop_shuffle())),
        cut in 0usize..=12,
    ) {
        let of = |before, list: &[(ShadowWords, bool)]| {
            let (volumes, inside): (Vec<_>, Vec<_>) = list.iter().copied().unzip();
            flags(before, &volumes, &inside)
        };
        let whole = of(ALL_SOURCES, &list);
        prop_assert_eq!(of(of(ALL_SOURCES, &shuffled[..cut]), &shuffled[cut..]), whole);
    }
}

/// Volumes that overlap, of one source and of two, against the lighting of a frame.
#[test]
fn the_stage_gives_the_flags_of_a_frame() {
    let format = Format::BASE;
    let width = 12;
    let mut frame = Frame::background(width, 1, format.z_max());
    frame.depth = (0..width as i64).map(|x| 60 + 10 * (x % 5)).collect();
    let volumes = [
        slab((VolumeKind::Shadow, 0), [0, 5], 70, 1),
        slab((VolumeKind::Shadow, 0), [3, 8], 90, 1),
        slab((VolumeKind::Light, 0), [1, 9], 50, 1),
        slab((VolumeKind::Light, 1), [4, 11], 50, 1),
        slab((VolumeKind::Shadow, 1), [4, 6], 80, 1),
    ];
    let expected = light(&frame, &volumes.iter().collect::<Vec<_>>(), &format, || ());
    let words = volumes.each_ref().map(|v| ShadowWords {
        kind: v.kind,
        source: v.source,
        enabled: true,
    });
    let pixel = |(x, &depth): (i64, &i64)| {
        let inside = volumes.each_ref().map(|v| v.holds(x, 0, depth, &format));
        flags(ALL_SOURCES, &words, &inside)
    };
    let found: Vec<u16> = (0..).zip(&frame.depth).map(pixel).collect();
    assert_eq!(found, expected.flags);
    let kinds: std::collections::BTreeSet<u16> = found.into_iter().collect();
    assert_eq!(kinds.len(), 4, "all four states of two sources: {kinds:x?}");
}

#[test]
fn eight_volumes_to_a_register() {
    let found = [1, 8, 9, 64, 65, 256].map(latency);
    assert_eq!(found, [1, 1, 2, 2, 3, 3]);
}
