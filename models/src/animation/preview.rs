//! An animated PNG, written frame by frame.

use crate::picture::{WriteError, new_file_in};
use std::fs::File;
use std::io::{BufWriter, Error, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// An animated PNG that appears under its name when it is finished, and not at all otherwise. It plays without end.
pub struct Preview {
    path: PathBuf,
    file: NamedTempFile,
    writer: png::Writer<BufWriter<File>>,
}

impl Preview {
    /// Begins one of so many frames; missing parent folders are created.
    ///
    /// # Errors
    ///
    /// If nothing can be written there.
    pub fn new(path: &Path, (width, height): (u32, u32), frames: u32) -> Result<Self, WriteError> {
        let begin = || -> std::io::Result<Preview> {
            let folder = match path.parent() {
                Some(parent) if !parent.as_os_str().is_empty() => parent,
                _ => Path::new("."),
            };
            std::fs::create_dir_all(folder)?;
            let file = new_file_in(folder)?;
            let out = BufWriter::new(file.reopen()?);
            let mut encoder = png::Encoder::new(out, width, height);
            encoder.set_color(png::ColorType::Rgb);
            encoder.set_depth(png::BitDepth::Eight);
            encoder.set_animated(frames, 0).map_err(Error::other)?;
            encoder.validate_sequence(true);
            Ok(Preview {
                path: path.to_path_buf(),
                file,
                writer: encoder.write_header().map_err(Error::other)?,
            })
        };
        begin().map_err(|source| failed(path, source))
    }

    /// Adds a frame, 8-bit RGB, that is shown for a time in seconds.
    ///
    /// The format takes times to a tenth of a millisecond; beyond 6.5 seconds to a millisecond.
    ///
    /// # Errors
    ///
    /// If it cannot be written.
    pub fn frame(&mut self, rgb: &[u8], seconds: f64) -> Result<(), WriteError> {
        let (numerator, denominator) = delay(seconds);
        let set = self.writer.set_frame_delay(numerator, denominator);
        let written = set.and_then(|()| self.writer.write_image_data(rgb));
        written.map_err(|error| failed(&self.path, Error::other(error)))
    }

    /// Lets the file appear under its name.
    ///
    /// # Errors
    ///
    /// If it cannot be written, or has not as many frames as were announced.
    pub fn finish(self) -> Result<(), WriteError> {
        let path = self.path;
        let end = || -> std::io::Result<()> {
            self.writer.finish().map_err(Error::other)?;
            self.file.as_file().flush()?;
            self.file.persist(&path).map_err(|e| e.error)?;
            Ok(())
        };
        end().map_err(|source| failed(&path, source))
    }
}

fn failed(path: &Path, source: Error) -> WriteError {
    WriteError {
        path: path.to_path_buf(),
        source,
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
        let path = folder.path().join("deep/preview.png");
        let pictures = [[10u8; 12], [200; 12], [30; 12]];
        let times = [0.04, 1.0 / 60.0, 60.0];
        let mut preview = Preview::new(&path, (2, 2), 3).unwrap();
        for (picture, seconds) in pictures.iter().zip(times) {
            assert!(!path.exists());
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
    fn what_is_not_finished_does_not_appear() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("preview.png");
        let mut preview = Preview::new(&path, (2, 2), 2).unwrap();
        preview.frame(&[0; 12], 0.04).unwrap();
        assert!(preview.finish().is_err());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
