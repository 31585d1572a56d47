//! The units from which processors and machines are built.

pub mod cut_plane;
pub mod delay;
pub mod depth_interval;
pub mod normal_unit;
pub mod pe1;
pub mod pe2;
pub mod plane_depth;
pub mod quadric_pe;
pub mod square_root;
pub mod two_volume_merge;
