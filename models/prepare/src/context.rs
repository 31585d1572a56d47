//! How a scene is prepared, and what all its objects share.

use super::error::PrepareError;
use super::forms::{LinearForm, QuadraticForm};
use super::rounding::Anchor;
use imogene_algebra::rational::{floor, integer};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_scene::{DepthRange, FramedScene, Projection};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

/// How to prepare; the default is what a machine uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Pixel about which coefficients are rounded; if not given, the middle of the box of the object, or of all cut
    /// objects that have the expression in common.
    pub anchor: Option<Anchor>,
    /// Which objects that the eye lies on have words for the quotient processor; others are refused.
    pub quotients: Quotients,
    /// Leave out what cannot be drawn, and name it, in the place of refusing the scene.
    pub without_refused: bool,
}

/// What has words for the quotient processor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quotients {
    /// What the eye lies on, or nearly so.
    #[default]
    All,
    /// What has one depth on every line of sight: the hardware draws no other.
    OfOneDepth,
    /// Nothing.
    Refused,
}

impl Options {
    /// For machines that have quadric and patch processors alone.
    pub const ROOTS: Options = Options::with(Quotients::Refused);
    /// For machines that have the processors that there are in hardware.
    pub const HARDWARE: Options = Options::with(Quotients::OfOneDepth);

    const fn with(quotients: Quotients) -> Options {
        Options {
            anchor: None,
            quotients,
            without_refused: false,
        }
    }
}

#[derive(Clone, PartialEq)]
pub(super) struct Context {
    pub format: Format,
    pub width: u32,
    pub height: u32,
    pub options: Options,
    /// 1/D, or zero for an orthographic view: the one number in which the two projections differ.
    pub inverse_distance: BigRational,
    pub full_depth: BigRational,
    pub depth_scale: BigRational,
    pub perspective: bool,
    /// Without the objects that it cuts.
    pub range: DepthRange,
}

impl Context {
    pub fn of(scene: &FramedScene, format: Format, options: Options) -> Context {
        let full_depth = scene.projection.full().clone();
        let perspective = matches!(scene.projection, Projection::Perspective { .. });
        Context {
            format,
            width: scene.width,
            height: scene.height,
            options,
            inverse_distance: match perspective {
                true => full_depth.recip(),
                false => BigRational::zero(),
            },
            depth_scale: integer(format.z_max()) / &full_depth,
            full_depth,
            perspective,
            range: scene.range.scaled(0),
        }
    }

    /// The pixel about which an expression is rounded that counts in a box.
    pub fn anchor_of(&self, window: &ScreenBox) -> Anchor {
        let given = self.options.anchor;
        given.unwrap_or_else(|| Anchor::middle_of(window))
    }

    /// From screen coordinates with the principal point as origin to pixel columns and lines.
    pub fn to_pixels_linear(&self, form: &LinearForm) -> LinearForm {
        let (x, y) = self.first_pixel();
        form.about(&x, &y)
    }

    pub fn to_pixels_quadratic(&self, form: &QuadraticForm) -> QuadraticForm {
        let (x, y) = self.first_pixel();
        form.about(&x, &y)
    }

    /// Where pixel (0, 0) samples the screen plane.
    pub fn first_pixel(&self) -> (BigRational, BigRational) {
        let half = |n: u32| -integer(i64::from(n)) / integer(2);
        (half(self.width), half(self.height))
    }

    /// The pixels of the screen with columns x0 to x1 and lines y0 to y1, both ends included.
    pub fn pixels_between(&self, [x0, x1, y0, y1]: [BigRational; 4]) -> ScreenBox {
        let within = |value: BigInt, size: u32| {
            let last = i64::from(size);
            value
                .clamp(BigInt::from(-1), BigInt::from(last))
                .to_i64()
                .unwrap_or(-1)
        };
        let first = |value: BigRational, size| within(value.ceil().to_integer(), size).max(0);
        let last = |value: BigRational, size| within(floor(&value), size).min(i64::from(size) - 1);
        let columns = [first(x0, self.width), last(x1, self.width)];
        let lines = [first(y0, self.height), last(y1, self.height)];
        ScreenBox::of(columns, lines).or_empty()
    }

    /// Refuses an object that neither a quadric nor a patch processor draws: fitted machines have those alone.
    pub fn refuse_fitted(&self, object: &str) -> Result<(), PrepareError> {
        match self.format.follows_depth_word() {
            true => Ok(()),
            false => Err(PrepareError::NotFitted(object.to_owned())),
        }
    }
}
