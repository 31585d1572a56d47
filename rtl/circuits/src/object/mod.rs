//! Processors of objects, and what they are made of.

mod quadric_pe;

pub use quadric_pe::{Depths, quadric_pe};
