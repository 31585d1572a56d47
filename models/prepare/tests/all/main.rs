//! All tests of the crate that need it from outside, as one program.

mod facet_contour;
mod fields;
mod generated_scenes;
mod generations;
mod guards;
mod kind_errors;
mod light_errors;
mod refusals;
mod remedies;
mod unused;
mod volumes;
mod zones;
