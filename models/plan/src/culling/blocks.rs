//! A statement about a window that is tried on the whole and then on its quarters (source: Claux, III.3.2.2).

use imogene_golden::object::quadric::ScreenBox;

/// Pixels along the side of a window that is not divided any further.
pub const BLOCK: i64 = 4;

/// Does `holds` say so of the window, or of each of its quarters, or of theirs, down to blocks of [`BLOCK`] pixels?
/// `holds` must be sound for the window it is given; an empty window needs no saying.
pub fn everywhere(window: &ScreenBox, holds: &impl Fn(&ScreenBox) -> bool) -> bool {
    if window.is_empty() || holds(window) {
        return true;
    }
    let columns = halves(window.x0, window.x1);
    let lines = halves(window.y0, window.y1);
    if columns[1].is_none() && lines[1].is_none() {
        return false;
    }
    lines.into_iter().flatten().all(|(y0, y1)| {
        let mut columns = columns.into_iter().flatten();
        columns.all(|(x0, x1)| everywhere(&ScreenBox::of([x0, x1], [y0, y1]), holds))
    })
}

/// The first and the second half of some pixels, or all of them.
fn halves(first: i64, last: i64) -> [Option<(i64, i64)>; 2] {
    if last - first < BLOCK {
        return [Some((first, last)), None];
    }
    let middle = first + (last - first) / 2;
    [Some((first, middle)), Some((middle + 1, last))]
}
