//! The circuits of imogene, as functions over values: see `imogene_hdl`.
//!
//! A circuit that is a module of its own takes the name of its instance first. Widths follow from the values that it
//! is given. Sections without a name are those of Nyiri 1994.

pub mod arith;
pub mod machine;
pub mod machines;
pub mod object;
pub mod raster;
mod rows;
pub mod shade;
pub mod tree;
pub mod units;
pub mod video;
