//! All tests of the crate, as one program.

mod census;
mod contract;
mod core;
mod processors;
