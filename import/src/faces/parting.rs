//! How a face is divided: separators with what they are in the scene.

use super::arrangement::{Boundary, MAX_SEPARATORS, Sample};
use super::cover::Term;
use super::curve::PlaneOf;
use super::planes::{Planes, Separator};
use super::surface::{Implicit, Surface};
use super::vector::{Vector, along, dot, mean, minus, unit};

/// What divides a face.
#[derive(Clone, Debug, Default)]
pub struct Parting {
    pub separators: Vec<Separator>,
    /// For each: the plane, or nothing for a quadric.
    pub planes: Vec<Option<usize>>,
    /// For each: separators of the lower rank are dropped first.
    pub ranks: Vec<u8>,
    pub boundaries: Vec<Boundary>,
}

/// Rank of a quadric that bounds a plane, of which a cell can have one alone.
const CONIC: u8 = 0;
/// Rank of a plane that is no edge.
pub const AUXILIARY: u8 = 1;
/// Rank of a plane that has an edge.
pub const EDGE: u8 = 2;

impl Parting {
    fn push(&mut self, separator: Separator, plane: Option<usize>, rank: u8) -> usize {
        self.separators.push(separator);
        self.planes.push(plane);
        self.ranks.push(rank);
        self.separators.len() - 1
    }

    /// Index of the separator of a plane.
    pub fn plane(&mut self, planes: &Planes, plane: usize, rank: u8) -> usize {
        let Some(index) = self.planes.iter().position(|p| *p == Some(plane)) else {
            return self.push(planes.separator(plane), Some(plane), rank);
        };
        self.ranks[index] = self.ranks[index].max(rank);
        index
    }

    /// Index of the separator of a quadric.
    pub fn quadric(&mut self, implicit: Implicit) -> usize {
        let separator = Separator::Quadric(implicit);
        let known = self.separators.iter().position(|s| *s == separator);
        known.unwrap_or_else(|| self.push(separator, None, CONIC))
    }

    /// Adds a piece of the border.
    pub fn border(&mut self, separator: usize, curve: super::curve::Curve, forward: bool) {
        self.boundaries.push(Boundary {
            separator,
            curve,
            forward,
        });
    }

    /// Adds planes that divide and are no edges; false if all are there already, or too many.
    pub fn split(&mut self, planes: &mut Planes, new: &[PlaneOf]) -> bool {
        let before = self.separators.len();
        for (point, normal) in new {
            let index = planes.find_or_add(*point, *normal);
            self.plane(planes, index, AUXILIARY);
        }
        self.separators.len() > before && self.separators.len() <= MAX_SEPARATORS
    }

    /// The planes of a term.
    pub fn cuts(&self, term: &Term) -> Vec<(usize, bool)> {
        let cut = |(k, positive): (usize, bool)| self.planes[k].map(|plane| (plane, positive));
        term.literals().filter_map(cut).collect()
    }

    /// The quadrics of a term.
    pub fn conics(&self, term: &Term) -> Vec<(usize, bool)> {
        let literals = term.literals();
        literals
            .filter(|(k, _)| self.planes[*k].is_none())
            .collect()
    }
}

/// A plane through the middle of a term's pieces across their greatest extent.
pub fn halving(term: &Term, samples: &[Sample], surface: &Surface) -> PlaneOf {
    let own = samples.iter().filter(|s| term.takes(s.sides));
    let own: Vec<Vector> = own.map(|s| s.point).collect();
    let middle = mean(&own);
    let apart = own.iter().map(|p| minus(*p, middle));
    let farthest = apart.max_by(|p, q| dot(*p, *p).total_cmp(&dot(*q, *q)));
    let farthest = farthest.unwrap_or([1.0, 0.0, 0.0]);
    (middle, unit(within(farthest, surface)))
}

/// Of a direction, what is within the surface if that is a plane.
pub fn within(direction: Vector, surface: &Surface) -> Vector {
    match surface.plane() {
        Some((_, normal)) => along(direction, -dot(direction, normal), normal),
        None => direction,
    }
}
