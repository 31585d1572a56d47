//! All tests of the crate, as one program.

mod common;
mod faces;
mod faces_adjacent;
mod faces_cracks;
mod faces_input;
mod faces_oracle;
mod faces_parts;
mod mmcif;
mod molecule;
mod molecule_rules;
mod packed;
mod step_files;
mod step_input;
mod step_oracle;
mod step_words;
mod structure_files;
mod terrain;
mod torus;
