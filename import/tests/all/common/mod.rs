//! What several tests use.

pub mod bar;
#[path = "../../../src/cases.rs"]
pub mod cases;
pub mod points;
pub mod structure;
pub mod winding;
