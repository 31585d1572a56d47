//! B-spline curves, rational ones among them (ISO 10303-42, clause 4.4.34).

use super::placement::point;
use super::units::Context;
use crate::faces::bezier::{Pole, de_boor, pieces};
use crate::faces::vector::{Vector, distance};
use step21::{Args, Entity, Result};

const HIGHEST_DEGREE: usize = 25;
const MOST_POLES: usize = 10_000;
/// Places at which the nearest one to a point is looked for first.
const PLACES: std::ops::RangeInclusive<usize> = 64..=2048;

#[derive(Clone, Debug)]
pub struct Spline {
    pub degree: usize,
    /// Each as often as it counts.
    pub knots: Vec<f64>,
    /// Control points times their weights, and the weights.
    pub poles: Vec<Pole>,
}

/// Records that say what the knots are.
const KINDS: [&str; 4] = [
    "B_SPLINE_CURVE_WITH_KNOTS",
    "BEZIER_CURVE",
    "QUASI_UNIFORM_CURVE",
    "UNIFORM_CURVE",
];

impl Spline {
    pub fn is_one(entity: Entity) -> bool {
        entity.find(&KINDS).is_some()
    }

    pub fn read(entity: Entity, context: &Context) -> Result<Spline> {
        let kind = entity.need(&KINDS)?;
        let curve = kind.of("B_SPLINE_CURVE")?;
        let first = curve.first();
        let degree = curve.whole(first)?;
        let points = curve.entities(first + 1)?;
        let count = points.len();
        if !(1..=HIGHEST_DEGREE).contains(&degree) || !(degree + 1..=MOST_POLES).contains(&count) {
            return Err(curve.error(
                format!("{count} control points for degree {degree}"),
                "degrees 1 to 25 and more control points than the degree, up to 10000, are possible",
            ));
        }
        let weights = match entity.find(&["RATIONAL_B_SPLINE_CURVE"]) {
            Some(args) => weights(&args, args.numbers(0)?, count)?,
            None => vec![1.0; count],
        };
        let mut poles = vec![];
        for (entity, weight) in points.into_iter().zip(weights) {
            let [x, y, z] = point(entity, context)?.map(|value| value * weight);
            poles.push([x, y, z, weight]);
        }
        let first = if entity.complex { 0 } else { 6 };
        Ok(Spline {
            degree,
            knots: knots(&kind, [first, first + 1], degree, count)?,
            poles,
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
        let point = de_boor(self.degree, &self.knots, own, span, |_| u);
        let [x, y, z, weight] = point;
        [x / weight, y / weight, z / weight]
    }

    pub fn bezier(&self) -> Vec<Vec<Pole>> {
        pieces(self.degree, &self.knots, &self.poles)
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

/// Weights of control points, checked.
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

/// The knots of a curve or surface in one direction: as they are written, at these two places the multiplicities and
/// the knots, or as they follow from the kind.
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
    if times.len() != values.len()
        || total != count + degree + 1
        || !(rising && bounded && possible)
    {
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

/// Knots that follow from the kind of the curve or surface.
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
