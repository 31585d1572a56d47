//! From a face to cells: what all faces need.

use super::courses::Courses;
use super::model::COINCIDENT;
use super::vector::*;
use super::{Cell, Compilation, Compiled, Face, Made, Model, Planes, Verdict};

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
}
