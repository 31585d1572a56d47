use imogene_golden::machine::line_merger::LineMerger;
use std::collections::VecDeque;

/// The pixel of a column of a line.
fn pixel(line: usize, column: usize) -> u32 {
    (line * 100 + column) as u32
}

/// What comes of lines `modules * group + m` of 8 columns, a pixel or two at once.
fn coming(modules: usize, group: usize, column: usize, lanes: usize) -> Vec<u32> {
    let module = |m: usize| (0..lanes).map(move |lane| pixel(modules * group + m, column + lane));
    (0..modules).flat_map(module).collect()
}

#[test]
fn lines_leave_in_their_order_without_a_gap() {
    for (modules, lanes) in [(2, 1), (4, 1), (2, 2)] {
        let mut merger = LineMerger::new(modules);
        let columns = move |group: usize| (0..8).step_by(lanes).map(move |x| (group, x));
        let mut waiting: VecDeque<(usize, usize)> = (0..6).flat_map(columns).collect();
        let (mut left, mut clocks) = (vec![], vec![]);
        // Seven lines of each module: the last ones leave when the others have come.
        for clock in 0..8 * 7 / lanes + 1 {
            let now = waiting.front().map(|&(group, column)| {
                let pixels = coming(modules, group, column, lanes);
                (pixels, group + column == 0, column + lanes == 8)
            });
            if merger.is_ready() {
                waiting.pop_front();
            }
            let now = now.as_ref();
            merger.clock(
                now.map(|(pixels, first, last)| (&pixels[..], *first, *last)),
                true,
            );
            clocks.extend(merger.leaving().map(|_| clock));
            left.extend(merger.leaving().cloned());
        }
        let pixels: Vec<u32> = left.iter().flat_map(|l| l.pixels.clone()).collect();
        let wanted = (0..6 * modules).flat_map(|line| (0..8).map(move |x| pixel(line, x)));
        assert_eq!(pixels, wanted.collect::<Vec<u32>>());
        assert!(left.iter().enumerate().all(|(at, l)| l.first == (at == 0)));
        let words = 8 / (modules * lanes);
        assert!(
            left.iter()
                .enumerate()
                .all(|(at, l)| l.last == ((at + 1) % words == 0))
        );
        // Two clocks after the last pixel of the first lines has come.
        assert_eq!(clocks[0], 8 / lanes + 1);
        assert!(clocks.windows(2).all(|pair| pair[1] == pair[0] + 1));
    }
}

#[test]
fn two_groups_wait_and_a_third_is_not_taken() {
    let mut merger = LineMerger::new(2);
    let mut taken = 0;
    for column in (0..4).cycle().take(40) {
        taken += usize::from(merger.is_ready());
        merger.clock(Some((&[column, 9], false, column == 3)), false);
    }
    assert_eq!(taken, 8);
    let waiting = merger.leaving().cloned().expect("the first pixels");
    assert_eq!(waiting.pixels, [0, 1]);
    // A bank is free when the last of its pixels has been read.
    for left in [2, 1] {
        assert!(!merger.is_ready(), "{left} left");
        merger.clock(None, true);
    }
    assert!(merger.is_ready());
}
