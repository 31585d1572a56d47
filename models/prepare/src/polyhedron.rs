//! Polyhedra: the planes alone.

use super::Context;
use super::error::PrepareError;
use super::located::refuse_fitted;
use super::object::{Projected, unseen_note};
use super::parts::{NeededWord, PreparedParts};
use super::planes::prepare_plane;
use super::seams::Place;
use imogene_golden::object::polyhedron::PolyhedronWords;
use imogene_golden::object::quadric::PlaneWords;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_scene::FramedQuadric;

pub(super) fn prepare_polyhedron(
    object: &FramedQuadric,
    projected: &Projected,
    place: &Place,
    context: &Context,
) -> Result<PreparedParts, PrepareError> {
    refuse_fitted(&object.name, context)?;
    let Projected {
        planes,
        region,
        window,
        ..
    } = projected;
    if window.is_empty() {
        let note = unseen_note(object, false, context);
        return Ok(PreparedParts::unseen(&object.name, note));
    }
    let mut words = PolyhedronWords {
        screen_box: *window,
        planes: vec![],
    };
    let (mut needed, mut notes, mut bound) = (vec![], vec![], 0f64);
    for (index, (original, projected)) in object.planes.iter().zip(planes).enumerate() {
        let plane = prepare_plane(
            &object.name,
            index,
            original,
            projected,
            (region, window, &place.planes[index]),
            context,
        )?;
        notes.extend(plane.note(index));
        if plane.words.kind != PlaneKind::Perpendicular {
            bound = bound.max(plane.bound);
        }
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
        depth_bound: Some(bound),
        name: object.name.clone(),
        words: vec![ProcessorWords::Polyhedron(words)],
        screen_box: *window,
        needed,
        notes,
    })
}
