use imogene_golden::machine::overlay::{Covered, LATENCY, Overlay};

/// A pixel of two clocks before the write sees it, one of three clocks before does not.
#[test]
fn a_word_is_read_two_clocks_after_its_pixel() {
    for (before, seen) in [(2, true), (3, false)] {
        let mut overlay = Overlay::new(2);
        let (place, colour) = (33, [1, 2, 3]);
        let pixel = Covered { place, colour };
        let clock = |clock: usize| {
            let word = (clock == 4).then_some((1, 2));
            let covered = (clock == 4 - before).then_some(pixel);
            overlay.clock(word, Some([9; 3]), covered)
        };
        let out: Vec<_> = (0..10).map(clock).collect();
        let expected = if seen { [9; 3] } else { [1, 2, 3] };
        assert_eq!(out[4 - before + LATENCY - 1], Some(expected));
        assert_eq!(out.iter().flatten().count(), 1);
    }
}
