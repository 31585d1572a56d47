//! A cut quadric on the screen: its expressions, its box, and why nothing of it may be there.

use super::context::Context;
use super::depth::Depth;
use super::error::PrepareError;
use super::extent::Extent;
use super::memo::Few;
use super::perspective::{ScreenQuadric, on_screen};
use super::planes::{PlacedPlane, PreparedPlane, constant_normal};
use super::rounding::Anchor;
use super::screen_box::{Region, Search, screen_between};
use super::seams::Place;
use crate::cell::Cell;
use imogene_algebra::rational::to_f64;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::normal::NormalWords;
use imogene_scene::{FramedQuadric, Plane};
use num_bigint::BigInt;
use num_traits::Zero;
use std::sync::OnceLock;

pub(super) struct Projected {
    pub quadric: ScreenQuadric,
    pub planes: Vec<PlacedPlane>,
    pub region: Region,
    pub window: ScreenBox,
    pub depth: Depth,
    /// Of the depth word, that of a component, the pixel of rounding and the greatest root.
    pub normals: Few<(u32, u32, Anchor, BigInt), (NormalWords, f64)>,
    // Found when first asked for, and the same in any words.
    depths: OnceLock<(f64, f64)>,
    unseen: OnceLock<&'static str>,
}

impl Projected {
    pub fn new(object: &FramedQuadric, context: &Context) -> Projected {
        let (quadric, planes) =
            on_screen(&object.quadric, &object.planes, &context.inverse_distance);
        let region = Region::new(&quadric.q, &planes, object.surface);
        // Of an uncut closed quadric from its tangent planes, else by search.
        let depth = to_f64(&context.full_depth);
        let searched = || region.screen_box(context.width, context.height, depth);
        let window = tangent_box(&quadric, &planes, context).unwrap_or_else(searched);
        Projected {
            window,
            quadric,
            planes: planes.into_iter().map(PlacedPlane::of).collect(),
            region,
            depth: Depth::default(),
            normals: Few::default(),
            depths: OnceLock::new(),
            unseen: OnceLock::new(),
        }
    }

    /// Least and greatest depth, in pixels, at which the object can be met on the screen; those of the depth word if it
    /// cannot.
    pub fn depths(&self, context: &Context) -> (f64, f64) {
        *self.depths.get_or_init(|| {
            let full = to_f64(&context.full_depth);
            let domain = screen_between(context.width, context.height, [-full, full]);
            let range = self.region.range_within(domain, 2, Search::FINE);
            range.unwrap_or((-full, full))
        })
    }
}

/// A cut quadric that is prepared: what it is, where it is on the screen, and for what.
#[derive(Clone, Copy)]
pub(super) struct Subject<'a> {
    pub object: &'a FramedQuadric,
    pub projected: &'a Projected,
    pub place: &'a Place,
    pub context: &'a Context,
}

impl<'a> Subject<'a> {
    /// Why nothing of the object is on the screen.
    pub fn unseen_note(&self) -> &'static str {
        let unseen = &self.projected.unseen;
        unseen.get_or_init(|| unseen_note(self.object, self.context))
    }

    /// Every plane of the object, in the order of the file.
    pub fn planes(self) -> impl Iterator<Item = Result<PreparedPlane, PrepareError>> + use<'a> {
        let (object, projected) = (self.object, self.projected);
        let planes = object.planes.iter().zip(&projected.planes);
        let planes = planes.zip(&self.place.planes).enumerate();
        planes.map(move |(index, ((original, placed), shared))| {
            let depths = || projected.depths(self.context);
            let plane = placed.words((&projected.window, shared), depths, self.context);
            let refusal = |steep| PrepareError::SteepPlane(object.name.clone(), index, steep);
            let mut plane = plane.map_err(refusal)?;
            plane.words.normal = constant_normal(original, self.context.format.greatest_normal());
            Ok(plane)
        })
    }
}

/// The box of an uncut closed quadric within the screen and the depths; nothing for any other.
pub(super) fn tangent_box(
    quadric: &ScreenQuadric,
    planes: &[Plane],
    context: &Context,
) -> Option<ScreenBox> {
    let depth = to_f64(&context.full_depth);
    let is_whole = planes.is_empty() && !quadric.eye_value().is_zero();
    let extent = is_whole.then(|| Extent::of(&quadric.q)).flatten()?;
    extent.screen_box(context.width, context.height, depth)
}

/// Why nothing of an object is on the screen.
pub(super) fn unseen_note(object: &FramedQuadric, context: &Context) -> &'static str {
    if !context.perspective || !is_empty_between(object, -1.0, 64.0, context) {
        "outside the screen or its depth range: nothing to draw"
    } else if is_empty_between(object, -64.0, -1.0, context) {
        "its planes leave nothing of it: nothing to draw"
    } else {
        // It can only be seen from a camera that looks the other way.
        "lies wholly behind the viewer, who looks from `eye` towards `target`: nothing to draw"
    }
}

/// True if a search of the space between two depths of the camera frame (in viewer distances; the eye is at -1), out
/// to many viewer distances sideways, proves that nothing of the object is there.
fn is_empty_between(object: &FramedQuadric, near: f64, far: f64, context: &Context) -> bool {
    let distance = to_f64(&context.full_depth);
    let side = 64.0 * distance;
    let cell = Cell::between(
        [-side, -side, near * distance],
        [side, side, far * distance],
    );
    let region = Region::new(&object.quadric, &object.planes, object.surface);
    !region.may_be_in(cell, [1e-3 * distance; 3])
}
