//! What edges become: one planar piece each, or several for an edge that is in no plane.

use super::curve::common_plane;
use super::rings::chords;
use super::vector::*;
use super::{Curve, Form, Model, Planes, Polyline, Surface};
use std::collections::HashMap;

/// Most pieces of an edge.
pub const MAX_PIECES: usize = 400;
/// Difference of two normals, or of one and the opposite of the other, below which their surfaces touch.
const NEARLY_TANGENT: f64 = 0.5;
/// Steps by which the points of an edge are refined before it is measured.
const REFINED: usize = 4;
/// What is added to a measured deviation for what lies between the measured places.
const MARGIN: f64 = 1.05;

/// An edge as all its faces see it.
#[derive(Clone, Debug, Default)]
pub struct Course {
    /// Straight or planar curves, one after the other.
    pub pieces: Vec<Curve>,
    /// Chords of an edge about a torus, which a plane face has instead, and how far off they are, scene units.
    pub chords: Option<(Vec<Curve>, f64)>,
    /// Greatest distance of the edge from where planes of its pieces meet its surfaces, scene units; 0 if planar.
    pub deviation: f64,
}

/// The courses of all edges, and the planes of straight ones on curved faces.
#[derive(Debug)]
pub struct Courses {
    courses: Vec<Result<Course, String>>,
    /// The planes of straight edges of cylinders and cones.
    pub generators: Generators,
    /// Largest deviation that is accepted, scene units.
    pub max_deviation: f64,
    /// Largest deviation of the bands of a torus, scene units.
    pub bands: f64,
}

impl Courses {
    /// The courses of the edges of a model, with deviations of at most these, in scene units.
    pub fn new(model: &Model, planes: &Planes, max_deviation: f64, bands: f64) -> Courses {
        let course = |edge| course(model, edge, max_deviation, bands);
        let mut generators = Generators::new();
        for face in 0..model.faces.len() {
            pair_generators(model, face, planes, &mut generators);
        }
        Courses {
            courses: (0..model.edges.len()).map(course).collect(),
            generators,
            max_deviation,
            bands,
        }
    }

    /// The course of an edge, or why it has none.
    pub fn of(&self, edge: usize) -> Result<&Course, String> {
        self.courses[edge].as_ref().map_err(Clone::clone)
    }
}

fn course(model: &Model, index: usize, max_deviation: f64, bands: f64) -> Result<Course, String> {
    let edge = &model.edges[index];
    let Curve::Points(line @ Polyline { plane: None, .. }) = &edge.curve else {
        return Ok(Course {
            pieces: vec![edge.curve.clone()],
            chords: chords(model, index, bands),
            deviation: edge.off,
        });
    };
    let surfaces = model.users[index].iter();
    let surfaces = surfaces.map(|face| &model.faces[*face].surface);
    let known = surfaces.filter(|own| !matches!(own.form, Form::Other(_)));
    let surfaces: Vec<&Surface> = known.collect();
    let mut refined = refine(line, &surfaces);
    if line.closed {
        refined.push(refined[0]);
    }
    pieces(&refined, &surfaces, max_deviation).ok_or_else(|| {
        format!(
            "edge `{}` is in no plane and is not within {max_deviation:.3e} of {MAX_PIECES} planar pieces",
            edge.name
        )
    })
}

/// The points with places between them, brought onto the surfaces.
pub fn refine(line: &Polyline, surfaces: &[&Surface]) -> Vec<Vector> {
    let mut all = line.refined(REFINED);
    for (k, p) in all.iter_mut().enumerate() {
        if k % REFINED > 0 {
            *p = onto_all(*p, surfaces);
        }
    }
    all
}

/// A point on all surfaces near `p`, by alternate projection.
fn onto_all(mut p: Vector, surfaces: &[&Surface]) -> Vector {
    for _ in 0..100 {
        let before = p;
        for surface in surfaces {
            p = surface.nearest(p).unwrap_or(p);
        }
        if distance(before, p) == 0.0 {
            break;
        }
    }
    p
}

/// The fewest pieces that a search from the start finds, each as long as the deviation lets it be.
pub fn pieces(points: &[Vector], surfaces: &[&Surface], max_deviation: f64) -> Option<Course> {
    let mut course = Course::default();
    let last = points.len() - 1;
    let mut start = 0;
    while start < last {
        if course.pieces.len() == MAX_PIECES {
            return None;
        }
        let fit = |end: usize| {
            piece(&points[start..=end], surfaces).filter(|(_, off)| MARGIN * off <= max_deviation)
        };
        // The longest run, looked for between one that fits and one that does not.
        let mut best = fit(start + 1).map(|found| (start + 1, found))?;
        let mut too_long = last + 1;
        let mut reach = 2;
        while best.0 + 1 < too_long {
            let (far, middle) = (start + reach, usize::midpoint(best.0, too_long));
            let end = if far < too_long { far } else { middle };
            reach *= 2;
            match fit(end) {
                Some(found) => best = (end, found),
                None => too_long = end,
            }
        }
        let (end, (curve, off)) = best;
        course.deviation = course.deviation.max(MARGIN * off);
        course.pieces.push(curve);
        start = end;
    }
    Some(course)
}

/// One planar piece through the ends of a run, and its deviation.
fn piece(run: &[Vector], surfaces: &[&Surface]) -> Option<(Curve, f64)> {
    let (first, last) = (run[0], run[run.len() - 1]);
    let normals = if distance(first, last) > 0.0 {
        through_chord(run, surfaces)
    } else {
        vec![common_plane(run, f64::INFINITY)?.1]
    };
    let off = |normal: &Vector| {
        let mut most: f64 = 0.0;
        for q in run {
            for surface in surfaces {
                most = most.max(distance(*q, trace(*q, surface, first, *normal)?));
            }
        }
        Some((most, *normal))
    };
    let best = normals.iter().filter_map(off);
    let (most, normal) = best.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let steps = run.windows(2).map(|pair| distance(pair[0], pair[1]));
    let closed = distance(first, last) == 0.0;
    let mut points = run.to_vec();
    if closed {
        points.pop();
    }
    let line = Polyline {
        points,
        closed,
        plane: Some((first, normal)),
        slack: steps.fold(4.0 * most, f64::max),
    };
    Some((Curve::Points(line), most))
}

/// Normals of planes through the ends of a run: halfway between those of the surfaces, so that it meets both steeply.
///
/// The plane of the least deviation would be the osculating one; but that is often nearly tangent to one of the
/// surfaces, follows the edge far beyond its piece, and leaves slivers between the continued pieces.
fn through_chord(run: &[Vector], surfaces: &[&Surface]) -> Vec<Vector> {
    let (first, last) = (run[0], run[run.len() - 1]);
    let chord = unit(minus(last, first));
    let middle = run[run.len() / 2];
    let normals = surfaces.iter().filter_map(|own| own.normal_at(middle));
    let normals: Vec<Vector> = normals.map(|normal| unit(across(normal, chord))).collect();
    match normals[..] {
        [] => vec![],
        [one] => vec![unit(cross(chord, one))],
        [one, other, ..] => {
            let sum = plus(one, other);
            // Where the surfaces touch, the plane is upright on both.
            let tangent = length(minus(one, other)).min(length(sum)) < NEARLY_TANGENT;
            let upright = if tangent { cross(chord, one) } else { [0.0; 3] };
            let all = [sum, minus(one, other), upright].into_iter();
            all.filter(|n| length(*n) > 1e-3).map(unit).collect()
        }
    }
}

/// The point in which the plane meets the surface, straight down the surface from `q`; `None` if there is none nearby.
pub fn trace(q: Vector, surface: &Surface, origin: Vector, normal: Vector) -> Option<Vector> {
    let mut p = q;
    for _ in 0..60 {
        let off = dot(minus(p, origin), normal);
        let slope = across(normal, surface.normal_at(p)?);
        let square = dot(slope, slope);
        if square < 1e-6 {
            return None;
        }
        let next = surface.nearest(along(p, -off / square, slope))?;
        if distance(next, p) <= 1e-15 * (1.0 + length(p)) {
            return Some(next);
        }
        p = next;
    }
    (dot(minus(p, origin), normal).abs() <= 1e-9 * (1.0 + length(p))).then_some(p)
}

/// The plane of each generator, by face and edge.
pub type Generators = HashMap<(usize, usize), usize>;

/// A generator of a face.
struct Line {
    edge: usize,
    /// From the axis to the line, length 1, across the axis.
    out: Vector,
    point: Vector,
    direction: Vector,
}

/// Pairs the generators of a face in the order of their angles; an odd one is paired with the first.
pub fn pair_generators(model: &Model, face: usize, planes: &Planes, found: &mut Generators) {
    let Surface { axis, form, .. } = &model.faces[face].surface;
    if !matches!(form, Form::Cylinder(_) | Form::Cone(_)) {
        return;
    }
    let mut lines = lines(model, face);
    let first = lines.first().map_or([0.0; 3], |line| line.out);
    let side = cross(axis, first);
    let angle =
        |line: &Line| positive_angle(dot(line.out, side).atan2(dot(line.out, first)) + 1e-9);
    lines.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    // Lines that are one and the same generator.
    let distinct = lines.chunk_by(|a, b| angle(b) - angle(a) <= 1e-8);
    let distinct: Vec<&[Line]> = distinct.collect();
    for pair in distinct.chunks(2) {
        let [a, b] = [pair[0], pair.get(1).unwrap_or(&distinct[0])].map(|group| &group[0]);
        let normal = match form {
            // Alone: the plane through the axis.
            _ if distinct.len() == 1 => cross(axis, a.out),
            Form::Cone(_) => cross(a.direction, b.direction),
            _ => cross(axis, minus(b.point, a.point)),
        };
        // A straight edge on the axis is no generator, and has no plane.
        if length(normal) > 0.0 {
            let plane = planes.find_or_add(a.point, unit(normal));
            let edges = pair.iter().copied().flatten().map(|line| line.edge);
            found.extend(edges.map(|edge| ((face, edge), plane)));
        }
    }
}

fn lines(model: &Model, face: usize) -> Vec<Line> {
    let Surface { origin, axis, .. } = model.faces[face].surface;
    let mut lines = vec![];
    for edge_use in model.faces[face].border() {
        let edge = &model.edges[edge_use.edge];
        if !matches!(edge.curve, Curve::Line { .. }) {
            continue;
        }
        let [from, to] = edge.curve.ends();
        let outs = [from, to].map(|p| across(minus(p, origin), axis));
        let far = usize::from(length(outs[0]) < length(outs[1]));
        lines.push(Line {
            edge: edge_use.edge,
            out: unit(outs[far]),
            point: [from, to][far],
            direction: unit(minus(to, from)),
        });
    }
    lines
}
