//! Processors of objects, and what they are made of.

mod cut_plane;
mod depth_interval;
mod interval;
mod plane_depth;
mod quadric_pe;
mod two_volume_merge;

pub use cut_plane::{Cut, cut_plane};
pub use depth_interval::{Halves, Roots, depth_interval};
pub use interval::Interval;
pub use plane_depth::plane_depth;
pub use quadric_pe::{Depths, quadric_pe};
pub use two_volume_merge::two_volume_merge;

use imogene_contract::words::far_end;
use imogene_hdl::Int;

/// A depth word.
fn depth(value: i64, width: u32) -> Int {
    Int::new(value, width)
}

/// The far end: the background, and the mark of what is absent.
fn absent(width: u32) -> Int {
    depth(far_end(width as usize), width)
}
