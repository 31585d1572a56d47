//! All tests of the crate, as one program.

mod memory;
mod outputs;
mod read;
mod text;
