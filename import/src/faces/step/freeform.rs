//! B-spline surfaces, and those that a curve makes by a straight move or a turn (ISO 10303-42, clause 4.4), as patches.

use super::curves::{conic, line};
use super::placement::{Placement, direction, point};
use super::spline::{Spline, knots, weights};
use super::units::Context;
use crate::faces::bezier::{Patch, Pole, patches, plain};
use crate::faces::vector::{Vector, across, along, cross, dot, minus, plus, reach, times};
use step21::{Args, Entity, Result};

const HIGHEST_DEGREE: usize = 25;
const MOST_POLES: usize = 40_000;
/// How far a swept surface goes on both sides of its curve, in sizes of it: faces are a part of that.
const REACH: f64 = 50.0;

/// Kinds of surfaces that say what their knots are.
const KINDS: [&str; 4] = [
    "B_SPLINE_SURFACE_WITH_KNOTS",
    "BEZIER_SURFACE",
    "QUASI_UNIFORM_SURFACE",
    "UNIFORM_SURFACE",
];

/// The patches of a free-form surface; nothing for one of another kind.
pub fn freeform(entity: Entity, context: &Context) -> Result<Option<Vec<Patch>>> {
    if let Some(kind) = entity.find(&KINDS) {
        return spline_surface(&kind, context).map(Some);
    }
    match entity.find(&["SURFACE_OF_LINEAR_EXTRUSION", "SURFACE_OF_REVOLUTION"]) {
        Some(args) if args.record.name == "SURFACE_OF_REVOLUTION" => revolution(&args, context),
        Some(args) => extrusion(&args, context),
        None => Ok(None),
    }
}

fn spline_surface(kind: &Args, context: &Context) -> Result<Vec<Patch>> {
    let entity = kind.entity;
    let surface = kind.of("B_SPLINE_SURFACE")?;
    let first = surface.first();
    let degrees = [surface.whole(first)?, surface.whole(first + 1)?];
    let rows = surface.list(first + 2)?;
    let mut poles: Vec<Vec<Pole>> = vec![];
    let mut count = 0;
    for row in rows {
        let entities = surface.entities_of(row)?;
        count += entities.len();
        if count > MOST_POLES {
            break;
        }
        let pole = |entity| -> Result<Pole> {
            let [x, y, z] = point(entity, context)?;
            Ok([x, y, z, 1.0])
        };
        poles.push(entities.into_iter().map(pole).collect::<Result<_, _>>()?);
    }
    let width = poles.first().map_or(0, Vec::len);
    let fits = |degree, count| (1..=HIGHEST_DEGREE).contains(&degree) && count > degree;
    let even = poles.iter().all(|row| row.len() == width) && count <= MOST_POLES;
    if !even || !fits(degrees[0], poles.len()) || !fits(degrees[1], width) {
        return Err(surface.error(
            format!("{} x {width} control points for degrees {degrees:?}", rows.len()),
            "degrees 1 to 25 and in both directions more control points than the degree, up to 40000, are possible",
        ));
    }
    if let Some(rational) = entity.find(&["RATIONAL_B_SPLINE_SURFACE"]) {
        let rows = rational.list(0)?;
        if rows.len() != poles.len() {
            let problem = format!("{} rows of weights", rows.len());
            return Err(rational.error(problem, "as many rows as control points have are needed"));
        }
        for (row, values) in poles.iter_mut().zip(rows) {
            let weights = weights(&rational, rational.numbers_of(values)?, width)?;
            for (pole, weight) in row.iter_mut().zip(weights) {
                *pole = pole.map(|value| value * weight);
            }
        }
    }
    let counts = [poles.len(), width];
    // The multiplicities of both directions come before the knots.
    let first = if entity.complex { 0 } else { 8 };
    let along = |k: usize| knots(kind, [first + k, first + 2 + k], degrees[k], counts[k]);
    Ok(patches(degrees, [&along(0)?, &along(1)?], &poles))
}

/// The curve that is moved or turned, as Bezier pieces; nothing for a curve of another kind. Of a line it is a part,
/// not at its origin, which may be on the axis.
fn profile<'a>(mut entity: Entity<'a>, context: &Context) -> Result<Option<Vec<Vec<Pole>>>> {
    for _ in 0..8 {
        let Some(args) = entity.find(&["TRIMMED_CURVE", "SURFACE_CURVE", "SEAM_CURVE"]) else {
            break;
        };
        entity = args.entity(1)?;
    }
    if Spline::is_one(entity) {
        return Ok(Some(Spline::read(entity, context)?.bezier()));
    }
    if let Some(args) = entity.find(&["LINE"]) {
        let (origin, course) = line(&args, context)?;
        let pole = |factor: f64| {
            let [x, y, z] = along(origin, factor, course);
            [x, y, z, 1.0]
        };
        return Ok(Some(vec![vec![pole(1.0), pole(2.0)]]));
    }
    if let Some(args) = entity.find(&["CIRCLE", "ELLIPSE"]) {
        let (place, [first, second]) = conic(&args, context)?;
        let [x, y, _] = place.axes;
        return Ok(Some(arcs(place.origin, times(first, x), times(second, y))));
    }
    Ok(None)
}

/// A whole ellipse as four rational pieces of degree 2.
fn arcs(centre: Vector, x: Vector, y: Vector) -> Vec<Vec<Pole>> {
    let corner = 0.5_f64.sqrt();
    let pole = |a: f64, b: f64, weight: f64| {
        let [x, y, z] = plus(plus(centre, times(a, x)), times(b, y));
        [x * weight, y * weight, z * weight, weight]
    };
    let turns = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [1.0, 0.0]];
    let quarter = |pair: &[[f64; 2]]| {
        let [[a, b], [c, d]] = [pair[0], pair[1]];
        vec![pole(a, b, 1.0), pole(a + c, b + d, corner), pole(c, d, 1.0)]
    };
    turns.windows(2).map(quarter).collect()
}

fn extrusion<'a>(args: &Args<'a>, context: &Context) -> Result<Option<Vec<Patch>>> {
    let course = direction(args.named(2, &["VECTOR"])?.entity(1)?)?;
    let Some(curve) = profile(args.entity(1)?, context)? else {
        return Ok(None);
    };
    let reach = REACH * reach(curve.iter().flatten().map(plain), plain(&curve[0][0]));
    let moved = |[x, y, z, weight]: Pole, factor: f64| -> Pole {
        let [a, b, c] = course.map(|value| factor * weight * value);
        [x + a, y + b, z + c, weight]
    };
    let both = |pole: &Pole| [moved(*pole, -reach), moved(*pole, reach)];
    let patch = |piece: &Vec<Pole>| Patch {
        degrees: [piece.len() - 1, 1],
        poles: piece.iter().flat_map(both).collect(),
    };
    Ok(Some(curve.iter().map(patch).collect()))
}

fn revolution<'a>(args: &Args<'a>, context: &Context) -> Result<Option<Vec<Patch>>> {
    let placed = args.named(2, &["AXIS1_PLACEMENT"])?;
    let origin = point(placed.entity(1)?, context)?;
    let axis = match placed.maybe(2)? {
        Some(entity) => direction(entity)?,
        None => [0.0, 0.0, 1.0],
    };
    let Some(curve) = profile(args.entity(1)?, context)? else {
        return Ok(None);
    };
    let mut all = vec![];
    for piece in &curve {
        // For each control point the circle on which it is turned, or its place on the axis.
        let circles = piece.iter().map(|pole| turned(pole, origin, axis));
        let circles: Vec<Vec<Vec<Pole>>> = circles.collect();
        for quarter in 0..4 {
            let poles = (0..3).flat_map(|k| circles.iter().map(move |circle| circle[quarter][k]));
            all.push(Patch {
                degrees: [2, piece.len() - 1],
                poles: poles.collect(),
            });
        }
    }
    Ok(Some(all))
}

fn turned(pole: &Pole, origin: Vector, axis: Vector) -> Vec<Vec<Pole>> {
    let from = minus(plain(pole), origin);
    let centre = along(origin, dot(from, axis), axis);
    let out = across(from, axis);
    let mut circle = arcs(centre, out, cross(axis, out));
    for own in circle.iter_mut().flatten() {
        *own = own.map(|value| value * pole[3]);
    }
    circle
}

/// Patches where their part is placed.
pub fn placed(mut patches: Vec<Patch>, place: &Placement) -> Vec<Patch> {
    for pole in patches.iter_mut().flat_map(|patch| &mut patch.poles) {
        let weight = pole[3];
        let [x, y, z] = place.point(plain(pole));
        *pole = [x * weight, y * weight, z * weight, weight];
    }
    patches
}
