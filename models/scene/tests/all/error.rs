use imogene_scene::error::{SHOWN, around};

#[test]
fn of_a_long_line_the_part_around_the_column_is_shown() {
    assert_eq!(around("radius = x", 10), "radius = x");
    let line = format!("{}ä{}", "a".repeat(500), "b".repeat(500));
    let shown = around(&line, 501);
    assert!(shown.starts_with(".. aaa"), "{shown}");
    assert!(shown.ends_with("bbb .."), "{shown}");
    assert!(shown.contains("aäb") && shown.chars().count() == SHOWN + 6);
    assert!(around(&line, 1).starts_with("aaa") && around(&line, 1).ends_with("aaa .."));
    let end = around(&line, 1001);
    assert!(end.starts_with(".. bbb") && end.ends_with("bbb"), "{end}");
}
