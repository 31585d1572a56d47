//! Beats of the command stream: all that a zone machine is told.

pub use imogene_contract::command_stream::{OBJECT_ID, command, kind};
use serde::{Deserialize, Serialize};

/// Bytes of a beat: 64 bits of data, 16 of address, 8 of unit, 4 of kind, and padding.
pub const BEAT_BYTES: u64 = 12;

/// One beat of the stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Beat {
    /// What it is, 4 bits: a constant of [`mod@kind`].
    pub kind: u8,
    /// Processor, for coefficient words.
    pub unit: u8,
    /// Address of the word, object of the material, or the command.
    pub address: u16,
    /// The word, in the low bits.
    pub data: u64,
    /// The final beat of the frame.
    pub last: bool,
}

impl Beat {
    /// A beat that is not the final one.
    pub const fn new(kind: u8, unit: u8, address: u16, data: u64) -> Beat {
        Beat {
            kind,
            unit,
            address,
            data,
            last: false,
        }
    }

    /// A command.
    pub const fn command(address: u16, data: u64) -> Beat {
        Beat::new(kind::COMMAND, 0, address, data)
    }
}
