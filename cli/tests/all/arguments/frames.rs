use imogene::arguments::FrameRange;

#[test]
fn ranges_are_read() {
    let of = |text: &str| text.parse::<FrameRange>().unwrap().of("--frames", 24);
    assert_eq!(of("").unwrap(), 1..=24);
    assert_eq!(of("3..7").unwrap(), 3..=7);
    assert_eq!(of("24").unwrap(), 24..=24);
    assert!(of("3..25").unwrap_err().contains("1 to 24"));
    for text in ["0..3", "4..3", "a", "1..", "..", "1...3", "-1..2"] {
        let refused = text.parse::<FrameRange>().unwrap_err();
        assert!(refused.contains("1..24"), "{text}");
    }
}
