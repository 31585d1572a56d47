//! Polyhedra: the planes alone.

use super::Context;
use super::error::PrepareError;
use super::object::unseen_note;
use super::parts::{NeededWord, PreparedParts};
use super::perspective::project_plane;
use super::planes::prepare_plane;
use super::rounding::Anchor;
use super::screen_box::Region;
use crate::object::polyhedron::PolyhedronWords;
use crate::object::quadric::PlaneWords;
use crate::object::slot::ProcessorWords;
use crate::rational::to_f64;
use crate::scene::{FramedQuadric, Plane};
use num_traits::Signed;

pub(super) fn prepare_polyhedron(
    object: &FramedQuadric,
    context: &Context,
) -> Result<PreparedParts, PrepareError> {
    let planes: Vec<Plane> = object
        .planes
        .iter()
        .map(|p| project_plane(p, &context.inverse_distance))
        .collect();
    // A plane keeps the eye iff its depth factor is not negative.
    if context.perspective && planes.iter().all(|p| !p.c.is_negative()) {
        return Err(PrepareError::ViewerInsidePolyhedron {
            object: object.name.clone(),
        });
    }
    let region = Region::new(&object.quadric, &planes, object.surface);
    let window = region.screen_box(context.width, context.height, to_f64(&context.full_depth));
    if window.is_empty() {
        let note = unseen_note(object, false, context)?;
        return Ok(PreparedParts::unseen(&object.name, note));
    }
    let anchor = context.options.anchor;
    let anchor = anchor.unwrap_or_else(|| Anchor::middle_of(&window));
    let mut words = PolyhedronWords {
        screen_box: window,
        planes: vec![],
    };
    let (mut needed, mut notes) = (vec![], vec![]);
    for (index, (original, projected)) in object.planes.iter().zip(&planes).enumerate() {
        let plane = prepare_plane(
            &object.name,
            index,
            original,
            projected,
            (&region, &window, anchor),
            context,
        )?;
        notes.extend(plane.note(index));
        words.planes.push(PlaneWords {
            depth: plane.words.depth.wrapped(context.format.plane),
            ..plane.words
        });
        needed.push(NeededWord {
            word: format!("plane {index}"),
            needed: plane.needed,
            available: context.format.plane,
        });
    }
    Ok(PreparedParts {
        depth_bound: None,
        name: object.name.clone(),
        words: vec![ProcessorWords::Polyhedron(words)],
        screen_box: window,
        needed,
        notes,
    })
}
