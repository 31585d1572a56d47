use imogene_analysis::bounds::outline::{Presence, Silhouette};
use imogene_golden::object::quadric::ScreenBox;

/// Pixels adrift in a drawing of 8 columns: `.` absent, `#` present, `?` open, `:` unclear.
fn adrift(drawing: [&str; 4]) -> Vec<(i64, i64)> {
    let presence: Vec<Presence> = drawing
        .concat()
        .chars()
        .map(|c| match c {
            '.' => Presence::Absent,
            '#' => Presence::Present,
            '?' => Presence::Open,
            _ => Presence::Unclear,
        })
        .collect();
    let window = ScreenBox::of([1, 8], [1, 4]);
    Silhouette {
        window,
        presence,
        size: (10, 6),
    }
    .adrift()
}

#[test]
fn an_outline_between_neighbours_is_held() {
    assert_eq!(adrift(["........", "..????..", ".?####?.", "########"]), []);
    assert_eq!(adrift(["###.....", ".###....", "..#?#...", "....###."]), []);
}

#[test]
fn a_group_one_pixel_wide_is_no_wider_than_a_pixel() {
    assert_eq!(adrift(["........", "...?....", "........", "........"]), []);
    assert_eq!(adrift(["########", "###?####", "########", "########"]), []);
    assert_eq!(adrift(["........", ".????...", ".....?..", "......?."]), []);
}

#[test]
fn a_part_that_may_vanish_is_adrift() {
    let all = [(3, 2), (4, 2), (3, 3), (4, 3)];
    let open = adrift(["........", "..??....", "..??....", "........"]);
    assert_eq!(open, all);
    let open = adrift(["########", "##??####", "##??####", "########"]);
    assert_eq!(open, all);
    // A band of three, of whose pixels only those at two corners see both sides.
    let open = adrift(["...???##", "...???##", "...???##", "...???##"]);
    assert_eq!(open.len(), 10);
}

#[test]
fn nothing_is_known_beyond_the_picture() {
    let presence = vec![Presence::Open; 4];
    let window = ScreenBox::of([0, 3], [0, 0]);
    let size = (4, 1);
    let single = Silhouette {
        window,
        presence,
        size,
    };
    assert!(single.adrift().is_empty());
}
