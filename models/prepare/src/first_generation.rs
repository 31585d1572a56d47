//! Words of the first generation: those of the quadric, and for each plane the conic and the line whose signs decide
//! (source: 2.4.1).

use super::context::Context;
use super::error::PrepareError;
use super::forms::{LinearForm, QuadraticForm};
use super::ledger::Ledger;
use super::object::prepare_quadric;
use super::prepared::{PreparedParts, PreparedQuadric};
use super::projected::{Projected, Subject};
use super::seams::Place;
use imogene_algebra::rational::integer;
use imogene_golden::object::first_generation::{ContourPlane, FirstGenerationWords};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_scene::{FramedQuadric, Surface};

pub(super) fn prepare_first_generation(
    object: &FramedQuadric,
    context: &Context,
) -> Result<PreparedParts, PrepareError> {
    let projected = Projected::new(object, context);
    let place = Place::alone(projected.window, object.planes.len());
    let prepared = prepare_quadric(Subject {
        object,
        projected: &projected,
        place: &place,
        context,
    })?;
    let name = &object.name;
    let refuse = |problem| Err(PrepareError::FirstGeneration(name.clone(), problem));
    match prepared.words.class {
        Class::Side | Class::Patch => {}
        Class::Front => return refuse("the viewer is inside the unbounded quadric"),
        Class::Prism => return refuse("its quadric does not depend on the depth"),
    }
    if prepared.words.screen_box.is_empty() {
        let note = prepared
            .notes
            .first()
            .map_or("nothing to draw", String::as_str);
        return Ok(PreparedParts::unseen(name, note));
    }
    let of_kind = |kind| prepared.words.planes.iter().position(|p| p.kind == kind);
    let (Some(front), Some(back)) = (of_kind(PlaneKind::Front), of_kind(PlaneKind::Back)) else {
        return refuse(
            "the viewer is between its two planes, or sees them edge-on, so that there is no front plane and back plane",
        );
    };
    let held = prepared.words.wrapped(&context.format);
    let mut ledger = Ledger::new(name, prepared.words.screen_box, context);
    let (needed, format) = (&prepared.needed, &context.format);
    ledger.need("f1 + sqrt(f2)", needed.sum, format.sum);
    ledger.need("f2", needed.quadratic, format.quadratic);
    ledger.need("planes", needed.plane, format.plane);
    let words = FirstGenerationWords {
        patch: object.surface == Surface::Patch,
        screen_box: prepared.words.screen_box,
        f1: held.f1,
        f2: held.f2,
        normal: held.normal,
        front: contours(&prepared, front, -1, &mut ledger, context)?,
        back: contours(&prepared, back, 1, &mut ledger, context)?,
    };
    Ok(PreparedParts {
        notes: prepared.notes,
        ..ledger.finish(ProcessorWords::FirstGeneration(words))
    })
}

/// Conic `f2 - (zp - f1)^2` and line `sign (zp - f1)` of a plane; their scales are free.
fn contours(
    prepared: &PreparedQuadric,
    index: usize,
    sign: i64,
    ledger: &mut Ledger,
    context: &Context,
) -> Result<ContourPlane, PrepareError> {
    let exact = &prepared.exact;
    let apart: LinearForm = exact.planes[index].minus(&exact.f1);
    let conic = exact.f2.minus(&QuadraticForm::square_of(&apart));
    let side = if sign < 0 { "front" } else { "back" };
    let plane = &prepared.words.planes[index];
    Ok(ContourPlane {
        depth: plane.depth.wrapped(context.format.plane),
        conic: ledger.sign(
            &format!("conic of the {side} plane"),
            &conic,
            context.format.quadratic,
        )?,
        polar: ledger.linear_sign(
            &format!("polar line of the {side} plane"),
            &apart.scaled(&integer(sign)),
            context.format.plane,
        )?,
        normal: plane.normal,
    })
}
