//! The volumes of a scene: the shadows of its objects, and what its spots light (source: 3.2.1).
//!
//! Their words are needed only where something is seen, so they are proven there: on the screen boxes and between the
//! depths of the objects.

mod found;
mod shadow;
mod words;

pub(super) use found::Found;
pub use shadow::{ShadowPart, SourceInside, shadow_parts};

use super::context::Context;
use super::error::PrepareError;
use super::extent::Extent;
use super::known::Bounds;
use super::perspective::{ScreenQuadric, on_screen};
use super::prepared::PreparedObject;
pub use super::prepared::{Beginning, PreparedVolume};
use super::run::Run;
use super::screen_box::{Region, Search, screen_between};
use crate::cell::Cell;
use found::{ShadowPlaces, VolumePlace};
use imogene_algebra::rational::to_f64;
use imogene_golden::object::volume::VolumeKind;
use imogene_scene::{FramedObject, FramedQuadric, FramedScene, Surface};
use rayon::prelude::*;
use std::slice::from_ref;
use words::{unseen, volume_words};

/// Pairs of a source and an object that a scene's preparation has to look at for shadows.
pub fn pairs(scene: &FramedScene) -> Vec<(usize, usize)> {
    let sources = scene.sources.iter().enumerate().filter(|(_, s)| s.shadows);
    sources
        .flat_map(|(source, _)| {
            let casters = scene.objects.iter().enumerate();
            let casters = casters.filter(|(_, object)| object.casts_shadow());
            casters.map(move |(object, _)| (source, object))
        })
        .collect()
}

#[derive(Clone, Debug)]
pub(super) struct Shadow {
    pub source: usize,
    pub object: usize,
    pub volumes: Vec<PreparedVolume>,
    /// Taken over from the preparation before.
    pub reused: bool,
}

/// The volumes of a scene, and what the next preparation asks of them.
#[derive(Clone, Debug, Default)]
pub(super) struct Volumes {
    pub spots: Vec<PreparedVolume>,
    pub shadows: Vec<Shadow>,
    /// Where each object is seen; empty if no volume asks for it.
    pub seen: Vec<Option<Bounds>>,
    pub receivers: Option<Cell>,
}

impl Volumes {
    /// In the order of sources and objects, spots first.
    pub fn into_list(self) -> Vec<PreparedVolume> {
        let shadows = self.shadows.into_iter().flat_map(|shadow| shadow.volumes);
        self.spots.into_iter().chain(shadows).collect()
    }
}

impl Run<'_> {
    /// The volumes of a scene whose objects are prepared, and notes on objects without a shadow.
    pub fn volumes(&mut self, objects: &mut [PreparedObject]) -> Result<Volumes, PrepareError> {
        let (scene, context) = (self.scene, self.context);
        note_what_casts_none(scene, objects, context);
        let has_spot = scene.sources.iter().any(|source| source.cone.is_some());
        let pairs = pairs(scene);
        if pairs.is_empty() && !has_spot {
            return Ok(Volumes::default());
        }
        let seen = self.seen(objects);
        let receivers = around(&seen);
        let mut volumes = Volumes {
            spots: self.spots(receivers.as_ref())?,
            shadows: vec![],
            seen,
            receivers,
        };
        let Some(receivers) = receivers else {
            return Ok(volumes);
        };
        let prepared: &[PreparedObject] = objects;
        // Collected before the first error is taken, so that the same volume is named in every run.
        let shadows = pairs.par_iter().filter_map(|&(source, object)| {
            let framed = scene.objects[object].caster();
            let casts = framed.is_none_or(|framed| why_no_shadow(framed, context).is_none());
            let found = casts.then(|| self.shadow((source, object), &prepared[object], &receivers));
            (self.done)();
            found
        });
        let shadows: Vec<Result<Shadow, PrepareError>> = shadows.collect();
        for shadow in shadows {
            match shadow {
                Ok(shadow) => volumes.shadows.push(shadow),
                Err(reason) => self.leave_out(true, reason)?,
            }
        }
        Ok(volumes)
    }

    /// The shadow of an object from a source, taken over if it is known.
    fn shadow(
        &self,
        (source, object): (usize, usize),
        prepared: &PreparedObject,
        receivers: &Cell,
    ) -> Result<Shadow, PrepareError> {
        let point = &self.scene.sources[source].point;
        let kept = self.known.shadow(source, object, point, receivers);
        let reused = kept.is_some();
        let find = || {
            let found = &self.located.found;
            let places = found.shadow(self.scene, (source, object), receivers, self.context);
            shadow(places, (source, object), prepared, self.context)
        };
        Ok(Shadow {
            source,
            object,
            volumes: kept.map_or_else(find, Ok)?,
            reused,
        })
    }

    fn spots(&mut self, receivers: Option<&Cell>) -> Result<Vec<PreparedVolume>, PrepareError> {
        let mut volumes = Vec::new();
        for (source, framed) in self.scene.sources.iter().enumerate() {
            let (Some(cone), Some(receivers)) = (&framed.cone, receivers) else {
                continue;
            };
            let name = format!("the cone of the spot lights[{source}]");
            let unseen = unseen(name, VolumeKind::Light, source, None);
            let planes = from_ref(&cone.plane);
            let place = VolumePlace::new(&cone.quadric, planes, receivers, self.context);
            match volume_words(unseen, &place, 0.0, self.context) {
                Ok(volume) => volumes.push(volume),
                Err(reason) => self.leave_out(true, reason)?,
            }
        }
        Ok(volumes)
    }

    /// Where each object is seen, those that are known taken over.
    fn seen(&self, prepared: &[PreparedObject]) -> Vec<Option<Bounds>> {
        let context = self.context;
        let full = to_f64(&context.full_depth);
        let domain = screen_between(context.width, context.height, [-full, full]);
        let objects = self.scene.objects.par_iter().zip(prepared).enumerate();
        let seen = objects.map(|(index, (object, prepared))| {
            if let Some(known) = self.known.objects[index].and_then(|kept| kept.seen) {
                return known;
            }
            let b = prepared.screen_box();
            if b.is_empty() {
                return None;
            }
            let find = || depths(object, domain, context);
            let (near, far) = self.located.found.depths.get(index, find)?;
            let at = |pixel: i64, size: u32| pixel as f64 - 0.5 * f64::from(size);
            let low = [at(b.x0, context.width), at(b.y0, context.height), near];
            let high = [at(b.x1, context.width), at(b.y1, context.height), far];
            Some((low, high))
        });
        seen.collect()
    }
}

/// Where a source has shadows, says of every object that casts none, and was not told so, why.
fn note_what_casts_none(scene: &FramedScene, objects: &mut [PreparedObject], context: &Context) {
    if !scene.sources.iter().any(|source| source.shadows) {
        return;
    }
    for (object, prepared) in scene.objects.iter().zip(objects) {
        let why = match object {
            FramedObject::Quadric(q) | FramedObject::Patch(q) | FramedObject::Polyhedron(q) => {
                why_no_shadow(q, context)
            }
            FramedObject::FirstGeneration(q) | FramedObject::CurvedFacet(q) if !q.casts_shadow => {
                None
            }
            FramedObject::Mesh(_) => None,
            _ => Some(
                "casts no shadow: there are no shadow volumes of what its processor draws; \
                 quadrics, patches, polyhedra and meshes cast shadows",
            ),
        };
        if let Some(why) = why {
            prepared.add_note(why);
        }
    }
}

/// Why a quadric, a patch or a polyhedron that should cast a shadow casts none.
fn why_no_shadow(object: &FramedQuadric, context: &Context) -> Option<&'static str> {
    if !object.casts_shadow || object.surface == Surface::Solid {
        return None;
    }
    if !object.planes.is_empty() {
        return Some(
            "casts no shadow: the shadow of a cut patch is no union of volumes; \
             mode = \"solid\" casts one, casts_shadow = false says that none is wanted",
        );
    }
    let quadric = ScreenQuadric::new(&object.quadric, &context.inverse_distance);
    let outside = num_traits::Signed::is_positive(quadric.eye_value());
    (!outside).then_some("casts no shadow: the viewer is inside this patch")
}

fn shadow(
    places: ShadowPlaces,
    (source, object): (usize, usize),
    prepared: &PreparedObject,
    context: &Context,
) -> Result<Vec<PreparedVolume>, PrepareError> {
    let name = prepared.name();
    let inside = |_| PrepareError::SourceInside(name.to_owned(), source);
    let parts = places.map_err(inside)?;
    let count = parts.len();
    let mut volumes = Vec::new();
    for (index, (beginning, place)) in parts.iter().enumerate() {
        let part = index + 1;
        let name =
            format!("the shadow of object '{name}' from lights[{source}], part {part} of {count}");
        let unseen = unseen(name, VolumeKind::Shadow, source, Some((object, *beginning)));
        let volume = volume_words(unseen, place, face_error(*beginning, prepared), context)?;
        if !volume.words.screen_box.is_empty() {
            volumes.push(volume);
        }
    }
    Ok(volumes)
}

/// How far the depth at which the object is drawn can be from the true one where its shadow begins, in counts: on the
/// cut plane, or on the quadric, whose root is at most the square root of its error off, and by what its network takes;
/// on a facet as far as its words are rounded, and not its corners.
fn face_error(beginning: Beginning, object: &PreparedObject) -> f64 {
    let Some(quadric) = object.quadric() else {
        // Words of a plane alone, each rounded by half a bit at most about a pixel that is nowhere farther than the
        // size of the box.
        let b = object.screen_box();
        return 0.5 * ((b.x1 - b.x0) + (b.y1 - b.y0) + 1) as f64;
    };
    let bounds = &quadric.bounds;
    match beginning {
        Beginning::Cut(index) => bounds.planes.get(index).copied().unwrap_or(0.0),
        Beginning::Facet(_) => unreachable!("a mesh has no quadric"),
        Beginning::PolarPlane => {
            let root = bounds.root_error(bounds.greatest_root);
            bounds.f1 + bounds.dropped_f1 + (bounds.f2 + bounds.dropped_f2).sqrt() + root
        }
    }
}

/// The cell of screen space that holds everything seen; `None` if nothing is.
fn around(seen: &[Option<Bounds>]) -> Option<Cell> {
    let seen = seen.iter().flatten().copied();
    seen.reduce(|(low, high), (l, h)| {
        (
            std::array::from_fn(|k| f64::min(low[k], l[k])),
            std::array::from_fn(|k| f64::max(high[k], h[k])),
        )
    })
    .map(|(low, high)| Cell::between(low, high))
}

/// The depths, in pixels, between which an object is seen, a pixel wider on both sides.
fn depths(object: &FramedObject, domain: Cell, context: &Context) -> Option<(f64, f64)> {
    let full = domain.half[2];
    let (FramedObject::Quadric(object) | FramedObject::Patch(object)) = object else {
        // Facets and approximated surfaces: their depths are not those of a quadric.
        return Some((-full, full));
    };
    let (quadric, planes) = on_screen(&object.quadric, &object.planes, &context.inverse_distance);
    let clamped = |(near, far): (f64, f64)| ((near - 1.0).max(-full), (far + 1.0).min(full));
    if planes.is_empty()
        && let Some(cell) = Extent::of(&quadric.q).and_then(|extent| extent.cell())
    {
        let (near, far) = (cell.centre[2] - cell.half[2], cell.centre[2] + cell.half[2]);
        // Beyond an end of the depths an ellipsoid may reach behind the eye.
        if near >= -full && far <= full {
            return Some(clamped((near, far)));
        }
    }
    let region = Region::new(&quadric.q, &planes, object.surface);
    region.range_within(domain, 2, Search::COARSE).map(clamped)
}
