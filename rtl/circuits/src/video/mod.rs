//! What happens to pixels behind the shading, up to the screen.

mod accumulator;
mod frame_scan;
mod frame_store;
mod line_merger;
mod overlay;
mod pixel_fifo;
mod pixel_place;
mod post_filter;
mod scene_sequencer;
mod tmds_encoder;
mod tmds_serialiser;
mod video_output;
mod video_timing;

pub use accumulator::{PassPixel, accumulator};
pub use frame_scan::{Scanned, frame_scan};
pub use frame_store::{Asked, FRAME_LATENCY, PixelStream, frame_store};
pub use line_merger::{Group, Merged, ModuleStream, line_merger};
pub use overlay::{BitPlane, OVERLAY_LATENCY, overlay};
pub use pixel_fifo::{Queue, Queued, pixel_fifo};
pub use pixel_place::pixel_place;
pub use post_filter::{Picture, Place, post_filter};
pub use scene_sequencer::{SEQUENCE, Sequence, Sequenced, scene_sequencer};
pub use tmds_encoder::{Channel, SYMBOL, tmds_encoder};
pub use tmds_serialiser::{Symbols, tmds_serialiser};
pub use video_output::{Output, OverlayBus, Pins, Wanted, video_output};
pub use video_timing::{Screen, video_timing};

use crate::raster::COORDINATE;
use crate::rows::{PerLane, alike};
use imogene_hdl::{Bits, Value, join};

/// Bits of a level of a colour.
pub const LEVEL: u32 = 8;
/// Bits of a colour.
const COLOUR: u32 = 3 * LEVEL;

/// So many colours of words that have two neighbours each, the left one in the low bits.
pub(crate) fn colours_of_pairs(words: &[Bits], count: u32) -> PerLane<Bits> {
    PerLane::of(count, |pixel| {
        let low = COLOUR * (pixel % 2);
        words[pixel as usize / 2].slice(low + COLOUR - 1, low)
    })
}

alike! {
    /// A colour.
    Colour(width): [Bits(width); 3] {
        r, "red";
        g, "green";
        b, "blue";
    }
}

impl Colour {
    /// The colour of a word that has red in its upper third and blue in its lower one.
    pub fn unpacked(word: Bits) -> Colour {
        let width = word.width() / 3;
        Colour::of([2, 1, 0].map(|third| word.slice((third + 1) * width - 1, third * width)))
    }

    /// The word of a colour.
    pub fn packed(self) -> Bits {
        join(self.parts())
    }
}
