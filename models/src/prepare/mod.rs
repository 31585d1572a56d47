//! Preparation: from a framed scene to the coefficient words that the golden model and the hardware are loaded with.
//!
//! Exact rationals all the way, rounded once ([`rounding`]); every accumulator is proven to hold its value on the object's screen box, or the
//! object is refused by name ([`error`]).

pub mod error;
pub mod forms;
mod object;
pub mod perspective;
mod planes;
pub mod rounding;
pub mod screen_box;

use crate::format::Format;
use crate::object::quadric::QuadricWords;
use crate::rational::integer;
use crate::scene::{FramedScene, Projection};
use error::PrepareError;
use forms::{LinearForm, QuadraticForm};
use num_rational::BigRational;
use rayon::prelude::*;
use rounding::Anchor;
use serde::Serialize;

/// A scene as a machine of a format is loaded with it.
#[derive(Clone, Debug)]
pub struct PreparedScene {
    /// Widths of the machine.
    pub format: Format,
    /// Pixels per line.
    pub width: u32,
    /// Lines.
    pub height: u32,
    /// Depth words per pixel of depth: the scale that all depths of the scene share.
    pub depth_scale: BigRational,
    /// The objects in the order of the scene; the index is the id.
    pub objects: Vec<PreparedObject>,
}

/// One object: words, and what is known of them.
#[derive(Clone, Debug)]
pub struct PreparedObject {
    /// Name in the scene.
    pub name: String,
    /// Coefficient words for the whole screen; [`QuadricWords::for_zone`] gives those of a zone.
    pub words: QuadricWords,
    /// The unrounded expressions.
    pub exact: ExactForms,
    /// Greatest error of each expression on the screen box.
    pub bounds: RoundingBounds,
    /// Bits that each accumulator needs on the screen box.
    pub needed: NeededWidths,
    /// What a person should know: edge-on, off screen, seen from inside, perpendicular planes.
    pub notes: Vec<String>,
}

/// The expressions in depth words without guard bits, before rounding, in pixel columns and lines.
#[derive(Clone, Debug)]
pub struct ExactForms {
    /// Linear part of the depth.
    pub f1: LinearForm,
    /// Discriminant part of the depth.
    pub f2: QuadraticForm,
    /// Depth or half-plane value of each plane.
    pub planes: Vec<LinearForm>,
}

/// Greatest distance of each rounded expression from the exact one on the screen box, in the last bit of the word without guard bits.
///
/// These are maxima of the true residuals of the coefficients, exact and then rounded up to `f64`. The guard bits, which f1 and f2 drop
/// downwards at the outputs of their processors, take up to `dropped_f1` and `dropped_f2` more.
#[derive(Clone, Debug, Default, Serialize)]
pub struct RoundingBounds {
    /// Of f1 with its guard bits.
    pub f1: f64,
    /// Of f2 with its guard bits.
    pub f2: f64,
    /// Of each plane.
    pub planes: Vec<f64>,
    /// Of the linear part of each normal component: the greatest of the three.
    pub normal: f64,
    /// Most that dropping the guard bits takes from f1: `1 - 2^-g1`.
    pub dropped_f1: f64,
    /// Most that dropping the guard bits takes from f2: `1 - 2^-g2`. The root does not feel it: `floor(sqrt(floor(q))) = floor(sqrt(q))`.
    pub dropped_f2: f64,
}

impl RoundingBounds {
    /// Bounds of a format before any coefficient is known: only the guard bits that it drops.
    pub fn of_format(format: &Format) -> RoundingBounds {
        let dropped = |guards: u32| 1.0 - 0.5f64.powi(guards as i32);
        RoundingBounds {
            dropped_f1: dropped(format.guard_linear),
            dropped_f2: dropped(format.guard_quadratic),
            ..RoundingBounds::default()
        }
    }
}

/// Two's complement bits, guard bits not counted, that hold the true value on every pixel of the screen box.
#[derive(Clone, Debug, Default, Serialize)]
pub struct NeededWidths {
    /// f1 - r and f1 + r.
    pub sum: u32,
    /// f2.
    pub quadratic: u32,
    /// The widest plane.
    pub plane: u32,
}

/// How to prepare; the default is what a machine uses.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Pixel about which coefficients are rounded; the middle of each object's box if not given.
    pub anchor: Option<Anchor>,
}

/// What all objects of a scene share.
struct Context {
    format: Format,
    width: u32,
    height: u32,
    options: Options,
    inverse_distance: BigRational,
    full_depth: BigRational,
    depth_scale: BigRational,
    perspective: bool,
}

impl Context {
    /// From screen coordinates with the principal point as origin to pixel columns and lines.
    fn to_pixels_linear(&self, form: &LinearForm) -> LinearForm {
        let (x, y) = self.first_pixel();
        form.about(&x, &y)
    }

    fn to_pixels_quadratic(&self, form: &QuadraticForm) -> QuadraticForm {
        let (x, y) = self.first_pixel();
        form.about(&x, &y)
    }

    /// Where pixel (0, 0) samples the screen plane.
    fn first_pixel(&self) -> (BigRational, BigRational) {
        let half = |n: u32| -integer(i64::from(n)) / integer(2);
        (half(self.width), half(self.height))
    }
}

/// Prepares a scene for a format.
pub fn prepare(scene: &FramedScene, format: Format) -> Result<PreparedScene, PrepareError> {
    prepare_with(scene, format, Options::default())
}

/// Prepares a scene with options.
pub fn prepare_with(
    scene: &FramedScene,
    format: Format,
    options: Options,
) -> Result<PreparedScene, PrepareError> {
    let full_depth = perspective::full_depth(&scene.projection);
    let context = Context {
        format,
        width: scene.width,
        height: scene.height,
        options,
        inverse_distance: perspective::inverse_distance(&scene.projection),
        depth_scale: integer(format.z_max()) / &full_depth,
        full_depth,
        perspective: matches!(scene.projection, Projection::Perspective { .. }),
    };
    // Collected before the first error is taken, so that the same object is named in every run.
    let objects: Vec<Result<PreparedObject, PrepareError>> = scene
        .objects
        .par_iter()
        .map(|object| object::prepare_object(object, &context))
        .collect();
    Ok(PreparedScene {
        format,
        width: scene.width,
        height: scene.height,
        depth_scale: context.depth_scale,
        objects: objects.into_iter().collect::<Result<_, _>>()?,
    })
}
