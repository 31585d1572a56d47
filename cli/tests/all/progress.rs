use imogene::progress::line;
use std::time::Duration;

#[test]
fn a_line_says_how_far_it_is_and_how_long_it_takes() {
    let taken = Duration::from_secs(30);
    let line = |done, length| line("framing", done, length, taken);
    assert_eq!(line(25, 100), "framing: 25 %, 90 s left");
    assert_eq!(line(0, 100), "framing: 0 %");
    assert_eq!(line(100, 100), "framing: 100 %, 0 s left");
    assert_eq!(line(120, 100), "framing: 100 %, 0 s left");
    assert_eq!(line(7, 0), "framing: 7");
}
