//! From a face to cells: what all faces need, and faces on quadrics and tori.

use super::arrangement::{AUXILIARY, EDGE, Parting};
use super::courses::Courses;
use super::cover::Term;
use super::curve::arc_through;
use super::model::COINCIDENT;
use super::parting::terms;
use super::rings::{Band, MOST, Rings};
use super::slabs;
use super::vector::*;
use super::{
    Cell, Chart, Compilation, Compiled, Curve, EdgeUse, Face, Made, Model, PlaneOf, Planes,
    Surface, Verdict,
};
use imogene_scene::MAX_CUTS;

/// Places of a curve at which it is compared with its surface.
const PLACES: usize = 64;

/// A part with all its solids compiled.
pub struct Part {
    /// The checked list.
    pub model: Model,
    /// The planes that cells refer to.
    pub planes: Planes,
    pub(super) courses: Courses,
    /// Each solid.
    pub solids: Vec<Compilation>,
}

/// A face of a part.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    pub part: &'a Part,
    pub index: usize,
}

impl<'a> Task<'a> {
    pub fn face(&self) -> &'a Face {
        &self.part.model.faces[self.index]
    }

    /// The face with its cells, or why it has none.
    pub fn compiled(&self, cells: Made<Vec<Cell>>, deviation: f64) -> Made<Compiled> {
        let (cells, deviation) = match cells {
            Ok(cells) => (cells, deviation),
            // A face as thin as the tolerance has nothing to draw.
            Err(_) if self.thickness() <= self.part.model.canonical() => (vec![], self.thickness()),
            Err(reason) => return Err(reason),
        };
        // What is off by the digits of the file alone is exact.
        let verdict = match deviation <= self.part.model.rounding() {
            true => Verdict::Exact,
            false => Verdict::Approximated(deviation),
        };
        Ok(Compiled { verdict, cells })
    }

    /// How far the border is off the straight line between the two of its places that are farthest apart.
    fn thickness(&self) -> f64 {
        let points = self.part.model.places(&self.face().border(), 16);
        let from_place = |place: Vector| farthest(&points, |p| distance(p, place));
        let Some(from) = points.first().and_then(|first| from_place(*first)) else {
            return f64::INFINITY;
        };
        let course = unit(minus(from_place(from).unwrap_or(from), from));
        off_line(&points, from, course)
    }

    /// How far the border is off: by its edges that are not planar, and where its edges leave the surface.
    pub fn deviation(&self) -> Made<f64> {
        let Part { model, courses, .. } = self.part;
        let face = self.face();
        if face.off > model.canonical() {
            return Err(format!(
                "its surface is off a {} by up to {:.3e}, more than {:.3e}",
                face.surface.name(),
                face.off,
                model.canonical()
            ));
        }
        let (mut most, accepted) = (face.off, courses.max_deviation);
        for edge_use in face.border() {
            let edge = &model.edges[edge_use.edge];
            most = most.max(courses.of(edge_use.edge)?.deviation);
            let off = face.surface.gap(&edge.curve.sampled(PLACES));
            if off <= COINCIDENT * model.size() {
                continue;
            }
            if off > accepted {
                return Err(format!(
                    "edge `{}` leaves its surface by {off:.3e}, more than {accepted:.3e}",
                    edge.name
                ));
            }
            most = most.max(off);
        }
        Ok(most)
    }

    /// The separators of a face on a quadric: the planes of its edges, and of a cone the plane between its nappes.
    pub fn parting(&self) -> Made<Parting> {
        let surface = &self.face().surface;
        let mut parting = Parting::default();
        for edge_use in self.face().border() {
            for curve in &self.part.courses.of(edge_use.edge)?.pieces {
                let plane = self.plane_of(edge_use, curve)?;
                let separator = parting.plane(&self.part.planes, plane, EDGE);
                let course = on_sphere(curve, surface).unwrap_or_else(|| curve.clone());
                parting.border(separator, course, edge_use.forward);
            }
        }
        if surface.is_cone() {
            let planes = &self.part.planes;
            let nappes = planes.find_or_add(surface.origin, surface.axis);
            parting.plane(planes, nappes, AUXILIARY);
        }
        Ok(parting)
    }

    fn plane_of(&self, edge_use: EdgeUse, curve: &Curve) -> Made<usize> {
        let surface = &self.face().surface;
        let planes = &self.part.planes;
        if let Some((point, normal)) = curve.plane() {
            return Ok(planes.find_or_add(point, normal));
        }
        let generators = &self.part.courses.generators;
        let generator = generators.get(&(self.index, edge_use.edge)).copied();
        // Else the plane across the surface, which the edge follows within the accepted deviation.
        let upright = || {
            let [from, to] = curve.ends();
            let middle = surface.nearest(times(0.5, plus(from, to)))?;
            let across = cross(minus(to, from), surface.normal_at(middle)?);
            (length(across) > 0.0).then(|| planes.find_or_add(from, unit(across)))
        };
        generator.or_else(upright).ok_or_else(|| {
            let edge = &self.part.model.edges[edge_use.edge].name;
            let kind = surface.name();
            format!("edge `{edge}` is straight and no line of a {kind}")
        })
    }
}

pub fn quadric_face(task: Task) -> Made<Compiled> {
    let surface = &task.face().surface;
    let none = || format!("a {} is no quadric", surface.name());
    let implicit = surface.implicit().ok_or_else(none)?;
    let deviation = task.deviation()?;
    let border = task.parting()?;
    let mut parting = border.clone();
    parting.split(&task.part.planes, &between_loops(task));
    let cell = |parting: &Parting, term: &Term| Cell {
        quadric: Some(implicit),
        flat: None,
        cuts: parting.cuts(term),
    };
    let cells = match terms(task, &mut parting, MAX_CUTS) {
        Ok(terms) => Ok(terms.iter().map(|term| cell(&parting, term)).collect()),
        Err(_) => slabs::cells(task, &border, &Band::whole(surface), None),
    };
    task.compiled(cells, deviation)
}

pub fn torus_face(task: Task) -> Made<Compiled> {
    let Part { model, courses, .. } = task.part;
    if courses.max_deviation == 0.0 {
        return Err("a torus is not exact, and a deviation of 0 is accepted".into());
    }
    let (surface, most) = (&task.face().surface, courses.bands);
    let rings = Rings::of(model, surface, most)
        .ok_or_else(|| format!("more than {MOST} bands would be needed to be within {most:.3e}"))?;
    let off = task.deviation()?;
    let bands = rings.bands(&Chart::of(surface, None));
    let cells = slabs::cells(task, &task.parting()?, &bands, None);
    task.compiled(cells, off.max(rings.deviation))
}

/// Planes halfway between loops with edges that are taken apart: the bounds of one have nothing to do with the other.
fn between_loops(task: Task) -> Vec<PlaneOf> {
    let model = &task.part.model;
    let spatial = |own: &EdgeUse| matches!(&model.edges[own.edge].curve, Curve::Points(line) if line.plane.is_none());
    let loops = task.face().loops.iter();
    let own = loops.filter(|own| own.iter().any(spatial));
    let middles: Vec<Vector> = own.map(|own| mean(&model.places(own, 16))).collect();
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
    let (true, Curve::Points(line)) = (surface.is_sphere(), curve) else {
        return None;
    };
    let (origin, normal) = line.plane?;
    let circle = (onto_plane(surface.origin, origin, normal), normal);
    let points = [0, 1, line.points.len() - 1].map(|k| line.points[k]);
    let radius = distance(points[0], circle.0);
    Some(arc_through(circle, radius, points, None, line.closed))
}
