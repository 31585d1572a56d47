//! A scene's objects: first where each is on the screen, since objects that share a plane or a quadric have to know of
//! each other, then the words of each.

use super::context::Context;
use super::error::PrepareError;
use super::known::Known;
use super::object;
use super::prepared::{PreparedObject, PreparedParts, PreparedQuadric};
use super::projected::{Projected, Subject};
use super::seams::{self, Place, cut};
use super::volume::Found;
use super::{first_generation, mesh, paraboloids, polyhedron, quotient};
use imogene_golden::object::quadric::ScreenBox;
use imogene_scene::{FramedObject, FramedScene};
use rayon::prelude::*;

/// A scene's objects on the screen, before any word of them is known.
pub(super) struct Located {
    /// Of the cut quadrics that are not known.
    projected: Vec<Option<Box<Projected>>>,
    /// Of all cut quadrics.
    pub places: Vec<Option<Box<Place>>>,
    pub found: Found,
}

impl Located {
    pub fn new(scene: &FramedScene, context: &Context, known: &Known) -> Located {
        let objects = scene.objects.par_iter().enumerate();
        let projected: Vec<Option<Box<Projected>>> = objects
            .map(|(index, object)| match known.window(index) {
                Some(_) => None,
                None => Some(Box::new(Projected::new(cut(object)?, context))),
            })
            .collect();
        let windows = projected.iter().enumerate().map(|(index, projected)| {
            let window = projected.as_ref().map(|projected| projected.window);
            window.or_else(|| known.window(index))
        });
        let windows: Vec<Option<ScreenBox>> = windows.collect();
        Located {
            projected,
            places: seams::places(&scene.objects, &windows),
            found: Found::default(),
        }
    }

    pub fn prepare(
        &self,
        index: usize,
        object: &FramedObject,
        context: &Context,
    ) -> Result<PreparedObject, PrepareError> {
        if let FramedObject::Unseen(unseen) = object {
            return Ok(PreparedObject::Unseen(unseen.clone()));
        }
        let (Some(quadric), Some(place)) = (cut(object), &self.places[index]) else {
            return prepare_parts(object, context).map(parts);
        };
        let again;
        let projected = match &self.projected[index] {
            Some(projected) => projected,
            // It is the same as before, but what it shares is not.
            None => {
                again = Projected::new(quadric, context);
                &again
            }
        };
        let subject = Subject {
            object: quadric,
            projected,
            place,
            context,
        };
        match object {
            FramedObject::Polyhedron(_) => polyhedron::prepare(subject).map(parts),
            FramedObject::Patch(_) => prepare_cut(subject, PreparedObject::Patch),
            _ => prepare_cut(subject, PreparedObject::Quadric),
        }
    }
}

fn parts(parts: PreparedParts) -> PreparedObject {
    PreparedObject::Parts(Box::new(parts))
}

/// An object that is none of those.
fn prepare_parts(object: &FramedObject, context: &Context) -> Result<PreparedParts, PrepareError> {
    context.refuse_fitted(object.name())?;
    match object {
        FramedObject::Quadric(_)
        | FramedObject::Patch(_)
        | FramedObject::Polyhedron(_)
        | FramedObject::Unseen(_) => {
            unreachable!("these are prepared where they are")
        }
        FramedObject::FirstGeneration(q) => first_generation::prepare_first_generation(q, context),
        FramedObject::Mesh(mesh) => mesh::prepare_mesh(mesh, context),
        FramedObject::Sphere(sphere) => paraboloids::prepare_sphere(sphere, false, context),
        FramedObject::Cylinder(cylinder) => paraboloids::prepare_cylinder(cylinder, context),
        FramedObject::CurvedSphere(sphere) => paraboloids::prepare_sphere(sphere, true, context),
        FramedObject::CurvedFacet(q) => paraboloids::prepare_curved_facet(q, context),
    }
}

/// A cut quadric by the processor that its scene names, or by the quotient processor if the eye lies on it.
fn prepare_cut(
    subject: Subject,
    by_its_own: fn(Box<PreparedQuadric>) -> PreparedObject,
) -> Result<PreparedObject, PrepareError> {
    let as_quotient = || quotient::prepare(subject).map(parts);
    if quotient::is_on_eye(subject) {
        return as_quotient();
    }
    match object::prepare_quadric(subject) {
        Err(PrepareError::TooLarge(..)) if quotient::is_near_eye(subject) => as_quotient(),
        prepared => prepared.map(|prepared| by_its_own(Box::new(prepared))),
    }
}
