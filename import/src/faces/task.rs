//! What all faces need on the way to cells.

use super::arrangement::{AUXILIARY, EDGE, Parting};
use super::courses::Courses;
use super::curve::arc_through;
use super::model::COINCIDENT;
use super::vector::*;
use super::{
    Cell, Compilation, Compiled, Curve, EdgeUse, Face, Made, Model, Planes, Surface, Verdict,
};

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
