use imogene_board::BoardMode;

#[test]
fn a_mode_has_60_frames_a_second_where_it_says_nothing_else() {
    for (text, name, rate) in [
        ("640x480", "640x480", 60),
        ("1920x1080@30", "1920x1080", 30),
    ] {
        let mode = BoardMode::try_from(text.to_owned()).unwrap();
        assert_eq!((mode.name.as_str(), mode.rate), (name, rate));
        assert_eq!(String::from(mode), text);
    }
    for text in ["640x480@", "640x480@0", "640x480@241", "640x480@x"] {
        let problem = BoardMode::try_from(text.to_owned()).unwrap_err();
        assert!(problem.contains("1 to 240 frames per second"), "{problem}");
    }
}
