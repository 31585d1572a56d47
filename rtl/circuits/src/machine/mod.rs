//! The parts of a machine around its processors.

mod coefficient_store;

pub use coefficient_store::{
    BOX_COLUMNS, Factors, LoadBus, PLANE_WORDS, Place, Plane, Widths, Words, coefficient_store,
};
