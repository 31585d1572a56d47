//! Points, directions and placements (ISO 10303-42, clause 4.4).

use super::units::Context;
use crate::faces::cell::clean;
use crate::faces::keys::MAX_NUMBER;
use crate::faces::vector::{Vector, across, cross, frame, length, minus, plus, unit};
use imogene_algebra::matrix::{image, transposed};
use step21::{Args, Entity, Result};

/// Turned and moved: coordinates along three axes become those of the space around.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    pub origin: Vector,
    /// Where the axes come to be, right-handed and of length 1.
    pub axes: [Vector; 3],
}

impl Placement {
    pub const IN_PLACE: Placement = Placement {
        origin: [0.0; 3],
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    };

    pub fn direction(&self, v: Vector) -> Vector {
        if self.axes == Self::IN_PLACE.axes {
            return v;
        }
        image(&transposed(&self.axes), &v)
    }

    pub fn point(&self, p: Vector) -> Vector {
        plus(self.origin, self.direction(p))
    }

    /// First `inner`, then this.
    pub fn after(&self, inner: &Placement) -> Placement {
        Placement {
            origin: self.point(inner.origin),
            axes: inner.axes.map(|axis| clean(unit(self.direction(axis)))),
        }
    }

    pub fn inverse(&self) -> Placement {
        Placement {
            origin: image(&self.axes, &minus([0.0; 3], self.origin)),
            axes: transposed(&self.axes),
        }
    }
}

fn triple(args: &Args, index: usize) -> Result<Vector> {
    let numbers = args.numbers(index)?;
    numbers.try_into().map_err(|numbers: Vec<f64>| {
        let problem = format!("it has {} coordinates", numbers.len());
        args.error(problem, "three coordinates are needed")
    })
}

/// A point, millimetres.
pub fn point(entity: Entity, context: &Context) -> Result<Vector> {
    let args = entity.need(&["CARTESIAN_POINT"])?;
    let point = triple(&args, 1)?.map(|value| value * context.length);
    if point.iter().any(|value| value.abs() > MAX_NUMBER) {
        let least = -MAX_NUMBER;
        let accepted = format!("coordinates from {least:e} to {MAX_NUMBER:e} mm are possible");
        return Err(args.error("it is too far off", accepted));
    }
    Ok(point)
}

/// A direction of length 1.
pub fn direction(entity: Entity) -> Result<Vector> {
    let args = entity.need(&["DIRECTION"])?;
    let numbers = triple(&args, 1)?;
    if !(1e-9..=MAX_NUMBER).contains(&length(numbers)) {
        let problem = format!("{numbers:?} has no direction");
        return Err(args.error(problem, "a vector with a number other than 0 is needed"));
    }
    Ok(clean(unit(numbers)))
}

/// An `AXIS2_PLACEMENT_3D` in the space of its own representation, millimetres.
pub fn placement(entity: Entity, context: &Context) -> Result<Placement> {
    let args = entity.need(&["AXIS2_PLACEMENT_3D"])?;
    let origin = point(args.entity(1)?, context)?;
    let given = |index| args.maybe(index)?.map(direction).transpose();
    let z = given(2)?.unwrap_or([0.0, 0.0, 1.0]);
    let wanted = given(3)?.unwrap_or([1.0, 0.0, 0.0]);
    let mut x = across(wanted, z);
    // The standard takes another axis of the frame if the wanted one is along z.
    if length(x) < 1e-9 {
        let [first, second, _] = Placement::IN_PLACE.axes;
        x = across(if z[0].abs() > 0.9 { second } else { first }, z);
    }
    if length(x) < 1e-9 {
        x = frame(z, 0.0)[0];
    }
    let x = clean(unit(x));
    Ok(Placement {
        origin,
        axes: [x, clean(cross(z, x)), z],
    })
}

/// A point and the direction of a line.
pub fn line(args: &Args, context: &Context) -> Result<(Vector, Vector)> {
    let origin = point(args.entity(1)?, context)?;
    Ok((origin, direction(args.named(2, &["VECTOR"])?.entity(1)?)?))
}

/// Where a conic is, and its two sizes; that of a circle or a parabola twice.
pub fn conic(args: &Args, context: &Context) -> Result<(Placement, [f64; 2])> {
    let place = placement(args.entity(1)?, context)?;
    let first = radius(args, 2, context)?;
    let second = match args.record.name {
        "CIRCLE" | "PARABOLA" => first,
        _ => radius(args, 3, context)?,
    };
    Ok((place, [first, second]))
}

/// A length above 0 and up to the largest coordinate, millimetres.
pub fn radius(args: &Args, index: usize, context: &Context) -> Result<f64> {
    let written = args.number(index)?;
    let radius = written * context.length;
    if (1e-9..=MAX_NUMBER).contains(&radius) {
        return Ok(radius);
    }
    let accepted = format!("a length above 0 and up to {MAX_NUMBER:e} mm is needed");
    Err(args.error(format!("a radius of {written}"), accepted))
}
