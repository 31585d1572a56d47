//! Golden models of what stands between the object processors and the picture.

pub mod accumulator;
pub mod beam;
pub mod card_decider;
pub mod csg;
pub mod decider;
pub mod frame;
pub mod frame_store;
pub mod lighting;
pub mod line_merger;
pub mod overlay;
pub mod pixel_fifo;
pub mod post_filter;
pub mod raster;
pub mod sequencer;
pub mod shader;
pub mod shadow;
pub mod skew;
pub mod tile;
pub mod tmds;
pub mod transparency;
pub mod video_timing;
pub mod visibility_chain;
pub mod zone;
