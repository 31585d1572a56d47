//! Faces in a plane: solids without thickness, two opposite cut planes with one more quadric at most, which are drawn
//! exactly.

use super::arrangement::{Boundary, Sample};
use super::compile::{
    CONIC, Cell, Compiled, EDGE, Parting, beside, compiled, cuts, deviation, halving,
};
use super::conics::{Conic, between};
use super::courses::Courses;
use super::cover::Term;
use super::curve::Curve;
use super::model::{EdgeUse, Model};
use super::planes::Planes;
use super::slabs::{Band, Slabs};
use super::surface::Surface;
use super::terms::{Rules, terms};
use super::vector::{Vector, along, distance, dot, minus};
use imogene_scene::MAX_CUTS;

/// Cut planes that are left beside the two of the face itself.
pub const SIDES: usize = MAX_CUTS - 2;

/// A plane that is nearer to parallel than this (cosine) to the face does not bound it; one upright on it does instead.
const TOO_FLAT: f64 = 0.99;

/// Compiles a face in a plane.
pub fn plane_face(model: &Model, index: usize, courses: &Courses, planes: &mut Planes) -> Compiled {
    let face = &model.faces[index];
    let Surface::Plane { origin, normal } = face.surface else {
        return Compiled::rejected("it is not plane");
    };
    let flat = planes.find_or_add(origin, normal);
    let (parting, conics, chords, off) = match border(model, index, courses, planes, true) {
        Ok(Border {
            parting,
            conics,
            chords,
            deviation,
            ..
        }) => (parting, conics, chords, deviation),
        Err(reason) => return Compiled::rejected(reason),
    };
    let mut searched = parting.clone();
    searched.split(planes, &chords);
    let refine = |parting: &Parting, terms: &[Term], samples: &[Sample]| {
        refined(parting, terms, samples, &conics, &face.surface)
    };
    let rules = Rules {
        fits: &fits,
        refine: &refine,
    };
    if let Ok(terms) = terms(model, &face.surface, &mut searched, planes, &rules) {
        let cells = terms.iter().map(|term| cell(&searched, term, flat));
        return compiled(model, face, Ok(cells.collect()), off);
    }
    let slabs = |parting: &Parting, planes: &mut Planes| {
        let slabs = Slabs {
            surface: &face.surface,
            parting,
            bands: &Band::whole(&face.surface),
            flat: Some(flat),
            size: model.size(),
        };
        slabs.cells(planes)
    };
    if let Ok(cells) = slabs(&parting, planes) {
        return compiled(model, face, Ok(cells), off);
    }
    // A polygon can always be taken apart.
    match border(model, index, courses, planes, false) {
        Ok(polygon) => {
            let cells = slabs(&polygon.parting, planes);
            compiled(model, face, cells, polygon.deviation)
        }
        Err(reason) => Compiled::rejected(reason),
    }
}

/// The border of a face, with conics or with chords in their place.
fn border<'a>(
    model: &'a Model,
    index: usize,
    courses: &'a Courses,
    planes: &mut Planes,
    conics: bool,
) -> Result<Border<'a>, String> {
    let face = &model.faces[index];
    let Surface::Plane { origin, normal } = face.surface else {
        return Err("it is not plane".into());
    };
    let mut border = Border {
        model,
        face: index,
        origin,
        normal,
        courses,
        with_conics: conics,
        parting: Parting::default(),
        conics: vec![],
        chords: vec![],
        deviation: deviation(model, face, courses)?,
    };
    for edge_use in face.border() {
        border.edge(edge_use, planes)?;
    }
    Ok(border)
}

fn conics_of(parting: &Parting, term: &Term) -> Vec<(usize, bool)> {
    term.literals()
        .filter(|(k, _)| parting.planes[*k].is_none())
        .collect()
}

fn cell(parting: &Parting, term: &Term, flat: usize) -> Cell {
    let quadric = conics_of(parting, term).first().map(|(k, positive)| {
        let super::chart::Separator::Quadric(implicit) = parting.separators[*k] else {
            unreachable!("what has no plane is a quadric")
        };
        if *positive {
            implicit.negated()
        } else {
            implicit
        }
    });
    Cell {
        quadric,
        flat: Some(flat),
        cuts: cuts(parting, term),
    }
}

/// One object has one conic and no more sides than there are cut planes.
fn fits(parting: &Parting, term: &Term) -> bool {
    let own = conics_of(parting, term).len();
    own <= 1 && term.len() as usize - own <= SIDES
}

/// Planes that take apart what one object cannot be: two conics in one term, more sides than there are cut planes.
fn refined(
    parting: &Parting,
    terms: &[Term],
    samples: &[Sample],
    conics: &[(usize, Conic)],
    surface: &Surface,
) -> Vec<(Vector, Vector)> {
    let mut new = vec![];
    let of = |k: usize| conics.iter().find(|(index, _)| *index == k).map(|(_, c)| c);
    for term in terms {
        let own = conics_of(parting, term);
        for (i, (one, _)) in own.iter().enumerate() {
            for (other, _) in &own[i + 1..] {
                if let (Some(a), Some(b)) = (of(*one), of(*other)) {
                    new.extend(between(a, b, surface));
                }
            }
        }
    }
    if new.is_empty() {
        new.extend(
            terms
                .iter()
                .filter(|term| !fits(parting, term))
                .map(|term| halving(term, samples, surface)),
        );
    }
    new
}

/// The border of a plane face while its edges are collected.
struct Border<'a> {
    model: &'a Model,
    face: usize,
    origin: Vector,
    normal: Vector,
    courses: &'a Courses,
    /// Curves may be conics.
    with_conics: bool,
    parting: Parting,
    conics: Vec<(usize, Conic)>,
    chords: Vec<(Vector, Vector)>,
    deviation: f64,
}

impl Border<'_> {
    fn edge(&mut self, edge_use: EdgeUse, planes: &mut Planes) -> Result<(), String> {
        let course = self.courses.of(edge_use.edge)?;
        let pieces = match &course.chords {
            Some((chords, off)) => {
                self.deviation = self.deviation.max(*off);
                chords
            }
            None => &course.pieces,
        };
        for curve in pieces {
            let separator = match curve {
                Curve::Line { from, to } => self.side(edge_use.edge, *from, *to, planes),
                _ => match curve.plane() {
                    Some((_, normal)) if dot(normal, self.normal).abs() < TOO_FLAT => {
                        let (point, normal) = curve.plane().expect("it has one");
                        let plane = planes.find_or_add(point, normal);
                        self.parting.plane(planes, plane, EDGE)
                    }
                    _ => match self.conic(edge_use.edge, curve) {
                        Some(separator) => separator,
                        None => {
                            self.chords_of(edge_use, curve, planes)?;
                            continue;
                        }
                    },
                },
            };
            self.parting.boundaries.push(Boundary {
                separator,
                curve: curve.clone(),
                forward: edge_use.forward,
            });
        }
        Ok(())
    }

    /// The separator of a straight edge: the neighbour's plane if it has one that is not too flat, or one upright on
    /// the face.
    fn side(&mut self, edge: usize, from: Vector, to: Vector, planes: &mut Planes) -> usize {
        let mut own = None;
        for other in self.model.neighbours(self.face, edge) {
            own = own.or(match self.model.faces[other].surface {
                Surface::Plane { origin, normal } => Some(planes.find_or_add(origin, normal)),
                _ => self.courses.generator(other, edge),
            });
        }
        let steep = |plane: &usize| dot(planes.get(*plane).normal, self.normal).abs() < TOO_FLAT;
        let plane = match own.filter(steep) {
            Some(plane) => plane,
            None => planes.find_or_add(from, beside(minus(to, from), self.normal)),
        };
        self.parting.plane(planes, plane, EDGE)
    }

    /// The separator of a curved edge in the plane: the neighbour's quadric, or the cylinder upright on a circle or
    /// ellipse.
    fn conic(&mut self, edge: usize, curve: &Curve) -> Option<usize> {
        if !self.with_conics {
            return None;
        }
        let neighbour = self
            .model
            .neighbours(self.face, edge)
            .find_map(|other| self.model.faces[other].surface.implicit());
        let conic = match (neighbour, curve) {
            (Some(implicit), _) => Conic::of(implicit, curve, self.origin, self.normal),
            (
                None,
                Curve::Arc {
                    centre, x, radii, ..
                },
            ) => Conic::upright(*centre, self.normal, *x, *radii),
            _ => return None,
        };
        let separator = self.parting.quadric(conic.implicit);
        if !self.conics.iter().any(|(index, _)| *index == separator) {
            self.conics.push((separator, conic));
        }
        self.parting.ranks[separator] = CONIC;
        let [from, to] = curve.ends();
        if !curve.is_closed() && distance(from, to) > 0.0 {
            self.chords
                .push((from, beside(minus(to, from), self.normal)));
        }
        Some(separator)
    }

    /// A curve in the plane that is no conic becomes a chain of chords within the accepted deviation.
    fn chords_of(
        &mut self,
        edge_use: EdgeUse,
        curve: &Curve,
        planes: &mut Planes,
    ) -> Result<(), String> {
        let points = curve.sampled(64);
        let (chain, off) = chain(&points, self.courses.max_deviation);
        let edge = &self.model.edges[edge_use.edge];
        if chain.len() > super::courses::MAX_PIECES || off > self.courses.max_deviation {
            return Err(format!(
                "edge `{}` is no conic and is not within {:.3e} of {} chords",
                edge.name,
                self.courses.max_deviation,
                super::courses::MAX_PIECES
            ));
        }
        self.deviation = self.deviation.max(off);
        for pair in chain.windows(2) {
            let plane = planes.find_or_add(pair[0], beside(minus(pair[1], pair[0]), self.normal));
            let separator = self.parting.plane(planes, plane, EDGE);
            self.parting.boundaries.push(Boundary {
                separator,
                curve: Curve::Line {
                    from: pair[0],
                    to: pair[1],
                },
                forward: edge_use.forward,
            });
        }
        Ok(())
    }
}

/// Corners of a chain that follows points within a length, and how far it is off them.
fn chain(points: &[Vector], max_deviation: f64) -> (Vec<Vector>, f64) {
    let mut corners = vec![points[0]];
    let (mut start, mut most) = (0, 0.0_f64);
    while start + 1 < points.len() {
        let off = |end: usize| {
            points[start..=end]
                .iter()
                .map(|p| from_chord(*p, points[start], points[end]))
                .fold(0.0, f64::max)
        };
        let mut end = start + 1;
        while end + 1 < points.len() && off(end + 1) <= max_deviation {
            end += 1;
        }
        most = most.max(off(end));
        corners.push(points[end]);
        start = end;
    }
    (corners, most)
}

fn from_chord(p: Vector, from: Vector, to: Vector) -> f64 {
    let course = minus(to, from);
    let square = dot(course, course);
    if square == 0.0 {
        return distance(p, from);
    }
    let share = (dot(minus(p, from), course) / square).clamp(0.0, 1.0);
    distance(p, along(from, share, course))
}
