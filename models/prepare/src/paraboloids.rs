//! Spheres and cylinders by paraboloids, and surfaces with one depth of second degree as non-planar facets:
//! orthographic views.

use super::context::Context;
use super::error::PrepareError;
use super::forms::{LinearForm, QuadraticForm};
use super::ledger::Ledger;
use super::perspective::ScreenQuadric;
use super::prepared::PreparedParts;
use super::projected::unseen_note;
use super::screen_box::Region;
use super::shapes::{CylinderShape, SphereShape};
use imogene_algebra::rational::{fraction, integer, round_half_up, to_f64};
use imogene_contract::words::NORMAL_LENGTH;
use imogene_golden::object::curved_facet::CurvedFacetWords;
use imogene_golden::object::cylinder::CylinderWords;
use imogene_golden::object::paraboloid::{depth_guard, normal_guard, plane_guard};
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::sphere::SphereWords;
use imogene_golden::unit::normal::LINEAR_WIDTH;
use imogene_scene::{FramedCylinder, FramedQuadric, FramedSphere, root};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

const UNSEEN: &str = "outside the screen or its depth range: nothing to draw";

const UNCAPPED: &str = "reaches nearer than the near end; it is absent there, without a cap";

/// Words of the sphere processor, or of one facet with the sphere's outline for a side.
pub(super) fn prepare_sphere(
    sphere: &FramedSphere,
    as_facet: bool,
    context: &Context,
) -> Result<PreparedParts, PrepareError> {
    let Some((shape, window)) = on_screen(sphere, context) else {
        return Ok(PreparedParts::unseen(&sphere.name, UNSEEN));
    };
    let (format, full) = (&context.format, context.format.quadratic);
    let mut ledger = Ledger::new(&sphere.name, window, context);
    let on_box = ledger.on_box();
    let contour = ledger.sign("outline", &shape.outline(), full)?;
    let exact = shape.paraboloid();
    let depth = ledger.value("depth", &exact, depth_guard(format), full, &on_box)?;
    let ([x, y], deep) = (&shape.normal_across(), shape.normal_deep());
    let normal_guard = normal_guard(format);
    if as_facet {
        let [x, y] = [x, y].map(QuadraticForm::of_linear);
        let mut normal = |word, n| ledger.value(word, n, normal_guard, full, &on_box);
        let words = CurvedFacetWords {
            screen_box: window,
            sides: vec![contour],
            depth,
            normal: [
                normal("normal x", &x)?,
                normal("normal y", &y)?,
                normal("normal z", &deep)?,
            ],
        };
        let mut parts = ledger.finish(ProcessorWords::CurvedFacet(words));
        if &sphere.centre[2] - &sphere.radius < -&context.full_depth {
            parts.notes.push(UNCAPPED.into());
        }
        return Ok(parts);
    }
    let twice = integer(2) * &shape.z;
    let (least, greatest) = on_box(&exact);
    let back = (&twice - least).abs().max((&twice - greatest).abs());
    // One count for each of the two roundings.
    ledger.prove("back depth", &(back + integer(2)), format.sum)?;
    let guard = LINEAR_WIDTH - format.normal;
    let words = SphereWords {
        screen_box: window,
        contour,
        front: depth,
        sum: round_half_up(&twice).to_i64().expect("proven to be short"),
        normal: [
            ledger.linear_value("normal x", x, guard, LINEAR_WIDTH, &on_box)?,
            ledger.linear_value("normal y", y, guard, LINEAR_WIDTH, &on_box)?,
        ],
        normal_z: ledger.value("normal z", &deep, normal_guard, full, &on_box)?,
    };
    Ok(ledger.finish(ProcessorWords::Sphere(words)))
}

/// Words of the cylinder processor.
///
/// Depth and normal of body and disc count only where the cylinder is, so they are proven on the rectangle along its
/// axis that it fills, not on the box.
pub(super) fn prepare_cylinder(
    cylinder: &FramedCylinder,
    context: &Context,
) -> Result<PreparedParts, PrepareError> {
    let shape = cylinder_shape(cylinder, context);
    let window = cylinder_box(&shape, context);
    if window.is_empty() {
        return Ok(PreparedParts::unseen(&cylinder.name, UNSEEN));
    }
    let format = &context.format;
    let (full, plane) = (format.quadratic, format.plane);
    let disc_length = &shape.deep * &shape.radius;
    let reach = &shape.length * &shape.level + &disc_length;
    let in_frame = |form: &QuadraticForm, end: &BigRational| {
        let [cos, sin] = &shape.direction;
        let minus_sin = -sin;
        let along = form.in_frame(
            [[cos, sin], [&minus_sin, cos]],
            [&shape.centre[0], &shape.centre[1]],
        );
        let radius = &shape.radius;
        along.range_between(&[-&disc_length, end.clone(), -radius, radius.clone()])
    };
    let on_body = |form: &QuadraticForm| in_frame(form, &reach);
    let on_disc = |form: &QuadraticForm| in_frame(form, &disc_length);
    let mut ledger = Ledger::new(&cylinder.name, window, context);
    let mut side = |exact| ledger.linear_sign("sides", exact, plane);
    let [a, b, c, d] = &shape.sides();
    let sides = [side(a)?, side(b)?, side(c)?, side(d)?];
    let [front, back] = &shape.discs();
    let discs = [
        ledger.sign("outline of the front disc", front, full)?,
        ledger.sign("outline of the back disc", back, full)?,
    ];
    let (body, guard) = (shape.body(), depth_guard(format));
    let body = ledger.value("depth of the body", &body, guard, full, &on_body)?;
    let guard = normal_guard(format);
    let mut normal = |exact| ledger.value("normal", exact, guard, full, &on_body);
    let [x, y, z] = &shape.body_normal();
    let normal = [normal(x)?, normal(y)?, normal(z)?];
    let (disc, guard) = (shape.disc(), plane_guard(format));
    let disc = ledger.linear_value("depth of the disc", &disc, guard, plane, &on_disc)?;
    let words = CylinderWords {
        screen_box: window,
        sides,
        discs,
        body,
        normal,
        disc,
        disc_normal: shape.disc_normal(),
    };
    let mut parts = ledger.finish(ProcessorWords::Cylinder(words));
    if nearest(&shape) < -&context.full_depth {
        parts.notes.push(UNCAPPED.into());
    }
    Ok(parts)
}

/// A surface with one depth of second degree as a non-planar facet.
pub(super) fn prepare_curved_facet(
    object: &FramedQuadric,
    context: &Context,
) -> Result<PreparedParts, PrepareError> {
    let region = Region::new(&object.quadric, &object.planes, object.surface);
    let window = region.screen_box(context.width, context.height, to_f64(&context.full_depth));
    if window.is_empty() {
        let note = unseen_note(object, context);
        return Ok(PreparedParts::unseen(&object.name, note));
    }
    let (format, q) = (&context.format, &object.quadric);
    let full = format.quadratic;
    let mut ledger = Ledger::new(&object.name, window, context);
    let on_box = ledger.on_box();
    let mut sides = vec![];
    for plane in &object.planes {
        let value = LinearForm::of_array([-&plane.a, -&plane.b, -&plane.d]);
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
        LinearForm::of_array([q.a.clone(), q.d.clone(), q.g.clone()]),
        LinearForm::of_array([q.d.clone(), q.b.clone(), q.h.clone()]),
        LinearForm::of_array([integer(0), integer(0), q.i.clone()]),
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

/// The sphere in pixel columns and lines and depth words, and its box if anything of it is on the screen.
fn on_screen(sphere: &FramedSphere, context: &Context) -> Option<(SphereShape, ScreenBox)> {
    let (x0, y0) = context.first_pixel();
    let [x, y, z] = &sphere.centre;
    let shape = SphereShape {
        x: x - x0,
        y: y - y0,
        z: z * &context.depth_scale,
        radius: sphere.radius.clone(),
        scale: context.depth_scale.clone(),
    };
    let radius = &shape.radius;
    let window = context.pixels_between([
        &shape.x - radius,
        &shape.x + radius,
        &shape.y - radius,
        &shape.y + radius,
    ]);
    let (near, far) = (z - radius, z + radius);
    let seen = !window.is_empty() && near < context.full_depth && far >= -&context.full_depth;
    seen.then_some((shape, window))
}

fn cylinder_shape(cylinder: &FramedCylinder, context: &Context) -> CylinderShape {
    let (x0, y0) = context.first_pixel();
    let [x, y, z] = &cylinder.centre;
    CylinderShape {
        centre: [x - x0, y - y0, z.clone()],
        direction: cylinder.direction.clone(),
        level: cylinder.level.clone(),
        deep: cylinder.deep.clone(),
        radius: cylinder.radius.clone(),
        length: cylinder.length.clone(),
        scale: context.depth_scale.clone(),
    }
}

/// Depth in pixels that nothing of the cylinder is nearer than.
fn nearest(shape: &CylinderShape) -> BigRational {
    &shape.centre[2] - &shape.level * &shape.radius
}

/// The box around both discs; a thousandth of a pixel covers the roots that its sides take.
fn cylinder_box(shape: &CylinderShape, context: &Context) -> ScreenBox {
    let far = &shape.centre[2] + &shape.deep * &shape.length + &shape.level * &shape.radius;
    if nearest(shape) >= context.full_depth || far < -&context.full_depth {
        return ScreenBox::EMPTY;
    }
    let [cos, sin] = &shape.direction;
    let across = |along: &BigRational, beside: &BigRational| {
        let square = (&shape.deep * along).pow(2) + beside.pow(2);
        &shape.radius * root(&square) + fraction(1, 1000)
    };
    let length = &shape.length * &shape.level;
    let side = |axis: usize, along: &BigRational, beside: &BigRational| {
        let (one, other) = (&shape.centre[axis], &shape.centre[axis] + &length * along);
        let extent = across(along, beside);
        (one.min(&other) - &extent, one.max(&other) + &extent)
    };
    let ((x0, x1), (y0, y1)) = (side(0, cos, sin), side(1, sin, cos));
    context.pixels_between([x0, x1, y0, y1])
}
