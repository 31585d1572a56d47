//! What is asked of an object and what it answers: by intervals on a rectangle of pixels, exactly at one.

use crate::interval::Interval;
use crate::root::Real;
use num_rational::BigRational;
use std::cmp::Ordering;

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Column of its middle, in half pixels from the middle of the picture.
    pub x: f64,
    /// Line of its middle.
    pub y: f64,
    /// Half its width in half pixels; 0 for one column.
    pub reach_x: f64,
    /// Half its height.
    pub reach_y: f64,
    /// Least parameter that is drawn.
    pub first: f64,
    /// Parameter before which everything drawn lies; infinite in perspective.
    pub last: f64,
}

/// What is known of an object on a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// It is nowhere on the cell.
    Absent,
    /// It is everywhere on the cell.
    Hit {
        /// The parameter lies here.
        t: Interval,
        /// Number of the face.
        number: u8,
        /// Facet of a mesh; 0 else.
        part: u32,
    },
    /// Not known; if it is there, not before this parameter.
    Open(f64),
}

/// The parameters between which everything drawn lies.
#[derive(Clone, Debug)]
pub struct Ends {
    /// The least: the near end of the depth.
    pub first: BigRational,
    /// The end, which is not drawn; `None` if that is infinity.
    pub last: Option<BigRational>,
}

impl Ends {
    /// True if a point at this parameter is drawn.
    pub fn hold(&self, t: &Real) -> bool {
        t.cmp_fraction(&self.first) != Ordering::Less && self.end_after(t)
    }

    /// True if a point at this parameter is before the end.
    pub fn end_after(&self, t: &Real) -> bool {
        let last = self.last.as_ref();
        last.is_none_or(|last| t.cmp_fraction(last) == Ordering::Less)
    }
}

/// The first point of an object.
#[derive(Clone, Debug)]
pub struct Solved {
    /// Its parameter.
    pub t: Real,
    /// Number of the face.
    pub number: u8,
    /// Facet of a mesh; 0 else.
    pub part: u32,
}
