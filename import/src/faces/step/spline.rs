//! B-spline curves, rational ones among them (ISO 10303-42, clause 4.4.34), and as patches B-spline surfaces and those
//! that a curve makes by a straight move or a turn (clause 4.4).

use super::placement::{Placement, conic, direction, line, point};
use super::units::Context;
use crate::faces::bezier::{Patch, Pole, de_boor, patches, pieces, plain, weighted};
use crate::faces::vector::*;
use step21::{Args, Entity, Result};

const MOST_OF_CURVE: usize = 10_000;
/// Places at which the nearest one to a point is looked for first.
const PLACES: std::ops::RangeInclusive<usize> = 64..=2048;

pub struct Spline {
    pub degree: usize,
    /// Each as often as it counts.
    pub knots: Vec<f64>,
    /// Control points times their weights, and the weights.
    pub poles: Vec<Pole>,
}

/// Records of curves that say what the knots are.
const CURVES: [&str; 4] = [
    "B_SPLINE_CURVE_WITH_KNOTS",
    "BEZIER_CURVE",
    "QUASI_UNIFORM_CURVE",
    "UNIFORM_CURVE",
];

impl Spline {
    pub fn is_one(entity: Entity) -> bool {
        entity.find(&CURVES).is_some()
    }

    pub fn read(entity: Entity, context: &Context) -> Result<Spline> {
        let kind = entity.need(&CURVES)?;
        let curve = kind.of("B_SPLINE_CURVE")?;
        let first = curve.first();
        let degree = curve.whole(first)?;
        let points = curve.entities(first + 1)?;
        let count = points.len();
        let (degrees, counts) = (1..=HIGHEST_DEGREE, degree + 1..=MOST_OF_CURVE);
        if !degrees.contains(&degree) || !counts.contains(&count) {
            return Err(curve.error(
                format!("{count} control points for degree {degree}"),
                "degrees 1 to 25 and more control points than the degree, up to 10000, are possible",
            ));
        }
        let weights = match entity.find(&["RATIONAL_B_SPLINE_CURVE"]) {
            Some(args) => weights(&args, args.numbers(0)?, count)?,
            None => vec![1.0; count],
        };
        let pole = |(entity, weight)| Ok(weighted(point(entity, context)?, weight));
        let first = if entity.complex { 0 } else { 6 };
        Ok(Spline {
            degree,
            poles: points
                .into_iter()
                .zip(weights)
                .map(pole)
                .collect::<Result<_>>()?,
            knots: knots(&kind, [first, first + 1], degree, count)?,
        })
    }

    pub fn domain(&self) -> [f64; 2] {
        [self.knots[self.degree], self.knots[self.poles.len()]]
    }

    pub fn pieces(&self) -> usize {
        let inside = &self.knots[self.degree..=self.poles.len()];
        inside.windows(2).filter(|pair| pair[0] < pair[1]).count()
    }

    /// The point of a parameter (de Boor).
    pub fn at(&self, parameter: f64) -> Vector {
        let [low, high] = self.domain();
        let u = parameter.clamp(low, high);
        let after = self.knots.partition_point(|knot| *knot <= u);
        // The last piece has its end.
        let span = (after.max(1) - 1).clamp(self.degree, self.poles.len() - 1);
        let own = &self.poles[span - self.degree..=span];
        plain(&de_boor(self.degree, &self.knots, own, span, |_| u))
    }

    /// The parameter of the point of the curve nearest to `p`, and their distance.
    pub fn nearest(&self, p: Vector) -> (f64, f64) {
        let [low, high] = self.domain();
        let off = |u: f64| distance(self.at(u), p);
        let steps = (16 * self.pieces()).clamp(*PLACES.start(), *PLACES.end());
        let place = |k: usize| low + (high - low) * k as f64 / steps as f64;
        let best = (0..=steps).min_by(|i, j| off(place(*i)).total_cmp(&off(place(*j))));
        let best = best.unwrap_or(0);
        let [mut a, mut b] = [place(best.saturating_sub(1)), place((best + 1).min(steps))];
        // A third of the interval goes in every round.
        for _ in 0..80 {
            let [c, d] = [a + (b - a) / 3.0, b - (b - a) / 3.0];
            (a, b) = if off(c) <= off(d) { (a, d) } else { (c, b) };
        }
        let mut found = [low, high, place(best), 0.5 * (a + b)].map(|u| (u, off(u)));
        found.sort_by(|one, other| one.1.total_cmp(&other.1));
        found[0]
    }
}

pub fn weights(args: &Args, weights: Vec<f64>, count: usize) -> Result<Vec<f64>> {
    if weights.len() != count {
        let problem = format!("{} weights for {count} control points", weights.len());
        return Err(args.error(problem, "a weight for every control point is needed"));
    }
    if let Some(weight) = weights.iter().find(|w| !(1e-9..=1e9).contains(*w)) {
        let problem = format!("a weight of {weight}");
        return Err(args.error(problem, "weights from 1e-9 to 1e9 are possible"));
    }
    Ok(weights)
}

/// The knots in one direction: as written, the multiplicities and the values at these places, or implied by the kind.
pub fn knots(args: &Args, places: [usize; 2], degree: usize, count: usize) -> Result<Vec<f64>> {
    if !args.record.name.ends_with("_WITH_KNOTS") {
        return implied_knots(args, degree, count);
    }
    let times = args.wholes(places[0])?;
    let values = args.numbers(places[1])?;
    let total: usize = times.iter().sum();
    let rising = values.windows(2).all(|pair| pair[0] < pair[1]);
    let bounded = values.iter().all(|value| value.abs() <= 1e15);
    let possible = times.iter().all(|times| (1..=degree + 1).contains(times));
    let enough = times.len() == values.len() && total == count + degree + 1;
    if !(enough && rising && bounded && possible) {
        return Err(args.error(
            format!(
                "{} knots, {total} with their multiplicities, for {count} control points of degree {degree}",
                values.len()
            ),
            "as many rising knots as multiplicities are needed, none above the degree and one, and together a knot for every control point and the degree and one more",
        ));
    }
    let repeated = |(value, times)| std::iter::repeat_n(value, times);
    let knots: Vec<f64> = values.into_iter().zip(times).flat_map(repeated).collect();
    if knots[degree] >= knots[count] {
        let accepted = "knots that differ between the first and the last pieces are needed";
        return Err(args.error("its parameter has no range", accepted));
    }
    Ok(knots)
}

fn implied_knots(args: &Args, degree: usize, count: usize) -> Result<Vec<f64>> {
    let total = count + degree + 1;
    let is = |kind: &str| args.record.name.starts_with(kind);
    let knot = |index: usize| match () {
        () if is("UNIFORM") => index as f64,
        () if is("QUASI_UNIFORM") => (index.clamp(degree, count) - degree) as f64,
        // The joints of the pieces count as often as the degree.
        () => index.div_ceil(degree).clamp(1, (count - 1) / degree + 1) as f64,
    };
    if is("BEZIER") && !(count - 1).is_multiple_of(degree) {
        let problem = format!("{count} control points for pieces of degree {degree}");
        let accepted = "one control point and as many as the degree for every piece are needed";
        return Err(args.error(problem, accepted));
    }
    Ok((0..total).map(knot).collect())
}

const HIGHEST_DEGREE: usize = 25;
const MOST_POLES: usize = 40_000;
/// How far a swept surface goes on both sides of its curve, in sizes of it: faces are a part of that.
const REACH: f64 = 50.0;

const SURFACES: [&str; 4] = [
    "B_SPLINE_SURFACE_WITH_KNOTS",
    "BEZIER_SURFACE",
    "QUASI_UNIFORM_SURFACE",
    "UNIFORM_SURFACE",
];

/// The patches of a free-form surface; nothing for one of another kind.
pub fn freeform(entity: Entity, context: &Context) -> Result<Option<Vec<Patch>>> {
    if let Some(kind) = entity.find(&SURFACES) {
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
        let pole = |entity| Ok(weighted(point(entity, context)?, 1.0));
        poles.push(entities.into_iter().map(pole).collect::<Result<_>>()?);
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
        let own = Spline::read(entity, context)?;
        return Ok(Some(pieces(own.degree, &own.knots, &own.poles)));
    }
    if let Some(args) = entity.find(&["LINE"]) {
        let (origin, course) = line(&args, context)?;
        let pole = |factor: f64| weighted(along(origin, factor, course), 1.0);
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
        weighted(plus(plus(centre, times(a, x)), times(b, y)), weight)
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
    let out = across(from, axis);
    let mut circle = arcs(along(origin, dot(from, axis), axis), out, cross(axis, out));
    for own in circle.iter_mut().flatten() {
        *own = own.map(|value| value * pole[3]);
    }
    circle
}

/// Patches where their part is placed.
pub fn placed(mut patches: Vec<Patch>, place: &Placement) -> Vec<Patch> {
    for pole in patches.iter_mut().flat_map(|patch| &mut patch.poles) {
        *pole = weighted(place.point(plain(pole)), pole[3]);
    }
    patches
}
