//! Surfaces of faces (ISO 10303-42, clause 4.4).

use super::args::Args;
use super::curves::radius;
use super::exchange::{Entity, Exchange};
use super::freeform::{freeform, placed};
use super::placement::{Placement, placement};
use super::units::Context;
use crate::ImportError;
use crate::faces::canonical::canonical;
use crate::faces::surface::{Surface, clean_tangent};
use crate::faces::vector::along;

/// The surface of a face.
#[derive(Clone, Debug)]
pub struct Found {
    /// The surface.
    pub surface: Surface,
    /// Why it is not drawn although it is a quadric.
    pub refused: Option<String>,
    /// How far the surface of the file is off it at most, millimetres.
    pub off: f64,
    /// Its own normal is opposite to that of the surface of the file.
    pub opposite: bool,
}

impl Found {
    fn exact(surface: Surface) -> Found {
        Found {
            surface,
            refused: None,
            off: 0.0,
            opposite: false,
        }
    }

    fn refused(name: &str, reason: String) -> Found {
        Found {
            refused: Some(reason),
            ..Found::exact(Surface::Other(name.into()))
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
/// Most surfaces that are defined by each other.
const DEEPEST: usize = 8;

/// The surface of a face, placed. The axis of a cone goes into the nappe that its radius is on. A free-form surface
/// that is a quadric, a plane or a torus within `tolerance`, millimetres, is taken for it.
pub fn surface(
    file: &Exchange,
    entity: &Entity,
    context: &Context,
    place: &Placement,
    tolerance: f64,
) -> Result<Found, ImportError> {
    surface_at(file, entity, context, place, tolerance, 0)
}

fn surface_at(
    file: &Exchange,
    entity: &Entity,
    context: &Context,
    place: &Placement,
    tolerance: f64,
    depth: usize,
) -> Result<Found, ImportError> {
    if let Some(args) = file.find(entity, &KNOWN) {
        return known(file, &args, context, place);
    }
    let inner = |args: &Args| -> Result<Found, ImportError> {
        if depth == DEEPEST {
            return Err(args.error(
                "it is defined by itself, or by too many others",
                &format!("at most {DEEPEST} surfaces defined by each other are possible"),
            ));
        }
        surface_at(file, args.entity(1)?, context, place, tolerance, depth + 1)
    };
    if let Some(args) = file.find(entity, &PARTS) {
        let mut found = inner(&args)?;
        if args.record.name == PARTS[0] && args.flag(6)? != args.flag(7)? {
            found.opposite = !found.opposite;
        }
        return Ok(found);
    }
    if let Some(args) = file.find(entity, &["OFFSET_SURFACE"]) {
        let basis = inner(&args)?;
        let by = args.number(2)? * context.length;
        let by = if basis.opposite { -by } else { by };
        return Ok(match basis.surface.offset(by) {
            Some(surface) => Found { surface, ..basis },
            None => Found::exact(Surface::Other("offset surface".into())),
        });
    }
    if let Some(patches) = freeform(file, entity, context)?
        && let Some(found) = canonical(&placed(patches, place), tolerance)
    {
        return Ok(Found {
            surface: found.surface,
            refused: None,
            off: found.deviation,
            opposite: found.opposite,
        });
    }
    other(file, entity).map(|name| Found::exact(Surface::Other(name)))
}

fn known(
    file: &Exchange,
    args: &Args,
    context: &Context,
    place: &Placement,
) -> Result<Found, ImportError> {
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
            radius: radius(args, 2, context)?,
        },
        "SPHERICAL_SURFACE" => Surface::Sphere {
            centre: origin,
            radius: radius(args, 2, context)?,
        },
        "TOROIDAL_SURFACE" | "DEGENERATE_TOROIDAL_SURFACE" => Surface::Torus {
            centre: origin,
            axis,
            major: radius(args, 2, context)?,
            minor: radius(args, 3, context)?,
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
                return Ok(Found::refused("cone", reason));
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
    Ok(Found::exact(surface))
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
