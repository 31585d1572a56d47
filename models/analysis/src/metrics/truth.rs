//! The truth of a scene at a size, computed once.

use crate::exact::back::{ExactBack, backs};
use crate::exact::render::{ExactPixel, directions, render, to_frame};
use crate::exact::shadow;
use crate::phong::shade;
use imogene_algebra::rational::{integer, to_f64};
use imogene_golden::format::Format;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::unit::depth_interval::{FACE_NEAR_END, FACE_PLANE};
use imogene_scene::FramedScene;

/// Of an object that no picture shows; the index of the background is another.
const NO_OBJECT: u32 = u32::MAX - 1;
/// Number of a face that no picture shows.
const NO_FACE: u8 = u8::MAX;

/// What is truly seen, in words of the base format.
#[derive(Clone, Debug)]
pub struct Truth {
    /// Pixels per line.
    pub width: usize,
    /// Lines.
    pub height: usize,
    /// Depth with its fraction, object and face of every pixel; nothing where the background is seen.
    pub pixels: Vec<Option<ExactPixel>>,
    /// Back of the visible object, where its processor is one that hands a back on.
    pub backs: Vec<Option<ExactBack>>,
    /// Direction of the normal, of any length.
    pub normals: Vec<[f64; 3]>,
    /// The picture, 8-bit red, green and blue.
    pub rgb: Vec<u8>,
    /// Words of the base format to the pixel of depth.
    pub words_per_pixel: f64,
}

impl Truth {
    /// Pixels at which each of so many objects is seen.
    pub fn seen(&self, objects: usize) -> Vec<u64> {
        let mut seen = vec![0; objects];
        for pixel in self.pixels.iter().flatten() {
            seen[pixel.id as usize] += 1;
        }
        seen
    }

    /// Gives objects other indices; what has none is seen all the same, as an object that no picture shows.
    pub fn renumber(&mut self, indices: &[Option<u32>]) {
        for pixel in self.pixels.iter_mut().flatten() {
            pixel.id = indices[pixel.id as usize].unwrap_or(NO_OBJECT);
        }
    }

    /// Takes planes with these indices out of an object: those behind them move up, and a point of theirs is seen all
    /// the same, as one of a face that no picture shows.
    pub fn renumber_planes(&mut self, object: u32, out: &[usize]) {
        let planes = FACE_PLANE..FACE_NEAR_END;
        let is_of_plane = |pixel: &ExactPixel| pixel.id == object && planes.contains(&pixel.number);
        let pixels = self.pixels.iter_mut().flatten();
        for pixel in pixels.filter(|pixel| is_of_plane(pixel)) {
            let plane = usize::from(pixel.number - FACE_PLANE);
            pixel.number = match out.contains(&plane) {
                true => NO_FACE,
                false => pixel.number - out.iter().filter(|out| **out < plane).count() as u8,
            };
        }
    }

    /// The format whose words the depths are in.
    pub const FORMAT: Format = Format::BASE;

    /// Solves a scene; `line_done` is called once a line, from any thread.
    pub fn new(scene: &FramedScene, line_done: impl Fn() + Sync) -> Truth {
        let format = Self::FORMAT;
        let pixels = render(scene, &format, line_done);
        let frame = to_frame(&pixels, scene, &format);
        let lighting = match scene.sources.iter().any(|s| s.shadows || s.cone.is_some()) {
            true => shadow::lighting(scene, || ()),
            false => Lighting::full(&frame),
        };
        let rgb = shade(&frame, &lighting, scene, &format);
        let scale = integer(format.z_max()) / scene.projection.full();
        Truth {
            width: scene.width as usize,
            height: scene.height as usize,
            backs: backs(&pixels, scene, &format),
            normals: directions(&pixels, scene, &format),
            rgb,
            words_per_pixel: to_f64(&scale),
            pixels,
        }
    }

    /// Pixels that show an object.
    pub fn covered(&self) -> usize {
        self.pixels.iter().flatten().count()
    }
}
