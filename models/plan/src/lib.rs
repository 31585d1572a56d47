//! What a machine is given of the words of a scene: culling, zones, divisions, screens.

mod beam;
pub mod culling;
pub mod description;
pub mod display;
pub mod needs;
pub mod split;
pub mod zone;
