//! From a face to cells: parts of one quadric, or of one plane, each bounded by the AND of cut planes.

use super::arrangement::{Boundary, MAX_SEPARATORS, Sample};
use super::chart::Separator;
use super::courses::Courses;
use super::cover::Term;
use super::curve::Curve;
use super::gap::gap;
use super::model::{COINCIDENT, Face, Model};
use super::planes::Planes;
use super::slabs::{Band, Slabs};
use super::surface::{Implicit, Surface};
use super::terms::{Rules, terms};
use super::vector::{
    Vector, across, along, cross, distance, dot, length, minus, onto_plane, plus, positive_angle,
    times, unit,
};
use imogene_scene::MAX_CUTS;
use std::f64::consts::{PI, TAU};

/// What became of a face.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The cells are the face, up to the rounding of numbers to double precision.
    Exact,
    /// The border is off by at most this much, scene units.
    Approximated(f64),
    /// It is not drawn, for this reason.
    Rejected(String),
}

/// A part of a face that is one object of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// The quadric; of a cell of a plane, what bounds it besides planes, kept where it is negative.
    pub quadric: Option<Implicit>,
    /// The plane of a cell that is flat.
    pub flat: Option<usize>,
    /// Planes by their index, and whether the side of their normal is kept.
    pub cuts: Vec<(usize, bool)>,
}

impl Cell {
    /// Whether a point of its surface is in it.
    pub fn takes(&self, p: Vector, planes: &Planes) -> bool {
        let bounded = self.flat.is_none() || self.quadric.is_none_or(|q| q.value(p) <= 0.0);
        let keeps = |(plane, positive): &(usize, bool)| planes.is_positive(*plane, p) == *positive;
        bounded && self.cuts.iter().all(keeps)
    }
}

/// A compiled face.
#[derive(Clone, Debug, PartialEq)]
pub struct Compiled {
    /// What became of it.
    pub verdict: Verdict,
    /// Its parts; none if it is rejected or its solid is one volume.
    pub cells: Vec<Cell>,
}

impl Compiled {
    /// A face that is not drawn.
    pub fn rejected(reason: impl Into<String>) -> Compiled {
        Compiled {
            verdict: Verdict::Rejected(reason.into()),
            cells: vec![],
        }
    }
}

/// How a face is divided: separators with what they are in the scene.
#[derive(Clone, Debug, Default)]
pub struct Parting {
    /// What divides.
    pub separators: Vec<Separator>,
    /// For each: the plane, or nothing for a quadric.
    pub planes: Vec<Option<usize>>,
    /// For each: separators of the lower rank are dropped first.
    pub ranks: Vec<u8>,
    /// The edges.
    pub boundaries: Vec<Boundary>,
}

/// Rank of a quadric that bounds a plane, of which a cell can have one alone.
pub const CONIC: u8 = 0;
/// Rank of a plane that is no edge.
pub const AUXILIARY: u8 = 1;
/// Rank of a plane that has an edge.
pub const EDGE: u8 = 2;

impl Parting {
    /// Index of the separator of a plane.
    pub fn plane(&mut self, planes: &Planes, plane: usize, rank: u8) -> usize {
        match self.planes.iter().position(|p| *p == Some(plane)) {
            Some(index) => {
                self.ranks[index] = self.ranks[index].max(rank);
                index
            }
            None => {
                self.separators.push(planes.separator(plane));
                self.planes.push(Some(plane));
                self.ranks.push(rank);
                self.separators.len() - 1
            }
        }
    }

    /// Index of the separator of a quadric.
    pub fn quadric(&mut self, implicit: Implicit) -> usize {
        let separator = Separator::Quadric(implicit);
        match self.separators.iter().position(|s| *s == separator) {
            Some(index) => index,
            None => {
                self.separators.push(separator);
                self.planes.push(None);
                self.ranks.push(CONIC);
                self.separators.len() - 1
            }
        }
    }

    /// Adds planes that divide and are no edges; false if all are there already, or too many.
    pub fn split(&mut self, planes: &mut Planes, new: &[(Vector, Vector)]) -> bool {
        let before = self.separators.len();
        for (point, normal) in new {
            let index = planes.find_or_add(*point, *normal);
            self.plane(planes, index, AUXILIARY);
        }
        self.separators.len() > before && self.separators.len() <= MAX_SEPARATORS
    }
}

/// A plane through the middle of a term's pieces across their greatest extent.
pub fn halving(term: &Term, samples: &[Sample], surface: &Surface) -> (Vector, Vector) {
    let own: Vec<Vector> = samples
        .iter()
        .filter(|s| term.takes(s.sides))
        .map(|s| s.point)
        .collect();
    let share = 1.0 / own.len().max(1) as f64;
    let middle = own.iter().fold([0.0; 3], |sum, p| along(sum, share, *p));
    let farthest = own
        .iter()
        .map(|p| minus(*p, middle))
        .max_by(|p, q| dot(*p, *p).total_cmp(&dot(*q, *q)))
        .unwrap_or([1.0, 0.0, 0.0]);
    let direction = match surface {
        Surface::Plane { normal, .. } => along(farthest, -dot(farthest, *normal), *normal),
        _ => farthest,
    };
    (middle, unit(direction))
}

/// Compiles a face that lies on a quadric.
pub fn quadric_face(
    model: &Model,
    index: usize,
    courses: &Courses,
    planes: &mut Planes,
) -> Compiled {
    let face = &model.faces[index];
    let Some(implicit) = face.surface.implicit() else {
        return Compiled::rejected(format!("a {} is no quadric", face.surface.name()));
    };
    let deviation = match deviation(model, face, courses) {
        Ok(deviation) => deviation,
        Err(reason) => return Compiled::rejected(reason),
    };
    let mut parting = match parting(model, index, courses, planes) {
        Ok(parting) => parting,
        Err(reason) => return Compiled::rejected(reason),
    };
    let border = parting.clone();
    let apart = between_loops(model, face);
    parting.split(planes, &apart);
    let fits = |_: &Parting, term: &Term| term.len() as usize <= MAX_CUTS;
    let refine = |parting: &Parting, terms: &[Term], samples: &[Sample]| {
        terms
            .iter()
            .filter(|term| !fits(parting, term))
            .map(|term| halving(term, samples, &face.surface))
            .collect()
    };
    let rules = Rules {
        fits: &fits,
        refine: &refine,
    };
    let cells = match terms(model, &face.surface, &mut parting, planes, &rules) {
        Ok(terms) => Ok(terms
            .iter()
            .map(|term| Cell {
                quadric: Some(implicit),
                flat: None,
                cuts: cuts(&parting, term),
            })
            .collect()),
        Err(_) => Slabs {
            surface: &face.surface,
            parting: &border,
            bands: &Band::whole(&face.surface),
            flat: None,
            size: model.size(),
        }
        .cells(planes),
    };
    compiled(model, face, cells, deviation)
}

/// A face with its cells, or why it has none.
pub fn compiled(
    model: &Model,
    face: &Face,
    cells: Result<Vec<Cell>, String>,
    deviation: f64,
) -> Compiled {
    match cells {
        Err(_) if thickness(model, face) <= model.canonical() => Compiled {
            verdict: verdict(model, thickness(model, face)),
            cells: vec![],
        },
        Err(reason) => Compiled::rejected(reason),
        Ok(cells) => Compiled {
            verdict: verdict(model, deviation),
            cells,
        },
    }
}

/// How far the border of a face is off the straight line between the two of its places that are farthest apart: a face
/// as thin as the tolerance has nothing to draw.
fn thickness(model: &Model, face: &Face) -> f64 {
    let border = face.border();
    let points: Vec<Vector> = border
        .iter()
        .flat_map(|u| model.edges[u.edge].curve.sampled(16))
        .collect();
    let farthest = |from: Vector| {
        let all = points.iter().copied();
        all.max_by(|p, q| distance(*p, from).total_cmp(&distance(*q, from)))
    };
    let Some((from, to)) = points.first().and_then(|p| {
        let from = farthest(*p)?;
        Some((from, farthest(from)?))
    }) else {
        return f64::INFINITY;
    };
    let course = unit(minus(to, from));
    let off = |p: &Vector| length(across(minus(*p, from), course));
    points.iter().map(off).fold(0.0, f64::max)
}

/// What a deviation makes of a face: what is off by the digits of the file alone is exact.
pub fn verdict(model: &Model, deviation: f64) -> Verdict {
    if deviation > model.rounding() {
        Verdict::Approximated(deviation)
    } else {
        Verdict::Exact
    }
}

/// The planes of a term.
pub fn cuts(parting: &Parting, term: &Term) -> Vec<(usize, bool)> {
    term.literals()
        .filter_map(|(k, positive)| parting.planes[k].map(|plane| (plane, positive)))
        .collect()
}

/// How far the border of a face is off: by its edges that are not planar, and where its edges leave the surface.
pub fn deviation(model: &Model, face: &Face, courses: &Courses) -> Result<f64, String> {
    let mut most = face.off;
    if face.off > model.canonical() {
        return Err(format!(
            "its surface is off a {} by up to {:.3e}, more than {:.3e}",
            face.surface.name(),
            face.off,
            model.canonical()
        ));
    }
    for edge_use in face.border() {
        let edge = &model.edges[edge_use.edge];
        let course = courses.of(edge_use.edge)?;
        most = most.max(course.deviation);
        let off = gap(&edge.curve, &face.surface);
        if off > COINCIDENT * model.size() {
            if off > courses.max_deviation {
                return Err(format!(
                    "edge `{}` leaves its surface by {off:.3e}, more than {:.3e}",
                    edge.name, courses.max_deviation
                ));
            }
            most = most.max(off);
        }
    }
    Ok(most)
}

/// The separators of a face on a quadric: the planes of its edges, and of a cone the plane between its nappes.
pub fn parting(
    model: &Model,
    index: usize,
    courses: &Courses,
    planes: &mut Planes,
) -> Result<Parting, String> {
    let face = &model.faces[index];
    let mut parting = Parting::default();
    for edge_use in face.border() {
        let course = courses.of(edge_use.edge)?;
        for curve in &course.pieces {
            let plane = match curve.plane() {
                Some((point, normal)) => planes.find_or_add(point, normal),
                None => match courses.generator(index, edge_use.edge) {
                    Some(plane) => plane,
                    None => upright(curve, &face.surface, planes).ok_or_else(|| {
                        format!(
                            "edge `{}` is straight and no line of a {}",
                            model.edges[edge_use.edge].name,
                            face.surface.name()
                        )
                    })?,
                },
            };
            let separator = parting.plane(planes, plane, EDGE);
            parting.boundaries.push(Boundary {
                separator,
                curve: on_sphere(curve, &face.surface).unwrap_or_else(|| curve.clone()),
                forward: edge_use.forward,
            });
        }
    }
    if let Surface::Cone { apex, axis, .. } = face.surface {
        let nappes = planes.find_or_add(apex, axis);
        parting.plane(planes, nappes, AUXILIARY);
    }
    Ok(parting)
}

/// The plane through a straight edge across its surface, which it follows within the accepted deviation.
fn upright(curve: &Curve, surface: &Surface, planes: &mut Planes) -> Option<usize> {
    let [from, to] = curve.ends();
    let middle = surface.nearest(times(0.5, plus(from, to)))?;
    let across = cross(minus(to, from), surface.normal_at(middle)?);
    (length(across) > 0.0).then(|| planes.find_or_add(from, unit(across)))
}

/// Planes halfway between loops with edges that are taken apart: what bounds one has nothing to do with what bounds
/// the other.
fn between_loops(model: &Model, face: &Face) -> Vec<(Vector, Vector)> {
    let spatial = |edge: usize| {
        let curve = &model.edges[edge].curve;
        matches!(curve, Curve::Points { plane: None, .. })
    };
    let middles: Vec<Vector> = face
        .loops
        .iter()
        .filter(|own| own.iter().any(|u| spatial(u.edge)))
        .map(|own| {
            let points: Vec<Vector> = own
                .iter()
                .flat_map(|u| model.edges[u.edge].curve.sampled(16))
                .collect();
            let share = 1.0 / points.len() as f64;
            points.iter().fold([0.0; 3], |sum, p| along(sum, share, *p))
        })
        .collect();
    let mut planes = vec![];
    for (index, p) in middles.iter().enumerate().take(8) {
        for q in middles[index + 1..].iter().take(8) {
            let apart = minus(*q, *p);
            if length(apart) > COINCIDENT * model.size() {
                planes.push((times(0.5, plus(*p, *q)), unit(apart)));
            }
        }
    }
    planes
}

/// The arc in which the plane of a curve given by points meets a sphere, from its first point to its last.
fn on_sphere(curve: &Curve, surface: &Surface) -> Option<Curve> {
    let (Surface::Sphere { centre, .. }, Curve::Points { points, closed, .. }) = (surface, curve)
    else {
        return None;
    };
    let (origin, normal) = curve.plane()?;
    let centre = onto_plane(*centre, origin, normal);
    let first = minus(points[0], centre);
    let (radius, x) = (length(first), unit(first));
    let angle = |p: Vector, normal: Vector| {
        let from = minus(p, centre);
        positive_angle(dot(from, cross(normal, x)).atan2(dot(from, x)))
    };
    // Counter-clockwise about the normal with which the points come in their order.
    let normal = if angle(points[1], normal) < PI {
        normal
    } else {
        times(-1.0, normal)
    };
    let sweep = if *closed {
        TAU
    } else {
        angle(points[points.len() - 1], normal)
    };
    Some(Curve::Arc {
        centre,
        normal,
        x,
        radii: [radius; 2],
        start: 0.0,
        sweep,
    })
}

/// The unit vector across a line within a plane.
pub fn beside(direction: Vector, normal: Vector) -> Vector {
    unit(cross(direction, normal))
}
