use imogene_verif::waveform::Place;

#[test]
fn places_are_pixels_lines_and_frames() {
    let read = |text: &str| text.parse::<Place>().map(|place| place.to_string());
    for (text, wanted) in [
        ("16,12", "16,12"),
        ("line:7", "0,7"),
        ("frame:2", "frame:2,0,0"),
        ("frame:2,16,12", "frame:2,16,12"),
        ("frame:2,line:7", "frame:2,0,7"),
    ] {
        assert_eq!(read(text).as_deref(), Ok(wanted));
    }
    let wrong =
        " 7 1,2,3 -1,2 line: line:1,2 frame:0 frame: frame:2, frame:2,7 line:3,frame:2 Frame:2";
    // The first is empty.
    for text in wrong.split(' ') {
        let error = read(text).expect_err(text);
        assert!(error.contains("frame:2,line:120"), "{text}: {error}");
    }
}
