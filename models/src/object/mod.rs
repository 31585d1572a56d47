//! Golden models of the object processors.

pub mod line;
pub mod quadric;
