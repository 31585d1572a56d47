//! Point in face by winding: the loops as polylines in parameters of the surface, no plane and no half-space.

use super::points::{Even, point_of};
use imogene_import::faces::model::{Face, Model};
use imogene_import::faces::vector::*;
use imogene_import::faces::{Curve, Form, Surface};
use std::f64::consts::TAU;

/// Steps of a curved edge.
const STEPS: usize = 120;

/// A face as its loops.
pub struct Oracle {
    surface: Surface,
    /// Edges in the direction of their loops.
    chains: Vec<Vec<Vector>>,
    /// A point of a sphere from which all is projected: it is not in the face.
    pole: Vector,
    coarseness: f64,
}

impl Oracle {
    /// Of some points in and near the face those that are farther than a length from every edge.
    pub fn points(&self, count: usize, seed: u64, off: f64) -> impl Iterator<Item = Vector> {
        let [low, high] = self.bounds();
        let (middle, size) = (times(0.5, plus(low, high)), distance(low, high));
        let mut even = Even(seed);
        let all = (0..count).map(move |_| point_of(&self.surface, middle, size, &mut even));
        all.filter(move |p| self.distance_to_edge(*p) > off + self.coarseness())
    }

    /// Of a face.
    pub fn new(model: &Model, face: &Face) -> Oracle {
        let mut chains = vec![];
        let mut coarseness: f64 = 1e-9 * model.size();
        for edge_use in face.loops.iter().flatten() {
            let curve = &model.edges[edge_use.edge].curve;
            let mut points = match curve {
                Curve::Points(_) => on_surfaces(model, edge_use.edge, curve.sampled(1)),
                _ => curve.sampled(STEPS),
            };
            if !matches!(curve, Curve::Line { .. }) {
                // Sagitta of the chords: an eighth of a step's square over the radius, at most a step of the radius
                // over 8.
                let steps = points.windows(2).map(|pair| distance(pair[0], pair[1]));
                let step = steps.fold(0.0, f64::max);
                coarseness = coarseness.max(step * step / smallest_radius(curve) / 8.0);
            }
            if !edge_use.forward {
                points.reverse();
            }
            chains.push(points);
        }
        let mut oracle = Oracle {
            surface: face.surface.clone(),
            chains,
            pole: [0.0; 3],
            coarseness: 2.0 * coarseness,
        };
        oracle.pole = oracle.outside();
        oracle
    }

    /// What the polylines are off the edges, scene units.
    pub fn coarseness(&self) -> f64 {
        self.coarseness
    }

    /// Least and greatest coordinates of the loops, or of the whole sphere.
    pub fn bounds(&self) -> [Vector; 2] {
        let origin = self.surface.origin;
        let mut points = self.chains.concat();
        if let Form::Sphere(radius) = self.surface.form {
            points.extend([-radius, radius].map(|r| origin.map(|v| v + r)));
        }
        hull(&points).expect("a border, or a whole sphere")
    }

    /// Distance of a point from the polylines.
    pub fn distance_to_edge(&self, p: Vector) -> f64 {
        let segments = self.chains.iter().flat_map(|chain| chain.windows(2));
        let distances = segments.map(|pair| {
            let course = minus(pair[1], pair[0]);
            let square = dot(course, course);
            if square == 0.0 {
                return distance(p, pair[0]);
            }
            let share = (dot(minus(p, pair[0]), course) / square).clamp(0.0, 1.0);
            distance(p, along(pair[0], share, course))
        });
        distances.fold(f64::INFINITY, f64::min)
    }

    /// Whether the face has a point.
    pub fn has(&self, p: Vector) -> bool {
        let Surface { origin, axis, .. } = self.surface;
        match self.surface.form {
            Form::Plane => {
                let [e, f] = frame(axis, 0.0);
                let flat = |q: Vector| [dot(minus(q, origin), e), dot(minus(q, origin), f)];
                self.winding(flat(p), flat) != 0
            }
            Form::Cylinder(_) => self.rolled(p, origin, axis),
            Form::Cone(_) => dot(minus(p, origin), axis) > 0.0 && self.rolled(p, origin, axis),
            Form::Sphere(_) if self.chains.is_empty() => true,
            Form::Sphere(_) => self.winding(self.projected(p), |q| self.projected(q)) != 0,
            Form::Torus(..) | Form::Other(_) => unreachable!("not drawn as one surface"),
        }
    }

    /// Crossings of the generator above the point, in angle and height.
    fn rolled(&self, p: Vector, origin: Vector, axis: Vector) -> bool {
        let [e, f] = frame(axis, 0.3);
        let flat = |q: Vector| {
            let from = minus(q, origin);
            (dot(from, f).atan2(dot(from, e)), dot(from, axis))
        };
        let (angle, height) = flat(p);
        let mut crossings = 0;
        for chain in &self.chains {
            for pair in chain.windows(2) {
                let [(a, h), (b, g)] = [flat(pair[0]), flat(pair[1])];
                // Both seen from the point's angle, the second not more than half a turn from the first.
                let first = (a - angle + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
                let second = first + (b - a + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
                for turn in [-TAU, 0.0, TAU] {
                    let (s, t) = (first + turn, second + turn);
                    if (s <= 0.0) != (t <= 0.0) {
                        let at = h + (g - h) * s / (s - t);
                        crossings += usize::from(at > height);
                    }
                }
            }
        }
        crossings % 2 == 1
    }

    /// Winding number about a point of the plane.
    fn winding(&self, p: [f64; 2], flat: impl Fn(Vector) -> [f64; 2]) -> i64 {
        let mut turned = 0.0;
        for chain in &self.chains {
            for pair in chain.windows(2) {
                let [a, b] = [flat(pair[0]), flat(pair[1])].map(|q| [q[0] - p[0], q[1] - p[1]]);
                turned += (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]);
            }
        }
        (turned / TAU).round() as i64
    }

    /// Stereographic projection of a sphere from the pole, seen from outside with its sense kept.
    fn projected(&self, p: Vector) -> [f64; 2] {
        let Form::Sphere(radius) = self.surface.form else {
            unreachable!("spheres alone are projected")
        };
        let centre = self.surface.origin;
        let up = unit(minus(self.pole, centre));
        let [e, f] = frame(up, 0.0);
        let q = times(1.0 / radius, minus(p, centre));
        let scale = 1.0 / (1.0 - dot(q, up)).max(1e-12);
        // From the pole the plane is seen from behind.
        [scale * dot(q, f), scale * dot(q, e)]
    }

    /// A point of the sphere to the right of an edge and nearer to it than to any other.
    fn outside(&self) -> Vector {
        let (Form::Sphere(radius), Some(chain)) = (&self.surface.form, self.chains.first()) else {
            return [0.0; 3];
        };
        let centre = &self.surface.origin;
        let middle = chain.len() / 2;
        let normal = unit(minus(chain[middle], *centre));
        let course = minus(chain[middle + 1], chain[middle - 1]);
        let right = unit(cross(course, normal));
        let candidate = |step: f64| {
            let off = along(chain[middle], step * radius, right);
            along(*centre, *radius, unit(minus(off, *centre)))
        };
        // As far to the right as no other edge is nearer.
        let near = |p: Vector| {
            let own = distance(p, chain[middle]);
            self.distance_to_edge(p) >= 0.9 * own && length(minus(p, chain[middle])) > 0.0
        };
        let mut candidates = [0.3, 0.1, 0.03, 0.01].map(candidate).into_iter();
        let found = candidates.find(|p| near(*p));
        found.expect("an edge has a right side")
    }
}

/// Least radius of curvature of an edge, for the sagitta of its chords.
fn smallest_radius(curve: &Curve) -> f64 {
    match curve {
        Curve::Arc(arc) => {
            let [a, b] = arc.ellipse.radii;
            a.min(b).powi(2) / a.max(b)
        }
        _ => {
            let points = curve.sampled(1);
            let bends = points.windows(3).map(|p| {
                let [a, b, c] = [p[0], p[1], p[2]];
                let area = length(cross(minus(b, a), minus(c, a)));
                // Endless for points in a line.
                distance(a, b) * distance(b, c) * distance(c, a) / (2.0 * area)
            });
            bends.fold(f64::INFINITY, f64::min)
        }
    }
}

/// Points with 15 more between any two, brought onto all surfaces of the edge.
fn on_surfaces(model: &Model, edge: usize, points: Vec<Vector>) -> Vec<Vector> {
    let mut all = vec![points[0]];
    for pair in points.windows(2) {
        for k in 1..=16 {
            let mut p = along(pair[0], f64::from(k) / 16.0, minus(pair[1], pair[0]));
            for _ in 0..100 {
                for face in &model.users[edge] {
                    p = model.faces[*face].surface.nearest(p).unwrap_or(p);
                }
            }
            all.push(p);
        }
    }
    all
}
