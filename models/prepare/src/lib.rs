//! Preparation: from a framed scene to the coefficient words that the golden model and the hardware are loaded with.
//!
//! Exact rationals all the way, rounded once ([`rounding`]); every accumulator is proven to hold its value on the
//! object's screen box, or the object is refused by name ([`error`]).

mod again;
pub mod animator;
mod curved_facet;
mod enclosure;
pub mod error;
pub mod extent;
mod first_generation;
pub mod forms;
mod ledger;
mod located;
pub mod memory;
mod mesh;
mod object;
mod parts;
pub mod perspective;
mod planes;
mod polyhedron;
mod quotient;
pub(crate) mod range;
mod round;
pub mod rounding;
pub mod screen_box;
mod seams;
pub mod shader;
mod unseen;
pub mod volume;
mod witness;

use again::Known;
pub use again::{Kept, Reuse, prepare_again};
use error::PrepareError;
use forms::{LinearForm, QuadraticForm};
use imogene_algebra::rational::{floor, integer};
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_golden::machine::fitted::{FittedMachine, FittedSlot};
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::{Lighting, light};
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::object::slot::Slot;
use imogene_golden::object::volume::VolumeWords;
use imogene_golden::unit::interval::Class;
use imogene_golden::unit::root::fast_root;
use imogene_scene::{CutOff, DepthRange, End, FramedScene, Projection};
use located::Located;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
pub use parts::{NeededWord, PreparedObject, PreparedParts};
pub use range::Framing;
use rayon::prelude::*;
use rounding::Anchor;
use serde::Serialize;
pub use unseen::Seen;
use volume::{PreparedVolume, Volumes, prepare_volumes};

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
    /// Shadow volumes and the light volumes of spots, in the order of sources and objects.
    pub volumes: Vec<PreparedVolume>,
    /// What is left out of a picture that is drawn without what cannot be prepared ([`Options::without_refused`]),
    /// objects first.
    pub missing: Vec<Missing>,
}

/// What is left out of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Missing {
    /// True if only a shadow or a cone is missing.
    pub is_volume: bool,
    /// Why.
    pub reason: PrepareError,
}

impl PreparedScene {
    /// The processors of a machine that draws the scene, in the order of the objects.
    pub fn slots(&self) -> Vec<Slot> {
        let of = |(object, prepared): (usize, &PreparedObject)| {
            let slot = move |words| Slot { object, words };
            prepared.words().into_iter().map(slot)
        };
        self.objects.iter().enumerate().flat_map(of).collect()
    }

    /// The words of its volumes.
    pub fn volume_words(&self) -> Vec<&VolumeWords> {
        self.volumes.iter().map(|volume| &volume.words).collect()
    }

    /// The flags that its volumes leave of a frame; `line_done` is called once a line, from any thread.
    pub fn light(&self, frame: &Frame, line_done: impl Fn() + Sync) -> Lighting {
        light(frame, &self.volume_words(), &self.format, line_done)
    }

    /// The machine of quadric processors that it requires, with its format.
    pub fn fitted_machine(&self, rows_per_stage: u32) -> FittedMachine {
        let slots = self.quadrics();
        FittedMachine {
            widths: self.format.widths(),
            rows_per_stage,
            slots: slots.map(|(_, o)| FittedSlot::of(&o.words)).collect(),
        }
    }

    /// The bits that its objects of the quadric and the patch processor need, and its shadow and light volumes.
    pub fn needed(&self) -> NeededWidths {
        let objects = self.quadrics().map(|(_, object)| &object.needed);
        let volumes = self.volumes.iter().map(|volume| &volume.needed);
        let all = objects.chain(volumes);
        all.fold(NeededWidths::default(), |most, one| most.or(one))
    }

    /// The objects of the quadric and the patch processor, the only ones with bounds; the index is the id.
    pub fn quadrics(&self) -> impl Iterator<Item = (usize, &PreparedQuadric)> {
        let objects = self.objects.iter().enumerate();
        objects.filter_map(|(id, object)| Some((id, object.quadric()?)))
    }
}

/// One object of the quadric or the patch processor: words, and what is known of them.
#[derive(Clone, Debug)]
pub struct PreparedQuadric {
    /// Name in the scene.
    pub name: String,
    /// Coefficient words for the whole screen; [`QuadricWords::for_zone`] gives those of a zone.
    pub words: QuadricWords,
    /// The unrounded expressions.
    pub exact: ExactForms,
    /// Pixel about which f1 and f2 were rounded: the middle of the box, or of all boxes of objects that share the
    /// quadric.
    pub anchor: Anchor,
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

/// Greatest distance of each rounded expression from the exact one on the screen box, in the last bit of the word
/// without guard bits.
///
/// These are maxima of the true residuals of the coefficients, exact and then rounded up to `f64`. The guard bits,
/// which f1 and f2 drop downwards at the outputs of their processors, take up to `dropped_f1` and `dropped_f2` more.
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
    /// Most that dropping the guard bits takes from f2: `1 - 2^-g2`. The root does not feel it:
    /// `floor(sqrt(floor(q))) = floor(sqrt(q))`.
    pub dropped_f2: f64,
    /// Binary places of the product `K r` below the last bit of a normal's linear part.
    pub product_fraction: u32,
    /// Last digits of the root that are not computed.
    pub dropped_rows: u32,
}

impl RoundingBounds {
    /// The root that the network finds of a computed f2.
    pub fn root_of(&self, f2: i64) -> i64 {
        fast_root(f2.max(0)) >> self.dropped_rows << self.dropped_rows
    }

    /// Bounds of a format before any coefficient is known: only the guard bits that it drops.
    pub fn of_format(format: &Format) -> RoundingBounds {
        let dropped = |guards: u32| 1.0 - 0.5f64.powi(guards as i32);
        RoundingBounds {
            dropped_f1: dropped(format.guard_linear),
            dropped_f2: dropped(format.guard_quadratic),
            product_fraction: format.product_fraction(),
            dropped_rows: format.dropped_rows,
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

impl NeededWidths {
    /// The greater of each.
    pub fn or(&self, other: &NeededWidths) -> NeededWidths {
        NeededWidths {
            sum: self.sum.max(other.sum),
            quadratic: self.quadratic.max(other.quadratic),
            plane: self.plane.max(other.plane),
        }
    }

    /// The narrowest words of a fitted machine that hold what is needed; the others are those of `wide`.
    pub fn narrowed(&self, wide: &MachineWords) -> MachineWords {
        let least = 4.max(wide.dropped_rows + 1);
        MachineWords {
            root: self.quadratic.div_ceil(2).max(least).min(wide.root),
            plane: self.plane.clamp(wide.depth, wide.plane),
            ..*wide
        }
    }
}

/// How to prepare; the default is what a machine uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Pixel about which coefficients are rounded; if not given, the middle of the box of the object, or of all cut
    /// objects that have the expression in common.
    pub anchor: Option<Anchor>,
    /// Refuse what a quadric or patch processor cannot draw because the eye lies on it, in the place of words for the
    /// quotient processor.
    pub roots_only: bool,
    /// Leave out what cannot be drawn, and name it, in the place of refusing the scene.
    pub without_refused: bool,
}

impl Options {
    /// For machines that have quadric and patch processors alone.
    pub const ROOTS: Options = Options {
        anchor: None,
        roots_only: true,
        without_refused: false,
    };
}

/// What all objects of a scene share.
#[derive(Clone, PartialEq)]
struct Context {
    format: Format,
    width: u32,
    height: u32,
    options: Options,
    inverse_distance: BigRational,
    full_depth: BigRational,
    depth_scale: BigRational,
    perspective: bool,
    /// Without the objects that it cuts.
    range: DepthRange,
}

impl Context {
    fn of(scene: &FramedScene, format: Format, options: Options) -> Context {
        let full_depth = perspective::full_depth(&scene.projection);
        Context {
            format,
            width: scene.width,
            height: scene.height,
            options,
            inverse_distance: perspective::inverse_distance(&scene.projection),
            depth_scale: integer(format.z_max()) / &full_depth,
            full_depth,
            perspective: matches!(scene.projection, Projection::Perspective { .. }),
            range: scene.range.scaled(0),
        }
    }

    /// The pixel about which an expression is rounded that counts in a box.
    fn anchor_of(&self, window: &ScreenBox) -> Anchor {
        let given = self.options.anchor;
        given.unwrap_or_else(|| Anchor::middle_of(window))
    }

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

    /// The pixels of the screen with columns x0 to x1 and lines y0 to y1, both ends included.
    fn pixels_between(&self, [x0, x1, y0, y1]: [BigRational; 4]) -> ScreenBox {
        let within = |value: BigInt, size: u32| {
            let last = i64::from(size);
            value
                .clamp(BigInt::from(-1), BigInt::from(last))
                .to_i64()
                .unwrap_or(-1)
        };
        let first = |value: BigRational, size| within(value.ceil().to_integer(), size).max(0);
        let last = |value: BigRational, size| within(floor(&value), size).min(i64::from(size) - 1);
        let found = ScreenBox {
            x0: first(x0, self.width),
            x1: last(x1, self.width),
            y0: first(y0, self.height),
            y1: last(y1, self.height),
        };
        if found.is_empty() {
            ScreenBox::EMPTY
        } else {
            found
        }
    }
}

/// The positive factor that turns all coefficients into integers without a common divisor.
fn integer_scale<const N: usize>(coefficients: [&BigRational; N]) -> BigRational {
    let denominator = coefficients
        .iter()
        .fold(BigInt::one(), |acc, c| acc.lcm(c.denom()));
    let content = coefficients.iter().fold(BigInt::zero(), |acc, c| {
        acc.gcd(&(c.numer() * (&denominator / c.denom())))
    });
    if content.is_zero() {
        BigRational::one()
    } else {
        BigRational::new(denominator, content)
    }
}

/// The note on an object of which something lies before the range of the depth word.
const NEAR_END_CUTS: &str = "reaches nearer than the near end of the depth: what is nearer is cut off, and a solid is seen open there";
/// The same behind it.
const FAR_END_CUTS: &str =
    "reaches farther than the far end of the depth: what is farther is cut off";

/// Prepares a scene for a format.
pub fn prepare(scene: &FramedScene, format: Format) -> Result<PreparedScene, PrepareError> {
    prepare_with(scene, format, Options::default())
}

/// Prepares a scene for machines that have quadric and patch processors alone, so that an object that the eye lies on
/// is refused.
pub fn prepare_for_roots(
    scene: &FramedScene,
    format: Format,
) -> Result<PreparedScene, PrepareError> {
    prepare_with(scene, format, Options::ROOTS)
}

/// Prepares a scene with options.
pub fn prepare_with(
    scene: &FramedScene,
    format: Format,
    options: Options,
) -> Result<PreparedScene, PrepareError> {
    prepare_reporting(scene, format, options, &|| ())
}

/// The objects that cannot be prepared for a format, by index, each with its reason; shadows are not looked at.
pub fn refused(
    scene: &FramedScene,
    format: Format,
    options: Options,
) -> Vec<(usize, PrepareError)> {
    let context = Context::of(scene, format, options);
    let located = Located::new(scene, &context, &Known::nothing(scene));
    let problem = |(index, object)| Some((index, located.prepare(index, object, &context).err()?));
    let objects = scene.objects.par_iter().enumerate();
    objects.filter_map(problem).collect()
}

/// Steps of a preparation, for a bar of its progress.
pub fn steps(scene: &FramedScene) -> u64 {
    (scene.objects.len() + volume::pairs(scene).len()) as u64
}

/// Prepares a scene; `done` is called about once for each of [`steps`], from any thread.
pub fn prepare_reporting(
    scene: &FramedScene,
    format: Format,
    options: Options,
    done: &(impl Fn() + Sync),
) -> Result<PreparedScene, PrepareError> {
    let context = Context::of(scene, format, options);
    let known = Known::nothing(scene);
    let located = Located::new(scene, &context, &known);
    let mut missing = vec![];
    let mut objects = prepare_objects(scene, &located, &context, &known, &mut missing, done)?;
    let volumes = prepare_volumes(scene, &mut objects, &context, &known, &mut missing, done)?;
    Ok(prepared_scene(scene, context, objects, volumes, missing))
}

/// The objects, those that are known taken over.
fn prepare_objects(
    scene: &FramedScene,
    located: &Located,
    context: &Context,
    known: &Known,
    missing: &mut Vec<Missing>,
    done: &(impl Fn() + Sync),
) -> Result<Vec<PreparedObject>, PrepareError> {
    // Collected before the first error is taken, so that the same object is named in every run.
    let objects: Vec<Result<PreparedObject, Box<PrepareError>>> = scene
        .objects
        .par_iter()
        .enumerate()
        .map(|(index, object)| {
            let prepared = match known.object(index) {
                Some(known) => Ok(known.clone()),
                None => located.prepare(index, object, context).map_err(Box::new),
            };
            done();
            prepared
        })
        .collect();
    let named = objects.into_iter().zip(&scene.objects);
    named
        .map(|(prepared, object)| {
            prepared.or_else(|reason| {
                leave_out(context, missing, false, *reason)?;
                let note = "left out: it cannot be drawn";
                let absent = object::absent(object.name(), Class::default(), note);
                Ok(PreparedObject::Quadric(Box::new(absent)))
            })
        })
        .collect()
}

/// Records what is left out, or refuses the scene.
fn leave_out(
    context: &Context,
    missing: &mut Vec<Missing>,
    is_volume: bool,
    reason: PrepareError,
) -> Result<(), PrepareError> {
    if !context.options.without_refused {
        return Err(reason);
    }
    missing.push(Missing { is_volume, reason });
    Ok(())
}

fn prepared_scene(
    scene: &FramedScene,
    context: Context,
    mut objects: Vec<PreparedObject>,
    volumes: Volumes,
    missing: Vec<Missing>,
) -> PreparedScene {
    for CutOff { object, end } in &scene.range.cut {
        let cut = objects.iter_mut().find(|o| o.name() == object);
        if let Some(cut) = cut.filter(|o| !o.screen_box().is_empty()) {
            cut.add_note(match end {
                End::Near => NEAR_END_CUTS,
                End::Far => FAR_END_CUTS,
            });
        }
    }
    PreparedScene {
        missing,
        format: context.format,
        width: context.width,
        height: context.height,
        depth_scale: context.depth_scale,
        objects,
        volumes: volumes.into_list(),
    }
}
