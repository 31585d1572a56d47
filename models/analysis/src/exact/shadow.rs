//! Which sources reach what is seen, in exact arithmetic: the segment from each visible point to each source against
//! each solid.
//!
//! The visible point has coordinates `u + v sqrt(q)` with the discriminant q of its ray, and so has everything that is
//! first or second degree in it; the signs of such numbers are decided exactly. No volume, no polar plane and nothing
//! of the preparation is used.
//!
//! A point of the segment is `a source + b point`, a and b not negative. The planes leave an interval of it, and a
//! quadratic form in (a, b) that is not positive somewhere in that interval, the visible point itself not counted, is a
//! solid in the way. A facet of a mesh is in the way of a point beyond its plane, and not outside of any plane through
//! the source and one of its sides; of its own points if the viewer sees its other side. The signs are first told in
//! ball arithmetic, and in exact numbers where that leaves one open.

use super::number::{Ball, Number, Surd, SurdReal, balls, exponent};
use super::ray::{first_degree, ray_points};
use super::render::View;
use imogene_algebra::rational::integer;
use imogene_algebra::vector;
use imogene_algebra::whole::common_denominator;
use imogene_golden::machine::lighting::{ALL_SOURCES, Lighting};
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR, FACE_PLANE};
use imogene_scene::{
    FramedMesh, FramedObject, FramedScene, FramedSource, Plane, Projection, Quadric, Surface,
};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use rayon::prelude::*;
use std::cmp::Ordering;

type Vector<F> = [F; 4];
type Whole = Vector<BigInt>;

/// The flags of a picture's sources; `line_done` is called once a line, from any thread.
pub fn lighting(scene: &FramedScene, line_done: impl Fn() + Sync) -> Lighting {
    let view = View::new(scene);
    let objects = scene.objects.iter().enumerate();
    let casters: Vec<Caster> = objects.filter_map(Caster::of).collect();
    let meshes = scene.objects.iter().filter_map(|object| match object {
        FramedObject::Mesh(mesh) if mesh.casts_shadow => Some(&**mesh),
        _ => None,
    });
    let meshes: Vec<&FramedMesh> = meshes.collect();
    let viewer = viewer(scene);
    let source = |source| Source::new(source, &casters, &meshes, &viewer);
    let sources: Vec<Source> = scene.sources.iter().map(source).collect();
    let (constant, slope) = ray_points(scene);
    let flags_at = |x: i64, y: i64| {
        let Some((object, hit)) = view.visible(x, y) else {
            return ALL_SOURCES;
        };
        let ray = [&constant, &slope].map(|p| p.each_ref().map(|p| first_degree(p, x, y)));
        let point = Seen {
            exact: exact_point(&ray, &hit.w),
            near: near_point(&ray, &hit.w),
            object: object as usize,
            face: hit.number,
        };
        let sources = sources.iter().enumerate();
        let dark = sources.filter(|(_, source)| !source.reaches(&point, &casters));
        dark.fold(ALL_SOURCES, |flags, (bit, _)| flags & !(1 << bit))
    };
    let line = |y: i64| {
        let flags = (0..i64::from(scene.width)).map(|x| flags_at(x, y));
        let flags: Vec<u16> = flags.collect();
        line_done();
        flags
    };
    let lines = (0..i64::from(scene.height)).into_par_iter();
    Lighting {
        flags: lines.flat_map_iter(line).collect(),
    }
}

fn viewer(scene: &FramedScene) -> Whole {
    let [zero, one] = [0, 1].map(integer);
    let point = match &scene.projection {
        Projection::Perspective { distance } => [&zero, &zero, &-distance, &one],
        Projection::Orthographic { .. } => [&zero, &zero, &-&one, &zero],
    };
    common_denominator(point).0
}

struct Seen {
    exact: Vector<Surd>,
    near: Vector<Ball>,
    object: usize,
    face: u8,
}

/// `d (from + w along)` for `w = n / d`, d > 0.
fn exact_point([from, along]: &[Whole; 2], w: &SurdReal) -> Vector<Surd> {
    let (n, d) = w.as_surd();
    std::array::from_fn(|k| n.times(&along[k]).plus(&n.of(&(&from[k] * &d))))
}

/// `from + w along`, times a positive factor.
fn near_point([from, along]: &[Whole; 2], w: &SurdReal) -> Vector<Ball> {
    let exponent = exponent(from.iter().chain(along));
    let [from, along] = [from, along].map(|v| v.each_ref().map(|v| Ball::scaled(v, exponent)));
    let w = w.ball();
    std::array::from_fn(|k| from[k].plus(&along[k].product(&w)))
}

/// What is inside where all are not positive.
struct Solid<F> {
    q: [Vector<F>; 4],
    planes: Vec<Vector<F>>,
}

impl Solid<BigInt> {
    fn new(quadric: &Quadric, planes: &[Plane]) -> Self {
        let q = quadric.clone().primitive().matrix();
        let whole = |plane: &Plane| {
            let plane = plane.clone().primitive();
            plane.coefficients().map(|v| v.to_integer())
        };
        Solid {
            q: q.map(|row| row.map(|v| v.to_integer())),
            planes: planes.iter().map(whole).collect(),
        }
    }

    fn near(&self) -> Solid<Ball> {
        let exponent = exponent(self.q.iter().flatten());
        let row = |row: &Whole| row.each_ref().map(|v| Ball::scaled(v, exponent));
        Solid {
            q: self.q.each_ref().map(row),
            planes: self.planes.iter().map(balls).collect(),
        }
    }
}

impl<F> Solid<F> {
    fn contains<N: Number<Factor = F>>(&self, point: &Vector<N>) -> Option<bool> {
        if is_positive(&value(&self.q, point))? {
            return Some(false);
        }
        for plane in &self.planes {
            if is_positive(&dot(plane, point))? {
                return Some(false);
            }
        }
        Some(true)
    }
}

/// A solid in both kinds of numbers.
struct Both {
    exact: Solid<BigInt>,
    near: Solid<Ball>,
}

impl Both {
    fn new(quadric: &Quadric, planes: &[Plane]) -> Both {
        let exact = Solid::new(quadric, planes);
        let near = exact.near();
        Both { exact, near }
    }

    fn contains(&self, point: &Seen) -> bool {
        let exact = || self.exact.contains(&point.exact).expect(EXACT);
        self.near.contains(&point.near).unwrap_or_else(exact)
    }
}

struct Caster {
    object: usize,
    solid: Both,
}

impl Caster {
    /// A patch casts a shadow only if it is closed, and then that of its inside.
    fn of((object, framed): (usize, &FramedObject)) -> Option<Caster> {
        let caster = framed.caster()?;
        let closed = caster.surface == Surface::Solid || caster.planes.is_empty();
        closed.then(|| Caster {
            object,
            solid: Both::new(&caster.quadric, &caster.planes),
        })
    }
}

struct Source {
    casts: bool,
    cone: Option<Both>,
    /// Every caster as the source sees it.
    exact: Vec<Lit<BigInt>>,
    near: Vec<Lit<Ball>>,
    /// Facets that it does not see edge-on.
    facets: Vec<Facet>,
}

/// What is beyond a facet as a source sees it: where the first plane, its own, is negative and the others, through the
/// source and one side each, are not positive.
struct Facet {
    exact: Vec<Whole>,
    near: Vec<Vector<Ball>>,
    /// The viewer and the source see different sides of it.
    is_unlit: bool,
}

impl Facet {
    fn new(corners: &[Whole], source: &Whole, viewer: &Whole) -> Option<Facet> {
        let own = through([&corners[0], &corners[1], &corners[2]]);
        let at_source = vector::dot(&own, source).signum();
        if at_source.is_zero() {
            return None;
        }
        let mut exact = vec![own.map(|v| v * &at_source)];
        for (k, corner) in corners.iter().enumerate() {
            let [next, other] = [1, 2].map(|ahead| &corners[(k + ahead) % corners.len()]);
            let side = through([source, corner, next]);
            let outwards = -vector::dot(&side, other).signum();
            exact.push(side.map(|v| v * &outwards));
        }
        Some(Facet {
            near: exact.iter().map(balls).collect(),
            is_unlit: vector::dot(&exact[0], viewer).is_negative(),
            exact,
        })
    }

    fn is_in_the_way(&self, point: &Seen) -> bool {
        let near = self.is_beyond(&self.near, &point.near);
        near.unwrap_or_else(|| self.is_beyond(&self.exact, &point.exact).expect(EXACT))
    }

    fn is_beyond<N: Number>(
        &self,
        planes: &[Vector<N::Factor>],
        point: &Vector<N>,
    ) -> Option<bool> {
        let mut all = Some(true);
        for (index, plane) in planes.iter().enumerate() {
            let value = dot(plane, point);
            match value.known_sign() {
                Some(Ordering::Greater) => return Some(false),
                Some(Ordering::Equal) if index == 0 && !self.is_unlit => return Some(false),
                Some(_) => {}
                None => all = None,
            }
        }
        all
    }
}

fn through([u, v, w]: [&Whole; 3]) -> Whole {
    std::array::from_fn(|k| {
        let [a, b, c] = [1, 2, 3].map(|ahead| (k + ahead) % 4);
        let part = |p: &Whole| [a, b, c].map(|at| p[at].clone());
        let minor = vector::dot(part(u), vector::cross(part(v), part(w)));
        // Turning four columns by one changes the sign of a determinant.
        if k % 2 == 0 { minor } else { -minor }
    })
}

fn facets(mesh: &FramedMesh) -> impl Iterator<Item = Vec<Whole>> {
    let homogeneous = |&corner: &usize| {
        let ([x, y, z], w) = common_denominator(mesh.vertices[corner].each_ref());
        [x, y, z, w]
    };
    let facets = mesh.facets.iter();
    facets.map(move |facet| facet.corners.iter().map(homogeneous).collect())
}

/// What a solid has at a source s: Q s, s'Qs and p.s of each plane.
struct Lit<F> {
    polar: Vector<F>,
    value: F,
    planes: Vec<F>,
}

impl<F> Lit<F> {
    fn new(solid: &Solid<F>, source: &Vector<F>, dot: fn(&Vector<F>, &Vector<F>) -> F) -> Self {
        let polar = solid.q.each_ref().map(|row| dot(row, source));
        Lit {
            value: dot(&polar, source),
            planes: solid.planes.iter().map(|p| dot(p, source)).collect(),
            polar,
        }
    }
}

impl Source {
    fn new(
        source: &FramedSource,
        casters: &[Caster],
        meshes: &[&FramedMesh],
        viewer: &Whole,
    ) -> Source {
        let (point, _) = common_denominator(source.point.each_ref());
        debug_assert!(point.iter().any(|v| !v.is_zero()));
        let near_point = balls(&point);
        let exact = |c: &Caster| Lit::new(&c.solid.exact, &point, |u, v| vector::dot(u, v));
        let near = |c: &Caster| Lit::new(&c.solid.near, &near_point, dot);
        let facet = |corners: Vec<_>| Facet::new(&corners, &point, viewer);
        let facets = meshes.iter().flat_map(|mesh| facets(mesh));
        let cone = source.cone.as_ref();
        Source {
            casts: source.shadows,
            cone: cone.map(|c| Both::new(&c.quadric, std::slice::from_ref(&c.plane))),
            exact: casters.iter().map(exact).collect(),
            near: casters.iter().map(near).collect(),
            facets: facets.filter_map(facet).collect(),
        }
    }

    fn reaches(&self, point: &Seen, casters: &[Caster]) -> bool {
        self.cone.as_ref().is_none_or(|cone| cone.contains(point))
            && !(self.casts && self.is_blocked(point, casters))
    }

    fn is_blocked(&self, point: &Seen, casters: &[Caster]) -> bool {
        if self.facets.iter().any(|facet| facet.is_in_the_way(point)) {
            return true;
        }
        let face = |caster: &Caster| (caster.object == point.object).then_some(point.face);
        let mut open = vec![];
        for (index, (caster, lit)) in casters.iter().zip(&self.near).enumerate() {
            match is_in_the_way(&caster.solid.near, lit, &point.near, face(caster)) {
                Some(true) => return true,
                Some(false) => {}
                None => open.push(index),
            }
        }
        open.into_iter().any(|index| {
            let (caster, lit) = (&casters[index], &self.exact[index]);
            let answer = is_in_the_way(&caster.solid.exact, lit, &point.exact, face(caster));
            answer.expect(EXACT)
        })
    }
}

/// Of numbers whose signs are all known.
const EXACT: &str = "an exact answer";

/// Does the segment from the source to the point, the point itself left out, meet the solid; `face` is that of the
/// solid on which the point lies, if it is one of its own. None where the signs leave it open.
fn is_in_the_way<N: Number>(
    solid: &Solid<N::Factor>,
    lit: &Lit<N::Factor>,
    point: &Vector<N>,
    face: Option<u8>,
) -> Option<bool> {
    let like = &point[0];
    let number = |v: i8| like.whole(v);
    // Factors a and b of points `a source + b point`: from the source towards the point, b / a grows.
    let mut start = [number(1), number(0)];
    let mut end = [number(0), number(1)];
    let mut end_is_point = true;
    for (i, (plane, at_source)) in solid.planes.iter().zip(&lit.planes).enumerate() {
        let at_source = like.of(at_source);
        let at_point = match face {
            Some(face) if face == FACE_PLANE + i as u8 => number(0),
            _ => dot(plane, point),
        };
        match (!is_positive(&at_source)?, !is_positive(&at_point)?) {
            (true, true) => {}
            (false, false) => return Some(false),
            // Crossed where a at_source + b at_point = 0.
            (false, true) => {
                let bound = [at_point.negated(), at_source];
                if is_before(&start, &bound)? {
                    start = bound;
                }
            }
            (true, false) => {
                let bound = [at_point, at_source.negated()];
                if is_before(&bound, &end)? {
                    end = bound;
                    end_is_point = false;
                }
            }
        }
    }
    if is_before(&end, &start)? {
        return Some(false);
    }
    // The solid's quadric on the segment: `aa a^2 + 2 ab a b + bb b^2`.
    let (aa, ab) = (like.of(&lit.value), dot(&lit.polar, point));
    let bb = match face {
        Some(FACE_NEAR | FACE_FAR) => number(0),
        _ => value(&solid.q, point),
    };
    let form = |u: &[N; 2], v: &[N; 2]| {
        let mixed = u[0].product(&v[1]).plus(&u[1].product(&v[0]));
        let ends = [(&aa, 0), (&bb, 1)].map(|(x, k)| x.product(&u[k].product(&v[k])));
        ends[0].plus(&ab.product(&mixed)).plus(&ends[1])
    };
    if start[0].known_sign()? == Ordering::Equal {
        // Only the point itself is left.
        return Some(false);
    }
    let at_start = form(&start, &start);
    if !is_positive(&at_start)? {
        return Some(true);
    }
    let at_end = form(&end, &end);
    let mixed = form(&start, &end);
    Some(match at_end.known_sign()? {
        Ordering::Less => true,
        // Only the point itself unless the form falls below zero before it.
        Ordering::Equal => !end_is_point || is_negative(&mixed)?,
        Ordering::Greater => {
            is_negative(&mixed)?
                && !is_negative(&mixed.product(&mixed).minus(&at_start.product(&at_end)))?
        }
    })
}

fn is_positive<N: Number>(number: &N) -> Option<bool> {
    Some(number.known_sign()? == Ordering::Greater)
}

fn is_negative<N: Number>(number: &N) -> Option<bool> {
    Some(number.known_sign()? == Ordering::Less)
}

/// Is the first nearer to the source: b1 / a1 < b2 / a2.
fn is_before<N: Number>(first: &[N; 2], second: &[N; 2]) -> Option<bool> {
    let (left, right) = (first[1].product(&second[0]), second[1].product(&first[0]));
    is_negative(&left.minus(&right))
}

fn dot<N: Number>(plane: &Vector<N::Factor>, point: &Vector<N>) -> N {
    sum(std::array::from_fn(|k| point[k].times(&plane[k])))
}

fn value<N: Number>(q: &[Vector<N::Factor>; 4], point: &Vector<N>) -> N {
    sum(std::array::from_fn(|k| {
        dot(&q[k], point).product(&point[k])
    }))
}

fn sum<N: Number>([a, b, c, d]: Vector<N>) -> N {
    a.plus(&b).plus(&c).plus(&d)
}
