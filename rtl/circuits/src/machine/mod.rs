//! The parts of a machine around its processors.

mod beam;
mod coefficient_store;
mod decider;
mod raster_control;
mod shadow_stage;
mod visibility_chain;

pub use beam::{Beam, Load, Slot, beam};
pub use coefficient_store::{BOX_COLUMNS, LoadBus, PLANE_WORDS, coefficient_store};
pub use decider::{Candidate, decider, visibility_node};
pub use raster_control::{Raster, Zone, raster_control};
pub use shadow_stage::{Volume, shadow_stage};
pub use visibility_chain::{card_decider, visibility_chain};
