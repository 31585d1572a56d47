//! Kinds of object processors in the slots of a machine, and addresses of the words of an object.
//!
//! Of a quadric f1, f2 and the words of the normal come first. Every other kind has its screen box at 0 and 1, and
//! behind it the words of its other ports, each at the next address.

use crate::words::{MOST_PLANES, MOST_SIDES};
use serde::{Deserialize, Serialize};

/// Which processor stands in a slot.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Quadrics of every class; draws patches, polyhedra and flat facets too.
    #[default]
    Quadric,
    /// Bare surfaces cut by planes.
    Patch,
    /// Convex polyhedra.
    Polyhedron,
    /// Flat facets of three or four sides.
    Facet,
    /// Facets of second degree.
    CurvedFacet,
    /// Spheres by paraboloids.
    Sphere,
    /// Cylinders by parabolic cylinders.
    Cylinder,
    /// Quadrics of the first generation.
    FirstGeneration,
    /// Quadrics whose depth is a quotient.
    Quotient,
}

/// Each kind, its name, and the fewest and the most planes or sides that its processor is built for.
pub const KINDS: [(Kind, &str, [u32; 2]); 9] = [
    (Kind::Quadric, "quadric", [0, MOST_PLANES]),
    (Kind::Patch, "patch", [0, MOST_PLANES]),
    (Kind::Polyhedron, "polyhedron", [1, MOST_PLANES]),
    (Kind::Facet, "facet", [3, MOST_SIDES]),
    (Kind::CurvedFacet, "curved_facet", [1, MOST_SIDES]),
    (Kind::Sphere, "sphere", [0, 0]),
    (Kind::Cylinder, "cylinder", [0, 0]),
    (Kind::FirstGeneration, "first_generation", [0, 0]),
    (Kind::Quotient, "quotient", [0, MOST_PLANES]),
];

impl Kind {
    /// Its name.
    pub const fn name(self) -> &'static str {
        KINDS[self as usize].1
    }

    /// The fewest and the most planes or sides.
    pub const fn planes(self) -> [u32; 2] {
        KINDS[self as usize].2
    }

    /// Words of an object with so many planes or sides.
    pub const fn words(self, planes: usize) -> usize {
        let [first, each] = match self {
            Kind::Quadric => return words(planes),
            Kind::Patch => [24, 4],
            Kind::Polyhedron => [2, 7],
            Kind::Facet => [14, 3],
            Kind::CurvedFacet => [26, 6],
            Kind::Sphere => [27, 0],
            Kind::Cylinder => [56, 0],
            Kind::FirstGeneration => [52, 0],
            Kind::Quotient => [26, 7],
        };
        first + each * planes
    }

    /// Address of the word that tells a processor which is shared that it has an object: the control word of a
    /// quadric, the columns of the box of every other kind.
    pub const fn presence(self) -> u64 {
        match self {
            Kind::Quadric => CONTROL,
            _ => self.box_columns(),
        }
    }

    /// Address of the columns of the screen box.
    pub const fn box_columns(self) -> u64 {
        match self {
            Kind::Quadric => BOX_COLUMNS,
            _ => 0,
        }
    }
}

/// The slots of one product of a solid: of the objects that it intersects, and behind them of those that it takes away.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ProductSlots {
    /// Objects intersected, 1 to 16.
    pub intersected: usize,
    /// Objects taken away, 0 to 16.
    pub subtracted: usize,
}

impl ProductSlots {
    /// All of them.
    pub const fn count(&self) -> usize {
        self.intersected + self.subtracted
    }

    /// Are they enough for a product of so many objects intersected and taken away?
    pub const fn hold(&self, [intersected, subtracted]: [usize; 2]) -> bool {
        intersected <= self.intersected && subtracted <= self.subtracted
    }
}

/// Address of the columns of the screen box of a quadric, in front of that of its lines.
pub const BOX_COLUMNS: u64 = 21;
/// Address of class (bits 1..0) and shift of the root (6..2).
pub const CONTROL: u64 = 23;
/// Address of the first word of plane 0.
pub const PLANES: u64 = 24;
/// Words of one plane.
pub const PLANE_WORDS: u64 = 7;

/// Words of an object with so many planes.
pub const fn words(planes: usize) -> usize {
    PLANES as usize + PLANE_WORDS as usize * planes
}
