//! The parts of a machine and the machine.

pub mod beam;
pub mod coefficient_store;
pub mod decider;
pub mod raster_control;
pub mod slot_shape;
pub mod visibility_node;
