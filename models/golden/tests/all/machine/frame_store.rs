use imogene_golden::machine::frame_store::{Arriving, FrameStore};

fn pixel(place: usize, colour: u32, last: bool) -> Option<Arriving> {
    Some(Arriving {
        place,
        colour,
        last,
    })
}

#[test]
fn a_frame_is_shown_when_it_is_whole() {
    let mut store = FrameStore::new(2);
    store.clock(pixel(0, 5, false), true, None);
    assert!(!store.clock(None, true, Some(0)).swapped);
    // The last pixel comes with the retrace: too late for it.
    let after = store.clock(pixel(1, 6, true), true, None);
    assert_eq!((after.swapped, after.ready), (false, false));
    // No pixel of the next frame is taken before the frames change places.
    store.clock(pixel(0, 9, false), false, None);
    let after = store.clock(None, true, None);
    assert_eq!((after.swapped, after.ready), (true, true));
    assert_eq!(store.clock(None, false, Some(0)).colour, Some(0));
    store.clock(None, false, Some(1));
    store.clock(None, false, None);
    store.clock(None, false, None);
    assert_eq!(store.clock(None, false, None).colour, Some(5));
    assert_eq!(store.clock(None, false, None).colour, Some(6));
}
