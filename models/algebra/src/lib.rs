//! Exact rationals, vectors and matrices, and what is computed with them.

pub mod matrix;
pub mod rational;
pub mod vector;
pub mod whole;
