//! Golden models of the units, one per file.

pub mod cut_plane;
pub mod depth_interval;
pub mod half_spaces;
pub mod interlaced;
pub mod lattice;
pub mod membership;
pub mod merge;
pub mod normal;
pub mod patch_decider;
pub mod pe1;
pub mod pe2;
pub mod plane_depth;
pub mod programmable;
pub mod quadric_pe;
pub mod quotient;
pub mod root;
