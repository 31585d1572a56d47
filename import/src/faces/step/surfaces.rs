//! Surfaces of faces (ISO 10303-42, clause 4.4).

use super::curves::radius;
use super::exchange::{Entity, Exchange};
use super::placement::{Placement, placement};
use super::units::Context;
use crate::ImportError;
use crate::faces::surface::{Surface, clean_tangent};
use crate::faces::vector::along;

/// A surface, and why it is not drawn although it is a quadric.
pub type Found = (Surface, Option<String>);

/// Kinds of surfaces that are read.
const QUADRICS: [&str; 4] = [
    "PLANE",
    "CYLINDRICAL_SURFACE",
    "CONICAL_SURFACE",
    "SPHERICAL_SURFACE",
];

/// The surface of a face, placed. The axis of a cone goes into the nappe that its radius is on.
pub fn surface(
    file: &Exchange,
    entity: &Entity,
    context: &Context,
    place: &Placement,
) -> Result<Found, ImportError> {
    let Some(args) = file.find(entity, &QUADRICS) else {
        return other(file, entity).map(|name| (Surface::Other(name), None));
    };
    let own = placement(file, args.entity(1)?, context)?;
    let own = place.after(&own);
    let (origin, axis) = (own.origin, own.axes[2]);
    let surface = match args.record.name {
        "PLANE" => Surface::Plane {
            origin,
            normal: axis,
        },
        "CYLINDRICAL_SURFACE" => Surface::Cylinder {
            origin,
            axis,
            radius: radius(&args, 2, context)?,
        },
        "SPHERICAL_SURFACE" => Surface::Sphere {
            centre: origin,
            radius: radius(&args, 2, context)?,
        },
        _ => {
            let radius = args.number(2)? * context.length;
            let angle = args.number(3)? * context.angle;
            if !(0.0..=1e9).contains(&radius) {
                return Err(args.error(
                    format!("a radius of {radius} mm"),
                    "0 to 1e9 mm are possible",
                ));
            }
            if !(0.1..=89.9).contains(&angle.abs().to_degrees()) {
                let reason = format!(
                    "an angle of {} degrees between axis and surface is out of range, 0.1 to 89.9 degrees are possible",
                    angle.to_degrees()
                );
                return Ok((Surface::Other("cone".into()), Some(reason)));
            }
            // A negative angle, which some systems write, narrows the cone along its axis.
            let axis = if angle < 0.0 {
                axis.map(|v| 0.0 - v)
            } else {
                axis
            };
            Surface::Cone {
                apex: along(origin, -radius / clean_tangent(angle.abs()), axis),
                axis,
                half_angle: angle.abs(),
            }
        }
    };
    Ok((surface, None))
}

/// The name of a surface that is no quadric, as in a face list where that has one.
fn other(file: &Exchange, entity: &Entity) -> Result<String, ImportError> {
    let has = |part: &str| entity.records.iter().any(|r| r.name.contains(part));
    Ok(if has("TOROIDAL_SURFACE") {
        "torus".into()
    } else if has("B_SPLINE_SURFACE") || has("BEZIER_SURFACE") || has("UNIFORM_SURFACE") {
        "bspline".into()
    } else if has("SURFACE_OF_REVOLUTION") {
        "revolution".into()
    } else if has("SURFACE_OF_LINEAR_EXTRUSION") {
        "extrusion".into()
    } else if has("SURFACE") && !has("CURVE") {
        entity.name().to_lowercase().replace('_', " ")
    } else {
        file.need(entity, &["PLANE", "surface"])?;
        String::new()
    })
}
