use imogene_studies::picture::Preview;
use std::fs::File;
use std::path::Path;

/// What the decoder of the same crate reads back: its delays in seconds, and the pictures.
fn read(path: &Path) -> Vec<(f64, Vec<u8>)> {
    let decoder = png::Decoder::new(std::io::BufReader::new(File::open(path).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let count = reader.info().animation_control.unwrap().num_frames;
    let frame = |_| {
        let mut picture = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut picture).unwrap();
        let control = reader.info().frame_control.unwrap();
        let delay = f64::from(control.delay_num) / f64::from(control.delay_den);
        (delay, picture)
    };
    (0..count).map(frame).collect()
}

#[test]
fn frames_and_their_times_come_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("preview.png");
    let pictures = [[10u8; 12], [200; 12], [30; 12]];
    let times = [0.04, 1.0 / 60.0, 60.0];
    let mut preview = Preview::new(File::create(&path).unwrap(), (2, 2), 3).unwrap();
    for (picture, seconds) in pictures.iter().zip(times) {
        preview.frame(picture, seconds).unwrap();
    }
    preview.finish().unwrap();
    let found = read(&path);
    assert_eq!(found.len(), 3);
    for ((delay, picture), (wanted, seconds)) in found.iter().zip(pictures.iter().zip(times)) {
        // The documented resolution, halved by rounding.
        assert!((delay - seconds).abs() <= 0.000_05 + 1e-12);
        assert_eq!(picture, wanted);
    }
}

#[test]
fn a_missing_frame_is_an_error() {
    let mut preview = Preview::new(tempfile::tempfile().unwrap(), (2, 2), 2).unwrap();
    preview.frame(&[0; 12], 0.04).unwrap();
    assert!(preview.finish().is_err());
}
