//! The words of a polyhedron, which is planes alone.

use super::context::Context;
use super::error::PrepareError;
use super::ledger::Ledger;
use super::prepared::PreparedParts;
use super::projected::Projected;
use super::seams::Place;
use imogene_golden::object::polyhedron::PolyhedronWords;
use imogene_golden::object::quadric::PlaneWords;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_scene::FramedQuadric;

pub(super) fn prepare(
    object: &FramedQuadric,
    projected: &Projected,
    place: &Place,
    context: &Context,
) -> Result<PreparedParts, PrepareError> {
    context.refuse_fitted(&object.name)?;
    let window = &projected.window;
    if window.is_empty() {
        let note = projected.unseen_note(object, context);
        return Ok(PreparedParts::unseen(&object.name, note));
    }
    let mut words = PolyhedronWords {
        screen_box: *window,
        planes: vec![],
    };
    let mut ledger = Ledger::new(&object.name, *window, context);
    let (mut notes, mut bound) = (vec![], 0f64);
    for (index, plane) in projected.prepare_planes(object, place, context).enumerate() {
        let plane = plane?;
        notes.extend(plane.note(index));
        if plane.words.kind != PlaneKind::Perpendicular {
            bound = bound.max(plane.bound);
        }
        words.planes.push(PlaneWords {
            depth: plane.words.depth.wrapped(context.format.plane),
            ..plane.words
        });
        let (word, available) = (format!("plane {index}"), context.format.plane);
        ledger.need(&word, plane.needed, available);
    }
    Ok(PreparedParts {
        depth_bound: Some(bound),
        notes,
        ..ledger.finish(ProcessorWords::Polyhedron(words))
    })
}
