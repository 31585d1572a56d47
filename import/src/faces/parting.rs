//! How a face is divided: terms of few separators, and straight lines that part two conics in a plane.

use super::arrangement::{Conic, MAX_SEPARATORS, Parting};
use super::cover::{Conflict, Sample, Term, cover};
use super::task::Task;
use super::vector::*;
use super::{Curve, Ellipse, Form, Implicit, PlaneOf, Surface};
use std::f64::consts::PI;

/// Planes that take apart what one object cannot be: two conics in one term, more sides than there may be.
fn refined(
    parting: &Parting,
    terms: &[Term],
    samples: &[Sample],
    most: usize,
    surface: &Surface,
) -> Vec<PlaneOf> {
    let mut new = vec![];
    let of = |k: &usize| parting.shapes.get(k);
    for term in terms {
        let own = parting.conics(term);
        for (i, (one, _)) in own.iter().enumerate() {
            for (other, _) in &own[i + 1..] {
                if let (Some(a), Some(b)) = (of(one), of(other)) {
                    new.extend(between_conics(a, b, surface.axis));
                }
            }
        }
    }
    if new.is_empty() {
        let large = terms.iter().filter(|term| !parting.fits(term, most));
        new.extend(large.map(|term| halving(term, samples, surface)));
    }
    new
}

/// A plane through the middle of a term's pieces across their greatest extent.
fn halving(term: &Term, samples: &[Sample], surface: &Surface) -> PlaneOf {
    let own = samples.iter().filter(|s| term.takes(s.sides));
    let own: Vec<Vector> = own.map(|s| s.point).collect();
    let middle = mean(&own);
    let apart = own.iter().map(|p| minus(*p, middle));
    let farthest = apart.max_by(|p, q| dot(*p, *p).total_cmp(&dot(*q, *q)));
    let farthest = farthest.unwrap_or([1.0, 0.0, 0.0]);
    (middle, unit(within(farthest, surface)))
}

/// Of a direction, what is within the surface if that is a plane.
fn within(direction: Vector, surface: &Surface) -> Vector {
    match surface.plane() {
        Some((_, normal)) => along(direction, -dot(direction, normal), normal),
        None => direction,
    }
}

/// Most rounds of splitting a face before it is given up: the depth limit of trim structures (thesis section III.4.2).
pub const MAX_ROUNDS: usize = 13;

/// Most pieces of a border from which a search for few terms is worth its time.
const MOST_SEARCHED: usize = 128;

const MOST_SAMPLES: usize = 100_000;

/// Terms of a parting with conics, split until each is one object with so many sides at most.
///
/// First with the fewest sides for every term, which drops a plane that only halves a convex piece; where that does
/// not end on a plane, once more with the halves.
pub fn terms(task: Task, parting: &mut Parting, most: usize) -> Result<Vec<Term>, String> {
    if parting.separators.len() > MOST_SEARCHED {
        return Err("its border has too many pieces for the search".into());
    }
    let start = parting.clone();
    match attempt(task, parting, most, false) {
        Err(Trouble::Unresolved(_)) if task.face().surface.is_plane() => {
            *parting = start;
            attempt(task, parting, most, true)
        }
        other => other,
    }
    .map_err(|trouble| match trouble {
        Trouble::Wrong(reason) => reason.into(),
        Trouble::Unresolved(trouble) => format!(
            "it is not resolved within {MAX_ROUNDS} rounds of splitting and {MAX_SEPARATORS} planes: {trouble}"
        ),
    })
}

enum Trouble {
    /// Its loops make no face.
    Wrong(&'static str),
    /// The rounds or planes were not enough.
    Unresolved(&'static str),
}

fn attempt(
    task: Task,
    parting: &mut Parting,
    most: usize,
    halves: bool,
) -> Result<Vec<Term>, Trouble> {
    let surface = &task.face().surface;
    let mut trouble = "";
    for _ in 0..MAX_ROUNDS {
        let samples = parting.samples(surface, task.part.model.size());
        let samples = samples.map_err(Trouble::Wrong)?;
        if samples.len() > MOST_SAMPLES {
            break;
        }
        if !samples.iter().any(|sample| sample.inside) {
            return Err(Trouble::Wrong("its loops enclose nothing"));
        }
        let fits = |term: &Term| parting.fits(term, most);
        let new = match cover(&samples, &parting.ranks, halves.then_some(&fits)) {
            Err(conflicts) => {
                trouble = "pieces of it lie on the same side of all its planes as others that are not of it";
                conflicts.iter().map(|c| between(c, surface)).collect()
            }
            Ok(terms) => {
                let new = refined(parting, &terms, &samples, most, surface);
                if new.is_empty() {
                    return Ok(terms);
                }
                trouble = "a convex piece of it has more sides than an object has cut planes";
                new
            }
        };
        if !parting.split(&task.part.planes, &new) {
            break;
        }
    }
    Err(Trouble::Unresolved(trouble))
}

/// A plane between two pieces that no separator tells apart.
fn between(conflict: &Conflict, surface: &Surface) -> PlaneOf {
    let [p, q] = conflict.map(|sample| sample.point);
    (times(0.5, plus(p, q)), unit(within(minus(q, p), surface)))
}

/// Most sides of a polygon between two circles, one in the other.
const MAX_SIDES: usize = 60;

impl Conic {
    /// The conic of an edge in which a quadric meets the plane.
    pub fn of(implicit: Implicit, curve: &Curve, origin: Vector, normal: Vector) -> Conic {
        let (centre, radii) = match curve {
            Curve::Arc(arc) => (arc.ellipse.centre, range(arc.ellipse.radii.into_iter())),
            _ => {
                let points = curve.sampled(64);
                let centre = middle(&implicit, origin, normal).unwrap_or_else(|| mean(&points));
                (centre, range(points.iter().map(|p| distance(*p, centre))))
            }
        };
        Conic {
            implicit,
            centre,
            radii,
        }
    }

    /// The cylinder upright on an ellipse.
    pub fn upright(ellipse: &Ellipse, normal: Vector) -> Conic {
        let (centre, x, radii) = (ellipse.centre, ellipse.x, ellipse.radii);
        let round = Surface::new(centre, normal, Form::Cylinder(radii[0])).implicit();
        let round = round.filter(|_| radii[0] == radii[1]);
        Conic {
            implicit: round.unwrap_or_else(|| elliptic(centre, [x, cross(normal, x)], radii)),
            centre,
            radii: range(radii.into_iter()),
        }
    }
}

/// `(x.(p - c))^2 / a^2 + (y.(p - c))^2 / b^2 - 1`
fn elliptic(centre: Vector, axes: [Vector; 2], radii: [f64; 2]) -> Implicit {
    let mut all = [0.0; 10];
    for (axis, radius) in axes.into_iter().zip(radii) {
        let weight = 1.0 / (radius * radius);
        let offset = dot(axis, centre);
        let [x, y, z] = axis;
        let own = [x * x, y * y, z * z, x * y, x * z, y * z];
        let linear = axis.map(|v| -offset * v);
        let terms = own.into_iter().chain(linear).chain([offset * offset]);
        for (sum, term) in all.iter_mut().zip(terms) {
            *sum += weight * term;
        }
    }
    all[9] -= 1.0;
    Implicit(all)
}

/// Centre of the conic in which a quadric meets a plane; nothing for a parabola.
fn middle(implicit: &Implicit, origin: Vector, normal: Vector) -> Option<Vector> {
    let [e, f] = frame(normal, 0.0);
    let gradient = |p: Vector| {
        let g = implicit.half_gradient(p);
        [dot(g, e), dot(g, f)]
    };
    let [p, q] = gradient(origin);
    let [a, b] = gradient(plus(origin, e));
    let [c, d] = gradient(plus(origin, f));
    let (a, b, c, d) = (a - p, b - q, c - p, d - q);
    let determinant = a * d - b * c;
    if determinant.abs() <= 1e-12 * (a * a + b * b + c * c + d * d) {
        return None;
    }
    let u = -(p * d - q * c) / determinant;
    let v = -(a * q - b * p) / determinant;
    Some(along(along(origin, u, e), v, f))
}

/// Planes upright on the face, so that no region between them needs both conics.
///
/// Side by side: one line between them. Crossing circles: the line through both points. One in the other: a polygon
/// around the inner one, inside the outer one.
fn between_conics(one: &Conic, other: &Conic, normal: Vector) -> Vec<PlaneOf> {
    let swapped = one.radii[1] > other.radii[1];
    let (small, large) = if swapped { (other, one) } else { (one, other) };
    let gap = across(minus(large.centre, small.centre), normal);
    let (d, r, s) = (length(gap), small.radii[1], large.radii[1]);
    let line = |share: f64| vec![(along(small.centre, share, unit(gap)), unit(gap))];
    if d >= r + s {
        return line(r + 0.5 * (d - r - s));
    }
    if d + r < large.radii[0] {
        return polygon(small, large.radii[0] - d, normal);
    }
    if d == 0.0 {
        return vec![];
    }
    // The radical axis of two circles; of ellipses, the line halfway, which the rounds of splitting go on from.
    line((d * d + r * r - s * s) / (2.0 * d))
}

/// A regular polygon around a conic and within a circle about its centre; nothing if it had too many sides.
fn polygon(small: &Conic, within: f64, normal: Vector) -> Vec<PlaneOf> {
    let inner = small.radii[1];
    let fits = |n: &usize| (PI / *n as f64).cos() * within > inner * 1.000_001;
    let sides = [4, 6, 8, 10, 12, 16, 20, 28, 40, MAX_SIDES];
    let Some(n) = sides.into_iter().find(fits) else {
        return vec![];
    };
    let reach = 0.5 * (inner + within * (PI / n as f64).cos());
    let [e, f] = frame(normal, 0.0);
    let side = |k: usize| {
        let (sine, cosine) = (2.0 * PI * k as f64 / n as f64).sin_cos();
        let out = plus(times(cosine, e), times(sine, f));
        (along(small.centre, reach, out), out)
    };
    (0..n).map(side).collect()
}
