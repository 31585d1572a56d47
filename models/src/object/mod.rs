//! Golden models of the object processors.

pub mod line;
pub mod load;
pub mod patch;
pub mod polyhedron;
pub mod quadric;
pub mod volume;
