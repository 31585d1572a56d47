//! Faces in a plane: two opposite cut planes with one more quadric at most, which are drawn exactly.

use super::arrangement::{Conic, EDGE, Parting};
use super::courses::MAX_PIECES;
use super::cover::Term;
use super::parting::terms;
use super::rings::Band;
use super::slabs;
use super::task::Task;
use super::vector::{Vector, along, cross, distance, dot, minus, unit};
use super::{Cell, Compiled, Curve, EdgeUse, Made, PlaneOf, Separator};
use imogene_scene::MAX_CUTS;

/// Cut planes that are left beside the two of the face itself.
const SIDES: usize = MAX_CUTS - 2;

/// A plane that is nearer to parallel than this (cosine) to the face does not bound it; one upright on it does instead.
const TOO_FLAT: f64 = 0.99;

pub fn plane_face(task: Task) -> Made<Compiled> {
    let surface = &task.face().surface;
    let flat = task.part.planes.find_or_add(surface.origin, surface.axis);
    let border = border(task, true)?;
    let mut searched = border.parting.clone();
    searched.split(&task.part.planes, &border.chords);
    if let Ok(terms) = terms(task, &mut searched, SIDES) {
        let cells = terms.iter().map(|term| cell(&searched, term, flat));
        return task.compiled(Ok(cells.collect()), border.deviation);
    }
    let bands = Band::whole(surface);
    if let Ok(cells) = slabs::cells(task, &border.parting, &bands, Some(flat)) {
        return task.compiled(Ok(cells), border.deviation);
    }
    // A polygon can always be taken apart.
    let polygon = self::border(task, false)?;
    let cells = slabs::cells(task, &polygon.parting, &bands, Some(flat));
    task.compiled(cells, polygon.deviation)
}

/// The border of a face, with conics or with chords in their place.
fn border<'a>(task: Task<'a>, conics: bool) -> Made<Border<'a>> {
    let mut border = Border {
        task,
        with_conics: conics,
        parting: Parting::default(),
        chords: vec![],
        deviation: task.deviation()?,
    };
    for edge_use in task.face().border() {
        border.edge(edge_use)?;
    }
    Ok(border)
}

fn cell(parting: &Parting, term: &Term, flat: usize) -> Cell {
    let kept = |(k, positive): &(usize, bool)| match parting.separators[*k] {
        Separator::Quadric(implicit) => Some(implicit.kept(*positive)),
        Separator::Plane(_) => None,
    };
    Cell {
        quadric: parting.conics(term).first().and_then(kept),
        flat: Some(flat),
        cuts: parting.cuts(term),
    }
}

/// The border of a plane face while its edges are collected.
struct Border<'a> {
    task: Task<'a>,
    with_conics: bool,
    parting: Parting,
    chords: Vec<PlaneOf>,
    deviation: f64,
}

impl Border<'_> {
    fn normal(&self) -> Vector {
        self.task.face().surface.axis
    }

    fn is_steep(&self, normal: Vector) -> bool {
        dot(normal, self.normal()).abs() < TOO_FLAT
    }

    fn upright(&self, from: Vector, to: Vector) -> PlaneOf {
        (from, unit(cross(minus(to, from), self.normal())))
    }

    /// The separator of a plane that has an edge.
    fn wall(&mut self, (point, normal): PlaneOf) -> usize {
        let planes = &self.task.part.planes;
        self.parting
            .plane(planes, planes.find_or_add(point, normal), EDGE)
    }

    fn edge(&mut self, edge_use: EdgeUse) -> Made<()> {
        let course = self.task.part.courses.of(edge_use.edge)?;
        let pieces = match &course.chords {
            Some((chords, off)) => {
                self.deviation = self.deviation.max(*off);
                chords
            }
            None => &course.pieces,
        };
        for curve in pieces {
            let plane = curve.plane().filter(|(_, normal)| self.is_steep(*normal));
            let separator = match (curve, plane) {
                (Curve::Line { from, to }, _) => Some(self.side(edge_use.edge, *from, *to)),
                (_, Some(plane)) => Some(self.wall(plane)),
                _ => self.conic(edge_use.edge, curve),
            };
            match separator {
                Some(wall) => self.parting.border(wall, curve.clone(), edge_use.forward),
                None => self.chords_of(edge_use, curve)?,
            }
        }
        Ok(())
    }

    /// The separator of a straight edge: the neighbour's plane if that is steep, or one upright on the face.
    fn side(&mut self, edge: usize, from: Vector, to: Vector) -> usize {
        let part = self.task.part;
        let mut neighbours = part.model.neighbours(self.task.index, edge);
        let own = neighbours.find_map(|other| match part.model.faces[other].surface.plane() {
            Some((origin, normal)) => Some(part.planes.find_or_add(origin, normal)),
            None => part.courses.generators.get(&(other, edge)).copied(),
        });
        match own.filter(|plane| self.is_steep(part.planes.get(*plane).1)) {
            Some(plane) => self.parting.plane(&part.planes, plane, EDGE),
            None => self.wall(self.upright(from, to)),
        }
    }

    /// The separator of a curved edge: the neighbour's quadric, or the cylinder upright on a circle or ellipse.
    fn conic(&mut self, edge: usize, curve: &Curve) -> Option<usize> {
        if !self.with_conics {
            return None;
        }
        let model = &self.task.part.model;
        let mut neighbours = model.neighbours(self.task.index, edge);
        let neighbour = neighbours.find_map(|other| model.faces[other].surface.implicit());
        let surface = &self.task.face().surface;
        let conic = match (neighbour, curve) {
            (Some(implicit), _) => Conic::of(implicit, curve, surface.origin, surface.axis),
            (None, Curve::Arc(arc)) => Conic::upright(&arc.ellipse, surface.axis),
            _ => return None,
        };
        let separator = self.parting.quadric(conic.implicit);
        self.parting.shapes.entry(separator).or_insert(conic);
        let [from, to] = curve.ends();
        if !curve.is_closed() && distance(from, to) > 0.0 {
            self.chords.push(self.upright(from, to));
        }
        Some(separator)
    }

    /// A curve in the plane that is no conic becomes a chain of chords within the accepted deviation.
    fn chords_of(&mut self, edge_use: EdgeUse, curve: &Curve) -> Made<()> {
        let most = self.task.part.courses.max_deviation;
        let (chain, off) = chain(&curve.sampled(64), most);
        if chain.len() > MAX_PIECES || off > most {
            let edge = &self.task.part.model.edges[edge_use.edge].name;
            return Err(format!(
                "edge `{edge}` is no conic and is not within {most:.3e} of {MAX_PIECES} chords"
            ));
        }
        self.deviation = self.deviation.max(off);
        for pair in chain.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let separator = self.wall(self.upright(from, to));
            self.parting
                .border(separator, Curve::Line { from, to }, edge_use.forward);
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
            let own = points[start..=end].iter();
            own.map(|p| from_chord(*p, points[start], points[end]))
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
