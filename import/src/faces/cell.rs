//! What faces become: cells, parts of one quadric or of one plane, each bounded by the AND of cut planes.

use super::planes::Planes;
use super::surface::Implicit;
use super::vector::Vector;

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
#[derive(Clone, Debug, Default, PartialEq)]
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

/// Something of a face, or why the face is not drawn.
pub type Made<T> = Result<T, String>;

/// A compiled face.
#[derive(Clone, Debug, PartialEq)]
pub struct Compiled {
    /// What became of it.
    pub verdict: Verdict,
    /// Its parts; none if it is rejected or its solid is one volume.
    pub cells: Vec<Cell>,
}

/// What became of a solid.
pub enum Compilation {
    /// One volume for all its faces.
    Volume(Cell),
    /// Each face by itself, in the order of the solid.
    Faces(Vec<Compiled>),
}
