//! A surface with one depth of second degree as a non-planar facet: orthographic views.

use super::context::Context;
use super::error::PrepareError;
use super::forms::{LinearForm, QuadraticForm};
use super::ledger::Ledger;
use super::perspective::ScreenQuadric;
use super::prepared::PreparedParts;
use super::projected::unseen_note;
use super::screen_box::Region;
use imogene_algebra::rational::{integer, to_f64};
use imogene_golden::object::curved_facet::CurvedFacetWords;
use imogene_golden::object::paraboloid::{NORMAL_LENGTH, depth_guard, normal_guard};
use imogene_golden::object::slot::ProcessorWords;
use imogene_scene::FramedQuadric;

pub(super) fn prepare_curved_facet(
    object: &FramedQuadric,
    context: &Context,
) -> Result<PreparedParts, PrepareError> {
    let region = Region::new(&object.quadric, &object.planes, object.surface);
    let window = region.screen_box(context.width, context.height, to_f64(&context.full_depth));
    if window.is_empty() {
        let note = unseen_note(object, false, context);
        return Ok(PreparedParts::unseen(&object.name, note));
    }
    let (format, q) = (&context.format, &object.quadric);
    let full = format.quadratic;
    let mut ledger = Ledger::new(&object.name, window, context);
    let on_box = ledger.on_box();
    let mut sides = vec![];
    for plane in &object.planes {
        let value = LinearForm::new(-&plane.a, -&plane.b, -&plane.d);
        let value = QuadraticForm::of_linear(&context.to_pixels_linear(&value));
        sides.push(ledger.sign("sides", &value, full)?);
    }
    // Q = rest(x, y) + 2 i z.
    let rest = ScreenQuadric::new(q, &context.inverse_distance).depth_free_part();
    let slope = -&context.depth_scale / (integer(2) * &q.i);
    let depth = context.to_pixels_quadratic(&rest).scaled(&slope);
    let depth = ledger.value("depth", &depth, depth_guard(format), full, &on_box)?;
    // Half the gradient.
    let gradient = [
        LinearForm::new(q.a.clone(), q.d.clone(), q.g.clone()),
        LinearForm::new(q.d.clone(), q.b.clone(), q.h.clone()),
        LinearForm::new(integer(0), integer(0), q.i.clone()),
    ]
    .map(|form| context.to_pixels_linear(&form));
    let greatest = gradient.iter().map(|form| form.max_abs_on(&window)).max();
    let scale = integer(NORMAL_LENGTH) / greatest.expect("three components");
    let mut normal = |form: &LinearForm| {
        let form = QuadraticForm::of_linear(&form.scaled(&scale));
        ledger.value("normal", &form, normal_guard(format), full, &on_box)
    };
    let [x, y, z] = &gradient;
    let normal = [normal(x)?, normal(y)?, normal(z)?];
    let words = CurvedFacetWords {
        screen_box: window,
        sides,
        depth,
        normal,
    };
    Ok(ledger.finish(ProcessorWords::CurvedFacet(words)))
}
