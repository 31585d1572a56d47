//! The parts of the shading processor.

pub mod attenuation;
pub mod light_component;
pub mod light_factors;
pub mod light_store;
pub mod sent_light;
pub mod sight;
pub mod view_store;
