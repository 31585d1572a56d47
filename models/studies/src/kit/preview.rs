//! An animated PNG, written frame by frame.

use std::fs::File;
use std::io::{Error, Result};

/// An animated PNG that plays without end.
pub struct Preview(png::Writer<File>);

impl Preview {
    /// Begins one of so many frames in an empty file.
    pub fn new(file: File, (width, height): (u32, u32), frames: u32) -> Result<Self> {
        let mut encoder = png::Encoder::new(file, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_animated(frames, 0).map_err(Error::other)?;
        encoder.validate_sequence(true);
        encoder.write_header().map(Preview).map_err(Error::other)
    }

    /// Adds a frame, 8-bit RGB, that is shown for a time in seconds.
    ///
    /// The format takes times to a tenth of a millisecond; beyond 6.5 seconds to a millisecond.
    pub fn frame(&mut self, rgb: &[u8], seconds: f64) -> Result<()> {
        let (numerator, denominator) = delay(seconds);
        let set = self.0.set_frame_delay(numerator, denominator);
        let written = set.and_then(|()| self.0.write_image_data(rgb));
        written.map_err(Error::other)
    }

    /// Ends the file.
    /// Fails if it cannot be written, or has not as many frames as were announced.
    pub fn finish(self) -> Result<()> {
        self.0.finish().map_err(Error::other)
    }
}

/// A time as numerator and denominator in seconds.
fn delay(seconds: f64) -> (u16, u16) {
    let denominator = if seconds <= 6.5 { 10_000 } else { 1_000 };
    let numerator = (seconds * f64::from(denominator)).round();
    (numerator.clamp(0.0, 65_535.0) as u16, denominator)
}

#[cfg(test)]
mod tests {
    use super::*;
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
}
