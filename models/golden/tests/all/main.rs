//! All tests of the crate, as one program.

mod common;
mod elementary;
mod facets;
mod first_generation;
mod format;
mod machine;
mod object;
mod unit;
mod widths;
