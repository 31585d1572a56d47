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
