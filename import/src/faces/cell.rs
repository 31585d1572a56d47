//! What faces become: cells, parts of a quadric or plane within cut planes. A plane has one description for all faces.

use super::curve::PlaneOf;
use super::surface::Implicit;
use super::vector::{Vector, cross, dot, length, minus};
use std::cell::RefCell;

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

/// Something whose sign divides a surface in two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Separator {
    /// The sign of `normal . p - offset`: a unit normal, and the offset.
    Plane((Vector, f64)),
    /// The sign of a quadric; divides planes alone.
    Quadric(Implicit),
}

impl Separator {
    /// Whether a point is on the positive side.
    pub fn is_positive(&self, p: Vector) -> bool {
        match self {
            Self::Plane((normal, offset)) => dot(*normal, p) > *offset,
            Self::Quadric(implicit) => implicit.value(p) > 0.0,
        }
    }
}

/// All planes of a part; whoever has a part of it may add to them.
#[derive(Debug)]
pub struct Planes {
    all: RefCell<Vec<PlaneOf>>,
    tolerance: f64,
}

impl Planes {
    /// None yet; two planes within `tolerance` (a length) over a part of size 1 / 1e-9 of it are one.
    pub fn new(tolerance: f64) -> Planes {
        let all = RefCell::default();
        Planes { all, tolerance }
    }

    /// The index of the plane through a point; an earlier description of the same plane is used again.
    pub fn find_or_add(&self, point: Vector, normal: Vector) -> usize {
        let normal = clean(normal);
        let mut all = self.all.borrow_mut();
        let same = |(other, along): &PlaneOf| {
            length(cross(*along, normal)) <= 1e-9
                && dot(minus(point, *other), *along).abs() <= self.tolerance
        };
        all.iter().position(same).unwrap_or_else(|| {
            all.push((point, normal));
            all.len() - 1
        })
    }

    /// A point and the unit normal of a plane; a face on the other side has the opposite one.
    pub fn get(&self, index: usize) -> PlaneOf {
        self.all.borrow()[index]
    }

    /// Whether a point is on the side of a plane's normal.
    pub fn is_positive(&self, index: usize, p: Vector) -> bool {
        let (point, normal) = self.get(index);
        dot(minus(p, point), normal) > 0.0
    }

    /// A plane as a separator.
    pub fn separator(&self, index: usize) -> Separator {
        let (point, normal) = self.get(index);
        Separator::Plane((normal, dot(normal, point)))
    }
}

/// A direction without the dust that sines leave beside 0 and 1.
pub fn clean(normal: Vector) -> Vector {
    normal.map(|value| {
        // Without the sign of a zero.
        let nearest = value.round() + 0.0;
        let is_dusty = (value - nearest).abs() <= 1e-15;
        if is_dusty { nearest } else { value }
    })
}
