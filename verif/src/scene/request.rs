//! What is asked of a co-simulation of a scene, and why there may be none.

use crate::engine::design::DesignError;
use crate::waveform::{PlaceError, WaveformRequest};
use imogene_golden::object::quadric::{MAX_PLANES, QuadricWords};
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// Most objects of a beam machine.
pub const MAX_OBJECTS: usize = 256;

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

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.object, self.address, self.bit)
    }
}

impl FromStr for Fault {
    type Err = String;

    fn from_str(text: &str) -> Result<Fault, String> {
        let numbers: Option<Vec<u8>> = text.split(':').map(|part| part.parse().ok()).collect();
        match numbers.as_deref() {
            Some(&[object, address, bit]) => Ok(Fault {
                object,
                address,
                bit,
            }),
            _ => Err("expected OBJECT:ADDRESS:BIT, three numbers below 256, such as 0:2:5".into()),
        }
    }
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
    /// Slot whose inside they show.
    pub traced: usize,
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
            traced: 0,
            fault: None,
        }
    }
}

/// Why a scene cannot be co-simulated.
#[derive(Debug, Error)]
pub enum CosimError {
    /// More objects than slots, or none.
    #[error("the scene has {0} objects; a beam machine takes 1 to {MAX_OBJECTS}")]
    Objects(usize),
    /// More planes than a processor can have.
    #[error("an object has {0} cut planes; a quadric processor takes at most {MAX_PLANES}")]
    Planes(usize),
    /// An object of a processor that the machine does not have.
    #[error(
        "object '{0}' is not drawn by a quadric processor, and a beam machine has no other; each of its processors runs by itself"
    )]
    Processor(String),
    /// Rows per stage out of range, and the rows of the network.
    #[error("rows-per-stage is {0}; accepted: 1 to {1}")]
    Rows(usize, u32),
    /// A slot, address or bit that does not exist; the slots of the machine, and the words of a slot.
    #[error(
        "fault {0} names no coefficient bit of this machine; accepted: OBJECT below {1}, ADDRESS below {2}, BIT below the width of that word"
    )]
    Fault(Fault, usize, usize),
    /// The machine cannot be compiled.
    #[error(transparent)]
    Design(#[from] DesignError),
    /// A place to trace from that the picture does not have.
    #[error(transparent)]
    TracedPlace(#[from] PlaceError),
    /// A slot to trace that does not exist, and the last one.
    #[error("there is no object {0} to trace; accepted: 0 to {1}")]
    TracedObject(usize, usize),
    /// There is no hardware of the processor of an object, where each runs by itself.
    #[error(
        "object '{0}': the viewer so nearly lies on its quadric that its depth is a quotient with a root in it, for which there is no hardware; \
         move the camera, or draw the scene with --model golden or exact"
    )]
    NoHardware(String),
    /// Widths that processors have in a machine alone.
    #[error(
        "only a beam machine takes --guards and --widths, and it draws 1 to 256 quadrics; \
         give --format, or render with --model golden or exact; \
         a zone machine draws facets with guard bits (imogene machine)"
    )]
    OwnWords,
}

/// The middle line of an object on the screen.
pub(super) fn middle_line(words: &QuadricWords) -> usize {
    let b = &words.screen_box;
    ((b.y0 + b.y1) / 2).max(0) as usize
}
