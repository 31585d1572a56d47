//! Processors of objects, and what they are made of.

mod clamped;
mod contour_choice;
mod cut_plane;
mod cylinder_processor;
mod depth_interval;
mod facet_processor;
mod first_generation_processor;
mod half_space;
mod half_spaces;
mod interval;
mod normal_unit;
mod patch_decider;
mod patch_processor;
mod plane_depth;
mod polyhedral_volume;
mod polyhedron_processor;
mod quadric_pe;
mod quadric_processor;
mod quadric_volume;
mod roots;
mod screen_box;
mod sphere_processor;
mod two_volume_merge;
mod visible;
mod volume;
mod words;

pub use contour_choice::{Contours, contour_choice};
pub use cut_plane::{Cut, cut_plane};
pub use cylinder_processor::{Cylinder, cylinder_processor};
pub use depth_interval::{Halves, depth_interval};
pub use facet_processor::{Facet, curved_facet_processor, facet_processor};
pub use first_generation_processor::{FirstGeneration, first_generation_processor};
pub use half_space::{HalfSpace, PlaneAt, half_space_test};
pub use half_spaces::{Kept, half_spaces};
pub use interval::Interval;
pub use normal_unit::{Face, Normal, NormalWords, normal_unit};
pub use patch_decider::patch_decider;
pub use patch_processor::{Patch, patch_processor};
pub use plane_depth::plane_depth;
pub use polyhedral_volume::polyhedral_volume;
pub use polyhedron_processor::{BackFace, BothFaces, Polyhedron, polyhedron_processor};
pub use quadric_pe::{Depths, Network, quadric_pe};
pub use quadric_processor::{Shape, quadric_processor};
pub use quadric_volume::{VolumeWords, quadric_volume};
pub use roots::Roots;
pub use screen_box::ScreenBox;
pub use sphere_processor::{Sphere, sphere_processor};
pub use two_volume_merge::two_volume_merge;
pub use visible::{Front, Seen, Visible};
pub use volume::{Answer, Bounds, VolumePoint};
pub use words::{Factors, Gradients, Plane, Quadric, Widths, Words};

use normal_unit::constant_normal;
use roots::roots;
use visible::{object_processor, visible};

pub(crate) use imogene_contract::words::NORMAL;
use imogene_contract::words::far_end;
use imogene_hdl::Int;

/// An end of a depth word.
fn end(of: fn(u32) -> i64, width: u32) -> Int {
    Int::new(of(width), width)
}

/// The far end: the background, and the mark of what is absent.
pub(crate) fn absent(width: u32) -> Int {
    end(far_end, width)
}
