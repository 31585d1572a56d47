//! All tests of the crate, as one program.

mod animation;
mod bounds;
mod check;
mod check_kinds;
mod exact;
mod exact_reference;
mod eye_on_quadric;
mod glass;
mod golden_against_exact;
mod golden_vectors;
mod hazards;
mod hazards_normal;
mod machine_needs;
mod metrics;
mod pictures;
mod processors;
mod shader;
mod shadows;
mod solids;
mod unseen;
