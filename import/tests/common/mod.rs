//! What several tests use.

#[allow(dead_code)] // Not every file of tests uses all of it.
pub mod winding;
