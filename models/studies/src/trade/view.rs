//! The scene at every size that machines draw it in, with its truth.

use super::design::Accuracy;
use imogene_analysis::metrics::Truth;
use imogene_prepare::Framing;
use imogene_scene::{FramedScene, SceneError, SceneFile};
use std::sync::OnceLock;

/// Samples of a pixel along each side, of which the ideal picture is the mean.
const IDEAL: u32 = 4;
/// Sizes, in quarters of that of the picture.
const SIZES: [u32; 5] = [1, 2, 4, 8, 16];

struct View {
    /// None if the size is not a whole number of pixels.
    scene: Option<FramedScene>,
    truth: OnceLock<Truth>,
}

/// The scene at all sizes.
pub struct Views {
    views: Vec<View>,
    ideal: OnceLock<Ideal>,
}

/// The picture of a machine without any error: of every channel of every pixel the sum of all samples.
pub struct Ideal {
    sums: Vec<u32>,
}

impl Views {
    /// The scene in pictures of `width` by `height` pixels. Fails when it cannot be framed.
    pub fn new(file: &SceneFile, (width, height): (u32, u32)) -> Result<Views, SceneError> {
        let view = |quarters: u32| {
            let (width, height) = (width * quarters, height * quarters);
            let is_whole = width.is_multiple_of(4) && height.is_multiple_of(4);
            let scene = is_whole.then(|| file.frame(width / 4, height / 4));
            let (scene, truth) = (scene.transpose()?, OnceLock::new());
            Ok(View { scene, truth })
        };
        let views = SIZES.into_iter().map(view);
        Ok(Views {
            views: views.collect::<Result<_, SceneError>>()?,
            ideal: OnceLock::new(),
        })
    }

    /// The scene at the size of the pictures.
    pub fn whole(&self) -> &FramedScene {
        let scene = &self.at(4).scene;
        scene.as_ref().expect("every size is whole pixels")
    }

    /// The scene in the pixels that a machine draws; or why there is no such size.
    pub fn drawn(&self, accuracy: &Accuracy) -> Result<&FramedScene, String> {
        let quarters = 4 * accuracy.supersampling / accuracy.undersampling;
        let scene = self.at(quarters).scene.as_ref();
        scene.ok_or_else(|| {
            let (scene, part) = (self.whole(), accuracy.undersampling);
            format!(
                "a preview draws one pixel in {part} x {part}, and {} x {} is no multiple of {part}",
                scene.width, scene.height
            )
        })
    }

    /// What is truly seen at every sample, or at every pixel of a picture of fewer.
    pub fn truth(&self, accuracy: &Accuracy) -> &Truth {
        self.at(4 * accuracy.supersampling).truth()
    }

    /// The truth at the size of the pictures.
    pub fn whole_truth(&self) -> &Truth {
        self.at(4).truth()
    }

    /// The ideal picture.
    pub fn ideal(&self) -> &Ideal {
        self.ideal.get_or_init(|| {
            let truth = self.at(4 * IDEAL).truth();
            Ideal::new(&truth.rgb, truth.width, IDEAL as usize)
        })
    }

    fn at(&self, quarters: u32) -> &View {
        let place = SIZES.iter().position(|size| *size == quarters);
        &self.views[place.expect("one of the sizes")]
    }
}

impl View {
    fn truth(&self) -> &Truth {
        let scene = self.scene.as_ref().expect("the size is whole pixels");
        self.truth.get_or_init(|| Truth::new(scene, || ()))
    }
}

impl Ideal {
    /// Of a picture of samples, so many a line and `side` along each side of a pixel.
    pub fn new(rgb: &[u8], columns: usize, side: usize) -> Ideal {
        let width = columns / side;
        let mut sums = vec![0; rgb.len() / (side * side)];
        for (at, pixel) in rgb.chunks(3).enumerate() {
            let to = 3 * (at / columns / side * width + at % columns / side);
            for (sum, level) in sums[to..to + 3].iter_mut().zip(pixel) {
                *sum += u32::from(*level);
            }
        }
        Ideal { sums }
    }

    /// Root of the mean square of the differences of all channels, in percent of the whole scale.
    pub fn error(&self, rgb: &[u8]) -> f64 {
        let samples = f64::from(IDEAL * IDEAL);
        let square =
            |(level, sum): (&u8, &u32)| (f64::from(*level) - f64::from(*sum) / samples).powi(2);
        let squares: f64 = rgb.iter().zip(&self.sums).map(square).sum();
        100.0 / 255.0 * (squares / rgb.len() as f64).sqrt()
    }
}
