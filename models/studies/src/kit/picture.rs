//! Files of a picture: PNG, still or animated, and NumPy arrays of depth, object index and normals.
//!
//! The functions fill a stream; [`Outputs`] lets the files appear.

pub use imogene_files::{Outputs, WriteError, write_whole};
use imogene_golden::machine::frame::Frame;
use npyz::WriterBuilder;
use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::Path;

/// A PNG file whose head is read.
fn opened(path: &Path, how: png::Transformations) -> Result<png::Reader<BufReader<File>>, String> {
    let file = File::open(path).map_err(|e| e.to_string())?;
    let mut decoder = png::Decoder::new(BufReader::new(file));
    decoder.set_transformations(how);
    decoder.read_info().map_err(|e| e.to_string())
}

fn samples(mut reader: png::Reader<BufReader<File>>) -> Result<(png::OutputInfo, Vec<u8>), String> {
    let size = reader.output_buffer_size().ok_or("it is too large")?;
    let mut samples = vec![0; size];
    let info = reader.next_frame(&mut samples).map_err(|e| e.to_string())?;
    Ok((info, samples))
}

/// Kind and samples of a PNG picture as it is; or why it cannot be read.
pub fn read_png(path: &Path) -> Result<(png::OutputInfo, Vec<u8>), String> {
    samples(opened(path, png::Transformations::IDENTITY)?)
}

/// Width, height and, line by line, which pixels of a PNG picture of at most 4096 x 4096 are not black; those that are
/// less than half opaque count as black; or why it cannot be read.
pub fn read_mask(path: &Path) -> Result<(usize, usize, Vec<bool>), String> {
    let reader = opened(path, png::Transformations::normalize_to_color8())?;
    let (width, height) = (reader.info().width, reader.info().height);
    if width.max(height) > MAX_MASK_SIDE {
        let pixels = format!("{width} x {height} pixels");
        return Err(format!("{pixels} are more than {MAX_MASK_SIDE} each way"));
    }
    let (info, samples) = samples(reader)?;
    let each = info.color_type.samples();
    // Two or four samples: the last one is the opacity.
    let colours = each - usize::from(each.is_multiple_of(2));
    let is_set = |pixel: &[u8]| {
        let (colour, alpha) = pixel.split_at(colours);
        colour.iter().any(|&c| c > 0) && alpha.iter().all(|&a| a >= 128)
    };
    let pixels = samples[..info.buffer_size()].chunks_exact(each);
    let mask = pixels.map(is_set).collect();
    Ok((width as usize, height as usize, mask))
}

const MAX_MASK_SIDE: u32 = 4096;

/// Writes an 8-bit RGB picture to a file of its own.
pub fn write_png(path: &Path, width: usize, height: usize, rgb: &[u8]) -> Result<(), WriteError> {
    write_whole(path, |out| png(out, width, height, rgb))
}

/// An 8-bit RGB picture.
pub fn png(out: &mut dyn Write, width: usize, height: usize, rgb: &[u8]) -> io::Result<()> {
    let encoder = encoder(out, (width as u32, height as u32));
    let mut writer = encoder.write_header().map_err(io::Error::other)?;
    writer.write_image_data(rgb).map_err(io::Error::other)?;
    writer.finish().map_err(io::Error::other)
}

fn encoder<'a, W: Write>(out: W, (width, height): (u32, u32)) -> png::Encoder<'a, W> {
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder
}

/// Depth words, int64 of shape (height, width); the background is the format's `z_max`.
pub fn depth(out: &mut dyn Write, frame: &Frame) -> io::Result<()> {
    let depths = frame.depth.iter().copied();
    npy(out, &[frame.height, frame.width], depths)
}

/// Object indices, int32 of shape (height, width); the background is -1.
pub fn ids(out: &mut dyn Write, frame: &Frame) -> io::Result<()> {
    npy(out, &[frame.height, frame.width], frame.id.iter().copied())
}

/// Normal components, int16 of shape (height, width, 3), camera frame (x right, y down, z away).
pub fn normals(out: &mut dyn Write, frame: &Frame) -> io::Result<()> {
    let components = frame.normal.iter().flatten().copied();
    npy(out, &[frame.height, frame.width, 3], components)
}

/// Marks of pixels, uint8 of shape (height, width).
pub fn marks(out: &mut dyn Write, width: usize, marks: &[u8]) -> io::Result<()> {
    let height = marks.len() / width.max(1);
    npy(out, &[height, width], marks.iter().copied())
}

fn npy<T: npyz::Serialize + npyz::AutoSerialize>(
    out: &mut dyn Write,
    shape: &[usize],
    values: impl Iterator<Item = T>,
) -> io::Result<()> {
    let shape: Vec<u64> = shape.iter().map(|side| *side as u64).collect();
    let mut writer = npyz::WriteOptions::new()
        .default_dtype()
        .shape(&shape)
        .writer(out)
        .begin_nd()?;
    writer.extend(values)?;
    writer.finish()
}

/// An animated PNG that plays without end.
pub struct Preview(png::Writer<File>);

impl Preview {
    /// Begins one of so many frames in an empty file.
    pub fn new(file: File, size: (u32, u32), frames: u32) -> io::Result<Self> {
        let mut encoder = encoder(file, size);
        encoder.set_animated(frames, 0).map_err(io::Error::other)?;
        encoder.validate_sequence(true);
        let writer = encoder.write_header().map(Preview);
        writer.map_err(io::Error::other)
    }

    /// Adds a frame, 8-bit RGB, that is shown for a time in seconds.
    ///
    /// The format takes times to a tenth of a millisecond; beyond 6.5 seconds to a millisecond.
    pub fn frame(&mut self, rgb: &[u8], seconds: f64) -> io::Result<()> {
        let denominator = if seconds <= 6.5 { 10_000 } else { 1_000 };
        let numerator = (seconds * f64::from(denominator)).round();
        let numerator = numerator.clamp(0.0, 65_535.0);
        let set = self.0.set_frame_delay(numerator as u16, denominator);
        let written = set.and_then(|()| self.0.write_image_data(rgb));
        written.map_err(io::Error::other)
    }

    /// Ends the file; fails if it has not as many frames as were announced, or cannot be written.
    pub fn finish(self) -> io::Result<()> {
        self.0.finish().map_err(io::Error::other)
    }
}
