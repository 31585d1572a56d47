//! Processors of objects, and what they are made of.

mod cut_plane;
mod depth_interval;
mod interval;
mod normal_unit;
mod plane_depth;
mod quadric_pe;
mod quadric_processor;
mod two_volume_merge;
mod words;

pub use cut_plane::{Cut, cut_plane};
pub use depth_interval::{Halves, Roots, depth_interval};
pub use interval::Interval;
pub use normal_unit::{Face, Normal, NormalWords, normal_unit};
pub use plane_depth::plane_depth;
pub use quadric_pe::{Depths, Network, quadric_pe};
pub use quadric_processor::{Front, Shape, Visible, quadric_processor};
pub use two_volume_merge::two_volume_merge;
pub use words::{Factors, Gradients, Place, Plane, Widths, Words};

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
