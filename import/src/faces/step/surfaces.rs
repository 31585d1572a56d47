//! Surfaces of faces (ISO 10303-42, clause 4.4).

use super::placement::{Placement, placement, radius};
use super::spline::{freeform, placed};
use super::units::Context;
use crate::faces::canonical::{Found, canonical};
use crate::faces::surface::clean_tangent;
use crate::faces::vector::{along, opposite};
use crate::faces::{Form, Surface};
use step21::{Args, Entity, Result};

impl Found {
    fn exact(surface: Surface) -> Found {
        Found {
            surface,
            ..Found::default()
        }
    }
}

/// Kinds of surfaces that are read as they are.
const KNOWN: [&str; 6] = [
    "PLANE",
    "TOROIDAL_SURFACE",
    "DEGENERATE_TOROIDAL_SURFACE",
    "CYLINDRICAL_SURFACE",
    "CONICAL_SURFACE",
    "SPHERICAL_SURFACE",
];
/// Surfaces that are a part of another.
const PARTS: [&str; 2] = ["RECTANGULAR_TRIMMED_SURFACE", "CURVE_BOUNDED_SURFACE"];
const DEEPEST: usize = 8;

/// The surface of a face, placed; the axis of a cone goes into the nappe that its radius is on. A free-form surface is
/// taken for what it is within `tolerance`, millimetres; `depth` others are defined by it.
pub fn surface(
    entity: Entity,
    context: &Context,
    place: &Placement,
    tolerance: f64,
    depth: usize,
) -> Result<Found> {
    if let Some(args) = entity.find(&KNOWN) {
        return known(&args, context, place);
    }
    let inner = |args: &Args| -> Result<Found> {
        if depth == DEEPEST {
            let accepted = format!("at most {DEEPEST} surfaces defined by each other are possible");
            return Err(args.error("it is defined by itself, or by too many others", accepted));
        }
        surface(args.entity(1)?, context, place, tolerance, depth + 1)
    };
    if let Some(args) = entity.find(&PARTS) {
        let mut found = inner(&args)?;
        if args.record.name == PARTS[0] && args.flag(6)? != args.flag(7)? {
            found.opposite = !found.opposite;
        }
        return Ok(found);
    }
    if let Some(args) = entity.find(&["OFFSET_SURFACE"]) {
        let basis = inner(&args)?;
        let by = args.number(2)? * context.length;
        let by = if basis.opposite { -by } else { by };
        return Ok(match basis.surface.offset(by) {
            Some(surface) => Found { surface, ..basis },
            None => Found::exact(Surface::other("offset surface")),
        });
    }
    match freeform(entity, context)?.and_then(|all| canonical(&placed(all, place), tolerance)) {
        Some(found) => Ok(found),
        None => Ok(Found::exact(Surface::other(other(entity)?))),
    }
}

fn known(args: &Args, context: &Context, place: &Placement) -> Result<Found> {
    let own = place.after(&placement(args.entity(1)?, context)?);
    let sized = |index| radius(args, index, context);
    let form = match args.record.name {
        "PLANE" => Form::Plane,
        "CYLINDRICAL_SURFACE" => Form::Cylinder(sized(2)?),
        "SPHERICAL_SURFACE" => Form::Sphere(sized(2)?),
        "CONICAL_SURFACE" => return cone(args, context, &own),
        _ => Form::Torus(sized(2)?, sized(3)?),
    };
    Ok(Found::exact(Surface::new(own.origin, own.axes[2], form)))
}

fn cone(args: &Args, context: &Context, own: &Placement) -> Result<Found> {
    let radius = args.number(2)? * context.length;
    let angle = args.number(3)? * context.angle;
    if !(0.0..=1e9).contains(&radius) {
        let problem = format!("a radius of {radius} mm");
        return Err(args.error(problem, "0 to 1e9 mm are possible"));
    }
    if !(0.1..=89.9).contains(&angle.abs().to_degrees()) {
        let reason = format!(
            "an angle of {} degrees between axis and surface is out of range, 0.1 to 89.9 degrees are possible",
            angle.to_degrees()
        );
        return Ok(Found {
            refused: Some(reason),
            ..Found::exact(Surface::other("cone"))
        });
    }
    // A negative angle, which some systems write, narrows the cone along its axis.
    let axis = own.axes[2];
    let axis = if angle < 0.0 { opposite(axis) } else { axis };
    let apex = along(own.origin, -radius / clean_tangent(angle.abs()), axis);
    let form = Form::Cone(angle.abs());
    Ok(Found::exact(Surface::new(apex, axis, form)))
}

/// The name of a surface that is no quadric, as in a face list where that has one.
fn other(entity: Entity) -> Result<String> {
    const NAMES: [(&str, &str); 6] = [
        ("TOROIDAL_SURFACE", "torus"),
        ("B_SPLINE_SURFACE", "bspline"),
        ("BEZIER_SURFACE", "bspline"),
        ("UNIFORM_SURFACE", "bspline"),
        ("SURFACE_OF_REVOLUTION", "revolution"),
        ("SURFACE_OF_LINEAR_EXTRUSION", "extrusion"),
    ];
    let has = |part: &str| entity.records.iter().any(|r| r.name.contains(part));
    if let Some((_, name)) = NAMES.iter().find(|(part, _)| has(part)) {
        return Ok((*name).into());
    }
    if !has("SURFACE") || has("CURVE") {
        entity.need(&["PLANE", "surface"])?;
    }
    Ok(entity.name().to_lowercase().replace('_', " "))
}
