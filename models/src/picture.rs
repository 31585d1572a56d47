//! Files of a picture: PNG, and NumPy arrays of depth, object index and normals.
//!
//! Every file is written beside its destination and renamed when complete, so a failure leaves nothing half-written.

use crate::machine::frame::Frame;
use npyz::WriterBuilder;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;
use thiserror::Error;

/// A file that could not be written.
#[derive(Debug, Error)]
#[error("cannot write '{}': {source}", path.display())]
pub struct WriteError {
    /// Destination.
    pub path: PathBuf,
    /// Why.
    pub source: std::io::Error,
}

/// Writes a file whole or not at all; missing parent folders are created.
pub fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<&mut std::fs::File>) -> std::io::Result<()>,
) -> Result<(), WriteError> {
    let attempt = || -> std::io::Result<()> {
        let folder = match path.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        std::fs::create_dir_all(folder)?;
        let mut file = new_file_in(folder)?;
        let mut writer = BufWriter::new(file.as_file_mut());
        write(&mut writer)?;
        writer.flush()?;
        drop(writer);
        file.persist(path).map_err(|e| e.error)?;
        Ok(())
    };
    attempt().map_err(|source| WriteError {
        path: path.to_path_buf(),
        source,
    })
}

/// A temporary file with the permissions of an ordinary one; temporary files are private by default.
pub(crate) fn new_file_in(folder: &Path) -> std::io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

/// A picture that could not be read.
#[derive(Debug, Error)]
#[error("cannot read '{}': {problem}; accepted is a PNG picture", path.display())]
pub struct ReadError {
    /// The file.
    pub path: PathBuf,
    /// Why.
    pub problem: String,
}

/// Width, height and, line by line, which pixels of a PNG picture of at most 4096 x 4096 are not black; those that are less than half opaque count as black.
pub fn read_mask(path: &Path) -> Result<(usize, usize, Vec<bool>), ReadError> {
    let fail = |problem: String| ReadError {
        path: path.to_path_buf(),
        problem,
    };
    let file = std::fs::File::open(path).map_err(|e| fail(e.to_string()))?;
    let mut decoder = png::Decoder::new(std::io::BufReader::new(file));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(|e| fail(e.to_string()))?;
    let (width, height) = (reader.info().width, reader.info().height);
    if width.max(height) > MAX_MASK_SIDE {
        return Err(fail(format!(
            "{width} x {height} pixels are more than {MAX_MASK_SIDE} each way"
        )));
    }
    let size = reader.output_buffer_size();
    let mut buffer = vec![0; size.ok_or_else(|| fail("it is too large".into()))?];
    let info = reader
        .next_frame(&mut buffer)
        .map_err(|e| fail(e.to_string()))?;
    let samples = info.color_type.samples();
    let has_alpha = matches!(
        info.color_type,
        png::ColorType::GrayscaleAlpha | png::ColorType::Rgba
    );
    let is_set = |pixel: &[u8]| {
        let (colour, alpha) = pixel.split_at(samples - usize::from(has_alpha));
        colour.iter().any(|&c| c > 0) && alpha.iter().all(|&a| a >= 128)
    };
    let pixels = buffer[..info.buffer_size()].chunks_exact(samples);
    Ok((
        width as usize,
        height as usize,
        pixels.map(is_set).collect(),
    ))
}

/// Longest side of a mask that is read.
const MAX_MASK_SIDE: u32 = 4096;

/// An 8-bit RGB picture.
pub fn write_png(path: &Path, width: usize, height: usize, rgb: &[u8]) -> Result<(), WriteError> {
    write_whole(path, |out| {
        let mut encoder = png::Encoder::new(out, width as u32, height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header().map_err(std::io::Error::other)?;
        writer.write_image_data(rgb).map_err(std::io::Error::other)
    })
}

/// Depth words, int64 of shape (height, width); the background is the format's `z_max`.
pub fn write_depth(path: &Path, frame: &Frame) -> Result<(), WriteError> {
    write_npy(path, &shape(frame, None), frame.depth.iter().copied())
}

/// Object indices, int32 of shape (height, width); the background is -1.
pub fn write_ids(path: &Path, frame: &Frame) -> Result<(), WriteError> {
    write_npy(path, &shape(frame, None), frame.id.iter().copied())
}

/// Normal components, int16 of shape (height, width, 3), camera frame (x right, y down, z away).
pub fn write_normals(path: &Path, frame: &Frame) -> Result<(), WriteError> {
    let components = frame.normal.iter().flatten().copied();
    write_npy(path, &shape(frame, Some(3)), components)
}

/// Marks of pixels, uint8 of shape (height, width).
pub fn write_marks(path: &Path, width: usize, marks: &[u8]) -> Result<(), WriteError> {
    let height = marks.len() / width.max(1);
    write_npy(path, &[height as u64, width as u64], marks.iter().copied())
}

fn shape(frame: &Frame, components: Option<u64>) -> Vec<u64> {
    let mut shape = vec![frame.height as u64, frame.width as u64];
    shape.extend(components);
    shape
}

fn write_npy<T: npyz::Serialize + npyz::AutoSerialize>(
    path: &Path,
    shape: &[u64],
    values: impl Iterator<Item = T>,
) -> Result<(), WriteError> {
    write_whole(path, |out| {
        let mut writer = npyz::WriteOptions::new()
            .default_dtype()
            .shape(shape)
            .writer(out)
            .begin_nd()?;
        writer.extend(values)?;
        writer.finish()
    })
}
