//! The words of a polyhedron, which is planes alone.

use super::error::PrepareError;
use super::ledger::Ledger;
use super::prepared::PreparedParts;
use super::projected::Subject;
use imogene_golden::object::polyhedron::PolyhedronWords;
use imogene_golden::object::quadric::PlaneWords;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::cut_plane::PlaneKind;

pub(super) fn prepare(subject: Subject) -> Result<PreparedParts, PrepareError> {
    let (object, context) = (subject.object, subject.context);
    context.refuse_fitted(&object.name)?;
    let window = &subject.projected.window;
    if window.is_empty() {
        return Ok(PreparedParts::unseen(&object.name, subject.unseen_note()));
    }
    let mut words = PolyhedronWords {
        screen_box: *window,
        planes: vec![],
    };
    let mut ledger = Ledger::new(&object.name, *window, context);
    let (mut notes, mut bound) = (vec![], 0f64);
    for (index, plane) in subject.planes().enumerate() {
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
