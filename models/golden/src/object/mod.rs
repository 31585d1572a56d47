//! Golden models of the object processors.

pub mod as_quadric;
pub mod curved_facet;
pub mod cylinder;
pub mod facet;
pub mod facet_contour;
pub mod first_generation;
mod lanes;
pub mod line;
pub mod load;
pub mod load_slot;
pub mod load_volume;
pub mod member;
pub mod paraboloid;
pub mod patch;
pub mod polyhedron;
pub mod quadric;
pub mod quotient;
pub mod range;
pub mod screen_box;
pub mod slot;
pub mod sphere;
pub mod unused;
pub mod volume;
pub mod volume_line;
pub mod words;
