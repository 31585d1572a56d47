//! What several tests use.

pub mod winding;
