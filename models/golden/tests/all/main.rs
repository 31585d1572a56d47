//! All tests of the crate that need it from outside, as one program.

mod elementary;
mod facets;
mod first_generation;
mod paraboloids;
