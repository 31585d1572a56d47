//! Object processors.

pub mod curved_facet_processor;
pub mod cylinder_processor;
pub mod facet_processor;
pub mod first_generation_processor;
pub mod patch_processor;
pub mod polyhedral_volume;
pub mod polyhedron_processor;
pub mod quadric_processor;
pub mod quadric_volume;
pub mod sphere_processor;
