//! All tests of the crate that need it from outside, as one program.

mod emission;
mod latency;
mod prefix;
mod reading_path;
mod slang;
mod support;
