use imogene_contract::video::VideoMode;

/// The published clocks give the published rates: 59.94 Hz and 60 Hz.
#[test]
fn rates_of_the_named_modes() {
    let frame = |mode: VideoMode| mode.line.total() * mode.frame.total();
    let clocks = VideoMode::ALL.map(frame);
    assert_eq!(clocks[1..], [420_000, 1_237_500, 2_475_000]);
    assert_eq!(frame(VideoMode::HD) * 60, 74_250_000);
    assert_eq!(frame(VideoMode::FULL_HD) * 60, 148_500_000);
    assert_eq!(25_175_000 * 100 / frame(VideoMode::VGA), 5994);
}
