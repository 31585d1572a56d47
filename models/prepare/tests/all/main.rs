//! All tests of the crate, as one program.

mod enclosure;
mod extent;
mod facet_contour;
mod fields;
mod forms;
mod generated_scenes;
mod generations;
mod guards;
mod kind_errors;
mod light_errors;
mod located;
mod paraboloids;
mod refusals;
mod remedies;
mod rounding;
mod seams;
mod solids;
mod unused;
mod volumes;
mod zones;
