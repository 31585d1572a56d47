//! The units from which processors and machines are built.

pub mod cut_plane;
pub mod delay;
pub mod depth_interval;
pub mod fifteenth;
pub mod normal_unit;
pub mod pe1;
pub mod pe2;
pub mod plane_depth;
pub mod quadric_pe;
pub mod root_correction;
pub mod root_length;
pub mod square;
pub mod square_root;
pub mod square_root_iterative;
pub mod square_root_leading;
pub mod square_root_linear;
pub mod square_root_non_restoring;
pub mod square_root_quadratic;
pub mod square_root_rows;
pub mod two_volume_merge;
