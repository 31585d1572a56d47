//! All tests of the crate, as one program.

mod find;
mod kept;
mod program;
