//! What several tests use.

#[allow(dead_code)] // Not every file of tests uses all of it.
pub mod bar;
#[allow(dead_code)] // The same.
pub mod points;
#[allow(dead_code)] // The same.
pub mod winding;
