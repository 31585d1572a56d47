//! B-spline surfaces, and those that a curve makes by a straight move or a turn (ISO 10303-42, clause 4.4), as patches.

use super::args::Args;
use super::curves::radius;
use super::exchange::{Entity, Exchange};
use super::knots::{implied_knots, weights, written_knots};
use super::placement::{Placement, direction, placement, point};
use super::spline::Spline;
use super::units::Context;
use crate::ImportError;
use crate::faces::bezier::{Patch, Pole, patches, pieces};
use crate::faces::vector::{Vector, across, along, cross, dot, length, minus, plus, times};

/// Highest degree.
const HIGHEST_DEGREE: usize = 25;
/// Most control points of a surface.
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
pub fn freeform(
    file: &Exchange,
    entity: &Entity,
    context: &Context,
) -> Result<Option<Vec<Patch>>, ImportError> {
    if let Some(kind) = file.find(entity, &KINDS) {
        return spline_surface(file, entity, &kind, context).map(Some);
    }
    if let Some(args) = file.find(entity, &["SURFACE_OF_LINEAR_EXTRUSION"]) {
        return extrusion(file, &args, context);
    }
    if let Some(args) = file.find(entity, &["SURFACE_OF_REVOLUTION"]) {
        return revolution(file, &args, context);
    }
    Ok(None)
}

fn spline_surface<'e, 'a>(
    file: &'e Exchange<'a>,
    entity: &'e Entity<'a>,
    kind: &Args<'e, 'a>,
    context: &Context,
) -> Result<Vec<Patch>, ImportError> {
    let (surface, first) = if entity.complex {
        (file.need(entity, &["B_SPLINE_SURFACE"])?, 0)
    } else {
        (*kind, 1)
    };
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
        let pole = |entity| -> Result<Pole, ImportError> {
            let [x, y, z] = point(file, entity, context)?;
            Ok([x, y, z, 1.0])
        };
        poles.push(entities.into_iter().map(pole).collect::<Result<_, _>>()?);
    }
    let width = poles.first().map_or(0, Vec::len);
    let fits =
        |degree: usize, count: usize| (1..=HIGHEST_DEGREE).contains(&degree) && count > degree;
    let even = poles.iter().all(|row| row.len() == width) && count <= MOST_POLES;
    if !even || !fits(degrees[0], poles.len()) || !fits(degrees[1], width) {
        return Err(surface.error(
            format!("{} x {width} control points for degrees {degrees:?}", rows.len()),
            "degrees 1 to 25 and in both directions more control points than the degree, up to 40000, are possible",
        ));
    }
    if let Some(rational) = file.find(entity, &["RATIONAL_B_SPLINE_SURFACE"]) {
        let rows = rational.list(0)?;
        if rows.len() != poles.len() {
            return Err(rational.error(
                format!("{} rows of weights", rows.len()),
                "as many rows as control points have are needed",
            ));
        }
        for (row, values) in poles.iter_mut().zip(rows) {
            for (pole, weight) in
                row.iter_mut()
                    .zip(weights(&rational, &rational.numbers_of(values)?, width)?)
            {
                *pole = pole.map(|value| value * weight);
            }
        }
    }
    let counts = [poles.len(), width];
    let mut knots = vec![];
    for k in 0..2 {
        knots.push(match kind.record.name {
            "B_SPLINE_SURFACE_WITH_KNOTS" => {
                // The multiplicities of both directions come before the knots.
                let first = if entity.complex { 0 } else { 8 };
                let places = [first + k, first + 2 + k];
                written_knots(kind, places, degrees[k], counts[k])?
            }
            name => implied_knots(kind, name, degrees[k], counts[k])?,
        });
    }
    Ok(patches(degrees, [&knots[0], &knots[1]], &poles))
}

/// The curve that is moved or turned, as Bezier pieces; nothing for a curve of another kind. Of a line it is a part,
/// not at its origin, which may be on the axis.
fn profile<'e, 'a>(
    file: &'e Exchange<'a>,
    mut entity: &'e Entity<'a>,
    context: &Context,
    reach: f64,
) -> Result<Option<Vec<Vec<Pole>>>, ImportError> {
    for _ in 0..8 {
        let Some(args) = file.find(entity, &["TRIMMED_CURVE", "SURFACE_CURVE", "SEAM_CURVE"])
        else {
            break;
        };
        entity = args.entity(1)?;
    }
    if Spline::is_one(file, entity) {
        return Ok(Some(Spline::read(file, entity, context)?.pieces_of()));
    }
    if let Some(args) = file.find(entity, &["LINE"]) {
        let origin = point(file, args.entity(1)?, context)?;
        let course = direction(file, args.named(2, &["VECTOR"])?.entity(1)?)?;
        let pole = |factor: f64| {
            let [x, y, z] = along(origin, factor, course);
            [x, y, z, 1.0]
        };
        return Ok(Some(vec![vec![pole(reach), pole(2.0 * reach)]]));
    }
    if let Some(args) = file.find(entity, &["CIRCLE", "ELLIPSE"]) {
        let place = placement(file, args.entity(1)?, context)?;
        let first = radius(&args, 2, context)?;
        let second = match args.record.name {
            "CIRCLE" => first,
            _ => radius(&args, 3, context)?,
        };
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
    turns
        .windows(2)
        .map(|pair| {
            let [[a, b], [c, d]] = [pair[0], pair[1]];
            vec![pole(a, b, 1.0), pole(a + c, b + d, corner), pole(c, d, 1.0)]
        })
        .collect()
}

fn extrusion<'e, 'a>(
    file: &'e Exchange<'a>,
    args: &Args<'e, 'a>,
    context: &Context,
) -> Result<Option<Vec<Patch>>, ImportError> {
    let course = direction(file, args.named(2, &["VECTOR"])?.entity(1)?)?;
    let Some(curve) = profile(file, args.entity(1)?, context, 1.0)? else {
        return Ok(None);
    };
    let reach = REACH * extent(&curve);
    let moved = |pole: &Pole, factor: f64| -> Pole {
        let weight = pole[3];
        std::array::from_fn(|k| match k {
            3 => weight,
            _ => pole[k] + factor * weight * course[k],
        })
    };
    let patch = |piece: &Vec<Pole>| Patch {
        degrees: [piece.len() - 1, 1],
        poles: piece
            .iter()
            .flat_map(|pole| [moved(pole, -reach), moved(pole, reach)])
            .collect(),
    };
    Ok(Some(curve.iter().map(patch).collect()))
}

fn extent(curve: &[Vec<Pole>]) -> f64 {
    let plain = |p: &Pole| [p[0] / p[3], p[1] / p[3], p[2] / p[3]];
    let first = plain(&curve[0][0]);
    let points = curve.iter().flatten().map(plain);
    points.map(|p| length(minus(p, first))).fold(0.0, f64::max)
}

fn revolution<'e, 'a>(
    file: &'e Exchange<'a>,
    args: &Args<'e, 'a>,
    context: &Context,
) -> Result<Option<Vec<Patch>>, ImportError> {
    let placed = args.named(2, &["AXIS1_PLACEMENT"])?;
    let origin = point(file, placed.entity(1)?, context)?;
    let axis = match placed.maybe(2)? {
        Some(entity) => direction(file, entity)?,
        None => [0.0, 0.0, 1.0],
    };
    let Some(curve) = profile(file, args.entity(1)?, context, 1.0)? else {
        return Ok(None);
    };
    let mut all = vec![];
    for piece in &curve {
        // For each control point the circle on which it is turned, or its place on the axis.
        let circles: Vec<Vec<Vec<Pole>>> = piece
            .iter()
            .map(|pole| turned(pole, origin, axis))
            .collect();
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
    let weight = pole[3];
    let p = [pole[0] / weight, pole[1] / weight, pole[2] / weight];
    let from = minus(p, origin);
    let centre = along(origin, dot(from, axis), axis);
    let out = across(from, axis);
    let scaled = |pole: Pole| pole.map(|value| value * weight);
    let circle = arcs(centre, out, cross(axis, out));
    circle
        .into_iter()
        .map(|piece| piece.into_iter().map(scaled).collect())
        .collect()
}

/// Patches where their part is placed.
pub fn placed(patches: Vec<Patch>, place: &Placement) -> Vec<Patch> {
    let moved = |pole: Pole| {
        let weight = pole[3];
        let [x, y, z] = place.point([pole[0] / weight, pole[1] / weight, pole[2] / weight]);
        [x * weight, y * weight, z * weight, weight]
    };
    let moved = |patch: Patch| Patch {
        poles: patch.poles.into_iter().map(moved).collect(),
        ..patch
    };
    patches.into_iter().map(moved).collect()
}

impl Spline {
    /// Its Bezier pieces.
    fn pieces_of(&self) -> Vec<Vec<Pole>> {
        pieces(self.degree, &self.knots, &self.poles)
    }
}
