//! From a face to cells: what all faces need.

use super::cell::{Cell, Compiled, Made, Planes, Verdict};
use super::courses::Courses;
use super::model::{COINCIDENT, Face, Model};
use super::vector::*;

/// Places of a curve at which it is compared with its surface.
const PLACES: usize = 64;

#[derive(Clone, Copy)]
pub struct Task<'a> {
    pub model: &'a Model,
    pub courses: &'a Courses,
    pub planes: &'a Planes,
    pub index: usize,
}

impl<'a> Task<'a> {
    pub fn face(&self) -> &'a Face {
        &self.model.faces[self.index]
    }

    /// The face with its cells, or why it has none.
    pub fn compiled(&self, cells: Made<Vec<Cell>>, deviation: f64) -> Made<Compiled> {
        let (cells, deviation) = match cells {
            Ok(cells) => (cells, deviation),
            // A face as thin as the tolerance has nothing to draw.
            Err(_) if self.thickness() <= self.model.canonical() => (vec![], self.thickness()),
            Err(reason) => return Err(reason),
        };
        // What is off by the digits of the file alone is exact.
        let verdict = match deviation <= self.model.rounding() {
            true => Verdict::Exact,
            false => Verdict::Approximated(deviation),
        };
        Ok(Compiled { verdict, cells })
    }

    /// How far the border is off the straight line between the two of its places that are farthest apart.
    fn thickness(&self) -> f64 {
        let points = self.model.places(&self.face().border(), 16);
        let from_place = |place: Vector| farthest(&points, |p| distance(p, place));
        let Some(from) = points.first().and_then(|first| from_place(*first)) else {
            return f64::INFINITY;
        };
        let course = unit(minus(from_place(from).unwrap_or(from), from));
        off_line(&points, from, course)
    }

    /// How far the border is off: by its edges that are not planar, and where its edges leave the surface.
    pub fn deviation(&self) -> Made<f64> {
        let (face, model) = (self.face(), self.model);
        if face.off > model.canonical() {
            return Err(format!(
                "its surface is off a {} by up to {:.3e}, more than {:.3e}",
                face.surface.name(),
                face.off,
                model.canonical()
            ));
        }
        let (mut most, accepted) = (face.off, self.courses.max_deviation);
        for edge_use in face.border() {
            let edge = &model.edges[edge_use.edge];
            most = most.max(self.courses.of(edge_use.edge)?.deviation);
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
