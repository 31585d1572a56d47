//! A scene by the golden model and by the exact reference, to be compared pixel by pixel.

use imogene_analysis::bounds::depth_bound;
use imogene_analysis::exact::render::{DEPTH_FRACTION, ExactPixel, directions, render};
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_prepare::error::PrepareError;
use imogene_prepare::{Framing, PreparedQuadric, PreparedScene, prepare};
use imogene_scene::{FramedScene, SceneFile};
use imogene_testkit::angle_deg;

/// Parts of a depth word in which the exact depth is cut.
pub const UNIT: f64 = (1u32 << DEPTH_FRACTION) as f64;

pub struct Pictures {
    pub scene: FramedScene,
    pub prepared: PreparedScene,
    pub golden: Frame,
    pub exact: Vec<Option<ExactPixel>>,
}

impl Pictures {
    pub fn of(scene: FramedScene, format: Format) -> Result<Pictures, PrepareError> {
        let prepared = prepare(&scene, format)?;
        let exact = render(&scene, &format, || ());
        Ok(Pictures::with(scene, prepared, exact))
    }

    pub fn of_file(file: &SceneFile, (width, height): (u32, u32), format: Format) -> Pictures {
        let scene = file.frame(width, height).expect("a valid size");
        Pictures::of(scene, format).expect("fits")
    }

    pub fn with(
        scene: FramedScene,
        prepared: PreparedScene,
        exact: Vec<Option<ExactPixel>>,
    ) -> Pictures {
        let golden = prepared.frame(|| ());
        Pictures {
            scene,
            prepared,
            golden,
            exact,
        }
    }

    pub fn exact_face(&self, index: usize) -> (i32, u8) {
        self.exact[index].map_or((-1, 0), |e| (e.id as i32, e.number))
    }

    pub fn golden_face(&self, index: usize) -> (i32, u8) {
        (self.golden.id[index], self.golden.number[index])
    }

    /// The pixels at which the pictures show different faces.
    pub fn differing(&self) -> impl Iterator<Item = usize> {
        let differs = |i: &usize| self.exact_face(*i) != self.golden_face(*i);
        (0..self.exact.len()).filter(differs)
    }

    /// The pixels at which both show the same face.
    pub fn seen(&self) -> impl Iterator<Item = (usize, ExactPixel)> {
        let same = |i: &usize| self.exact_face(*i) == self.golden_face(*i);
        let same = (0..self.exact.len()).filter(same);
        same.filter_map(|i| Some((i, self.exact[i]?)))
    }

    /// Golden less exact depth at a pixel, in depth words.
    pub fn depth_error(&self, index: usize, exact: &ExactPixel) -> f64 {
        self.golden.depth[index] as f64 - exact.depth as f64 / UNIT
    }

    /// Those of the pixels at which both show the same face.
    pub fn depth_errors(&self) -> impl Iterator<Item = (usize, f64)> {
        self.seen()
            .map(|(i, exact)| (i, self.depth_error(i, &exact)))
    }

    /// Angles between golden and exact normal at these pixels in degrees, with the object.
    pub fn normal_errors(&self) -> Vec<(i32, f64)> {
        let exact = directions(&self.exact, &self.scene, &self.prepared.format);
        let golden = |i: usize| self.golden.normal[i].map(f64::from);
        let angle = |(i, _)| (self.golden.id[i], angle_deg(golden(i), exact[i]));
        self.seen().map(angle).collect()
    }

    pub fn place(&self, index: usize) -> (i64, i64) {
        let width = self.golden.width;
        ((index % width) as i64, (index / width) as i64)
    }

    /// The pixels up to `reach` away from one, itself among them, as far as the picture reaches.
    pub fn around(&self, index: usize, reach: i64) -> impl Iterator<Item = usize> + use<> {
        let (width, height) = (self.golden.width as i64, self.golden.height as i64);
        let (x, y) = self.place(index);
        let [columns, lines] = [(x, width), (y, height)]
            .map(|(at, size)| (at - reach).max(0)..=(at + reach).min(size - 1));
        lines.flat_map(move |v| columns.clone().map(move |u| (v * width + u) as usize))
    }

    /// The bound of the depth of a quadric seen at a pixel, if `prepared` draws it.
    pub fn depth_bound(&self, prepared: &PreparedScene, index: usize) -> f64 {
        let (object, f2) = self.quadric_at(prepared, index);
        depth_bound(object, self.golden.number[index], f2)
    }

    /// The quadric that is seen at a pixel as `prepared` draws it, and its f2 there.
    pub fn quadric_at<'a>(
        &self,
        prepared: &'a PreparedScene,
        index: usize,
    ) -> (&'a PreparedQuadric, i64) {
        let object = &prepared.objects[self.golden.id[index] as usize];
        let object = object.quadric().expect("a quadric");
        let (x, y) = self.place(index);
        (object, object.words.f2_at(x, y, &prepared.format))
    }
}
