//! All tests of the crate, as one program.

mod emission;
mod emit;
mod latency;
mod prefix;
mod reading_path;
mod slang;
mod support;
