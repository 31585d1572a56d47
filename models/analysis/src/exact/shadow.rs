//! Which sources reach what is seen, in exact arithmetic: the segment from each visible point to each source against
//! each solid.
//!
//! The visible point has coordinates `u + v sqrt(q)` with the discriminant q of its ray, and so has everything that is
//! first or second degree in it; the signs of such numbers are decided exactly. No volume, no polar plane and nothing
//! of the preparation is used.
//!
//! A point of the segment is `a source + b point`, a and b not negative. The planes leave an interval of it, and a
//! quadratic form in (a, b) that is not positive somewhere in that interval, the visible point itself not counted, is a
//! solid in the way.

use super::ray::{first_degree, ray_points};
use super::render::View;
use super::surd::Surd;
use imogene_algebra::matrix::image;
use imogene_algebra::vector;
use imogene_algebra::whole::common_denominator;
use imogene_golden::machine::lighting::{ALL_SOURCES, Lighting};
use imogene_scene::{FramedObject, FramedScene, FramedSource, Surface};
use num_bigint::BigInt;
use num_traits::Zero;
use rayon::prelude::*;
use std::cmp::Ordering;

type Vector = [BigInt; 4];
type Point = [Surd; 4];

/// The flags of a picture's sources; `line_done` is called once a line, from any thread.
pub fn lighting(scene: &FramedScene, line_done: impl Fn() + Sync) -> Lighting {
    let (width, height) = (scene.width, scene.height);
    let view = View::new(scene);
    let solids: Vec<Solid> = scene.objects.iter().filter_map(Solid::casting).collect();
    let sources: Vec<Source> = scene
        .sources
        .iter()
        .map(|source| Source::new(source, &solids))
        .collect();
    let (constant, slope) = ray_points(scene);
    let line = |y: i64| {
        let flags: Vec<u16> = (0..i64::from(width))
            .map(|x| {
                let Some((_, hit)) = view.visible(x, y) else {
                    return ALL_SOURCES;
                };
                let [from, along] =
                    [&constant, &slope].map(|p| p.each_ref().map(|p| first_degree(p, x, y)));
                let point = homogeneous(&from, &along, &hit.w.as_surd());
                let reached = sources.iter().enumerate();
                reached.fold(ALL_SOURCES, |flags, (bit, source)| {
                    if source.reaches(&point, &solids) {
                        flags
                    } else {
                        flags & !(1 << bit)
                    }
                })
            })
            .collect();
        line_done();
        flags
    };
    Lighting {
        flags: (0..i64::from(height))
            .into_par_iter()
            .flat_map_iter(line)
            .collect(),
    }
}

/// `d (from + w along)` for `w = n / d`, d > 0.
fn homogeneous(from: &Vector, along: &Vector, (n, d): &(Surd, BigInt)) -> Point {
    std::array::from_fn(|k| n.times(&along[k]).plus(&Surd::whole(&from[k] * d, n)))
}

/// An object that casts a shadow: inside where all are not positive.
struct Solid {
    q: [Vector; 4],
    planes: Vec<Vector>,
}

impl Solid {
    /// A patch casts a shadow only if it is closed, and then that of its inside.
    fn casting(object: &FramedObject) -> Option<Solid> {
        let caster = object.caster()?;
        let closed = caster.surface == Surface::Solid || caster.planes.is_empty();
        closed.then(|| Solid::of(&caster.quadric, &caster.planes))
    }

    fn of(quadric: &imogene_scene::Quadric, planes: &[imogene_scene::Plane]) -> Solid {
        let q = quadric.clone().primitive().matrix();
        Solid {
            q: q.map(|row| row.map(|v| v.to_integer())),
            planes: planes
                .iter()
                .map(|p| p.clone().primitive().coefficients().map(|v| v.to_integer()))
                .collect(),
        }
    }

    fn contains(&self, point: &Point) -> bool {
        let in_quadric = value(&self.q, point).sign() != Ordering::Greater;
        in_quadric
            && self
                .planes
                .iter()
                .all(|p| dot(p, point).sign() != Ordering::Greater)
    }
}

struct Source {
    point: Vector,
    casts: bool,
    cone: Option<Solid>,
    /// For every solid: Q s, s'Qs and p.s of each plane.
    seen: Vec<Seen>,
}

struct Seen {
    polar: Vector,
    value: BigInt,
    planes: Vec<BigInt>,
}

impl Source {
    fn new(source: &FramedSource, solids: &[Solid]) -> Source {
        let (point, _) = common_denominator(source.point.each_ref());
        let seen = solids.iter().map(|solid| {
            let polar = image(&solid.q, &point);
            let planes = solid.planes.iter();
            Seen {
                value: vector::dot(&polar, &point),
                planes: planes.map(|p| vector::dot(p, &point)).collect(),
                polar,
            }
        });
        Source {
            seen: seen.collect(),
            casts: source.shadows,
            cone: source
                .cone
                .as_ref()
                .map(|c| Solid::of(&c.quadric, std::slice::from_ref(&c.plane))),
            point,
        }
    }

    fn reaches(&self, point: &Point, solids: &[Solid]) -> bool {
        debug_assert!(self.point.iter().any(|v| !v.is_zero()));
        self.cone.as_ref().is_none_or(|cone| cone.contains(point))
            && !(self.casts
                && solids
                    .iter()
                    .zip(&self.seen)
                    .any(|(solid, seen)| is_in_the_way(solid, seen, point)))
    }
}

/// The factors a and b of a point `a source + b point` of the segment.
type Weights = [Surd; 2];

/// Does the segment from the source to the point, the point itself left out, meet the solid.
fn is_in_the_way(solid: &Solid, seen: &Seen, point: &Point) -> bool {
    let like = &point[0];
    let number = |v: i64| Surd::whole(BigInt::from(v), like);
    // From the source towards the point, b / a grows.
    let mut start = [number(1), number(0)];
    let mut end = [number(0), number(1)];
    let mut end_is_point = true;
    for (plane, at_source) in solid.planes.iter().zip(&seen.planes) {
        let at_source = Surd::whole(at_source.clone(), like);
        let at_point = dot(plane, point);
        let kept = |v: &Surd| v.sign() != Ordering::Greater;
        match (kept(&at_source), kept(&at_point)) {
            (true, true) => {}
            (false, false) => return false,
            // Crossed where a at_source + b at_point = 0.
            (false, true) => {
                let bound = [at_point.negated(), at_source];
                if is_before(&start, &bound) {
                    start = bound;
                }
            }
            (true, false) => {
                let bound = [at_point, at_source.negated()];
                if is_before(&bound, &end) {
                    end = bound;
                    end_is_point = false;
                }
            }
        }
    }
    if is_before(&end, &start) {
        return false;
    }
    let form = Form {
        aa: Surd::whole(seen.value.clone(), like),
        ab: dot(&seen.polar, point),
        bb: value(&solid.q, point),
    };
    if start[0].sign() == Ordering::Equal {
        // Only the point itself is left.
        return false;
    }
    let at_start = form.at(&start, &start);
    let at_end = form.at(&end, &end);
    if at_start.sign() != Ordering::Greater {
        return true;
    }
    let mixed = form.at(&start, &end);
    match at_end.sign() {
        Ordering::Less => true,
        // Only the point itself unless the form falls below zero before it.
        Ordering::Equal => !end_is_point || mixed.sign() == Ordering::Less,
        Ordering::Greater => {
            mixed.sign() == Ordering::Less
                && mixed
                    .product(&mixed)
                    .minus(&at_start.product(&at_end))
                    .sign()
                    != Ordering::Less
        }
    }
}

/// Is the first nearer to the source: b1 / a1 < b2 / a2.
fn is_before(first: &Weights, second: &Weights) -> bool {
    let (left, right) = (first[1].product(&second[0]), second[1].product(&first[0]));
    left.minus(&right).sign() == Ordering::Less
}

/// The solid's quadric on the segment: `aa a^2 + 2 ab a b + bb b^2`.
struct Form {
    aa: Surd,
    ab: Surd,
    bb: Surd,
}

impl Form {
    fn at(&self, u: &Weights, v: &Weights) -> Surd {
        let mixed = u[0].product(&v[1]).plus(&u[1].product(&v[0]));
        let aa = self.aa.product(&u[0].product(&v[0]));
        let bb = self.bb.product(&u[1].product(&v[1]));
        aa.plus(&self.ab.product(&mixed)).plus(&bb)
    }
}

fn dot(plane: &Vector, point: &Point) -> Surd {
    let terms = plane.iter().zip(point).map(|(p, x)| x.times(p));
    terms.reduce(|a, b| a.plus(&b)).expect("four terms")
}

fn value(q: &[Vector; 4], point: &Point) -> Surd {
    let terms = q
        .iter()
        .zip(point)
        .map(|(row, x)| dot(row, point).product(x));
    terms.reduce(|a, b| a.plus(&b)).expect("four terms")
}
