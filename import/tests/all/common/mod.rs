//! What several tests use.

pub mod bar;
pub mod cases;
pub mod points;
pub mod structure;
pub mod winding;
