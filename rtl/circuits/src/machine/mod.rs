//! The parts of a machine around its processors.

mod beam;
mod beam_core;
mod beam_display;
mod beam_stream;
mod coefficient_hold;
mod coefficient_store;
mod csg_product;
mod decider;
mod frame_loader;
mod layer;
mod layer_raster;
mod object_array;
mod object_clocks;
mod pixel_count;
mod raster_control;
mod sample_mean;
mod shadow_stage;
mod show_control;
mod slot;
mod stream;
mod tile;
mod tile_raster;
mod visibility_chain;
mod volume_array;
mod volume_store;
mod zone_buffer;
mod zone_control;
mod zone_core;
mod zone_display;
mod zone_machine;

pub use beam::{Beam, beam};
pub use beam_core::{BeamMachine, beam_core};
pub use beam_display::{Display, beam_display};
pub use beam_stream::{Streamed, beam_stream};
pub use coefficient_hold::{Held, HeldPlane, coefficient_hold};
pub use coefficient_store::{LoadBus, coefficient_store};
pub use csg_product::{Extent, csg_product};
use csg_product::{product_clocks, products};
pub use decider::{Candidate, decider, visibility_node};
pub use frame_loader::{Loaded, frame_loader};
pub use object_array::{ID, Load, Objects, Surface, object_array};
pub use raster_control::{Raster, Zone, raster_control};
pub use sample_mean::{Coloured, MEAN_LATENCY, SamplePass, sample_mean};
pub use shadow_stage::{Volume, shadow_clocks, shadow_stage};
pub use show_control::{Issued, Window, show_control};
pub use stream::{Beat, WordBus, stream_slice};
pub use tile::{TilePins, tile};
pub use visibility_chain::{card_decider, visibility_chain};
use visibility_chain::{decided, decider_clocks, lag};
pub use volume_array::{Lit, VolumeLoad, Volumes, volume_array};
pub use volume_store::{StoredVolume, volume_store};
pub use zone_buffer::{Kept, Steps, zone_buffer};
pub use zone_control::{Control, Pass, Waits, zone_control};
pub use zone_core::{Ahead, SHOW_CLOCKS, Shown, TableWord, ZoneCore, zone_core};
pub use zone_display::{ZoneScreen, zone_display};
pub use zone_machine::{ZoneMachine, zone_machine};

use crate::object::NORMAL;
use crate::raster::COORDINATE;
use imogene_contract::shading;
use imogene_hdl::Bits;

/// Bits of the flags of all sources.
const SOURCES: u32 = 16;
/// Bits of a word of the shading processor.
const SHADING: u32 = 32;
/// Bits of the number of a material.
const MATERIAL: u32 = shading::MOST_MATERIALS.ilog2();

/// The flags of all sources.
fn all_sources() -> Bits {
    Bits::new((1 << SOURCES) - 1, SOURCES)
}
