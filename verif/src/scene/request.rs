//! What is asked of a co-simulation of a scene, and why there may be none.

use crate::engine::design::DesignError;
use imogene_golden::object::quadric::{MAX_PLANES, QuadricWords};
use thiserror::Error;

/// Most objects of a beam machine.
pub const MAX_OBJECTS: usize = 256;

/// Waveforms wanted of a run.
#[derive(Clone, Debug)]
pub struct WaveformRequest {
    /// Slot whose inside is traced.
    pub object: usize,
    /// Where the window begins; the clocks around the first mismatch are always recorded.
    pub from: WindowStart,
    /// Clocks of the window.
    pub clocks: u64,
}

/// Where a window of waveforms begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WindowStart {
    /// At the middle line of the traced object's screen box.
    Object,
    /// At the pixel of this column and line.
    Pixel(usize, usize),
    /// Nowhere: a mismatch alone is shown, in whichever band it is.
    Mismatch,
}

impl WaveformRequest {
    /// The column and line at which the window begins, where `middle` is the middle line of the traced object.
    pub(super) fn begin(&self, middle: impl Fn() -> usize) -> Option<(usize, usize)> {
        match self.from {
            WindowStart::Object => Some((0, middle())),
            WindowStart::Pixel(column, line) => Some((column, line)),
            WindowStart::Mismatch => None,
        }
    }
}

/// A wrong bit in one coefficient word of the hardware, to see that the co-simulation finds it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Slot.
    pub object: u8,
    /// Load address.
    pub address: u8,
    /// Bit of the word.
    pub bit: u8,
}

/// How to run.
#[derive(Clone, Debug)]
pub struct Options {
    /// Rows of the root network per register stage.
    pub rows_per_stage: usize,
    /// Threads, each with an engine of its own.
    pub threads: usize,
    /// Waveforms of the band in which the window begins.
    pub trace: Option<WaveformRequest>,
    /// Fault put into the hardware.
    pub fault: Option<Fault>,
}

impl Options {
    /// A run without waveforms and faults.
    pub fn plain(rows_per_stage: usize, threads: usize) -> Options {
        Options {
            rows_per_stage,
            threads,
            trace: None,
            fault: None,
        }
    }
}

/// Why a scene cannot be co-simulated.
#[derive(Debug, Error)]
pub enum CosimError {
    /// More objects than slots.
    #[error("the scene has {count} objects; a beam machine takes 1 to {MAX_OBJECTS}")]
    Objects {
        /// Objects of the scene.
        count: usize,
    },
    /// More planes than a processor can have.
    #[error("an object has {count} cut planes; a quadric processor takes at most {MAX_PLANES}")]
    Planes {
        /// Planes of the object.
        count: usize,
    },
    /// An object of a processor that the machine does not have.
    #[error(
        "object '{object}' is not drawn by a quadric processor, and a beam machine has no other; each of its processors runs by itself"
    )]
    Processor {
        /// Name of the object.
        object: String,
    },
    /// Rows per stage out of range.
    #[error("rows-per-stage is {value}; accepted: 1 to {limit}")]
    Rows {
        /// Given value.
        value: usize,
        /// Rows of the network.
        limit: u32,
    },
    /// A slot, address or bit that does not exist.
    #[error(
        "fault {object}:{address}:{bit} names no coefficient bit of this machine; accepted: OBJECT below {objects}, ADDRESS below {addresses}, BIT below the width of that word"
    )]
    Fault {
        /// Slot.
        object: u8,
        /// Address.
        address: u8,
        /// Bit.
        bit: u8,
        /// Slots of the machine.
        objects: usize,
        /// Words of a slot.
        addresses: usize,
    },
    /// The machine cannot be compiled.
    #[error(transparent)]
    Design(#[from] DesignError),
    /// A pixel to trace from that the picture does not have.
    #[error("there is no pixel {column},{line} to trace from; accepted: 0,0 to {},{}", width - 1, height - 1)]
    TracedPixel {
        /// Given column.
        column: usize,
        /// Given line.
        line: usize,
        /// Pixels of a line.
        width: usize,
        /// Lines.
        height: usize,
    },
    /// A slot to trace that does not exist.
    #[error("there is no object {object} to trace; accepted: 0 to {}", objects - 1)]
    TracedObject {
        /// Given slot.
        object: usize,
        /// Slots of the machine.
        objects: usize,
    },
}

/// The middle line of an object on the screen.
pub(super) fn middle_line(words: &QuadricWords) -> usize {
    let b = &words.screen_box;
    ((b.y0 + b.y1) / 2).max(0) as usize
}
