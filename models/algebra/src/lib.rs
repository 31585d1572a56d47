//! Exact rationals and what is computed with them.

pub mod rational;
