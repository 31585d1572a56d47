//! Beats of the command stream: all that a zone machine is told.

use imogene_contract::command_stream;
use serde::{Deserialize, Serialize};

/// Bytes of a beat: 64 bits of data, 16 of address, 8 of unit, 4 of kind, and padding.
pub const BEAT_BYTES: u64 = 12;

/// Kinds of beats.
pub mod kind {
    use imogene_contract::command_stream;

    /// Coefficient word of an object processor.
    pub const OBJECT: u8 = command_stream::OBJECT_WORD as u8;
    /// Coefficient word of a volume processor.
    pub const VOLUME: u8 = command_stream::VOLUME_WORD as u8;
    /// Word of the shading processor.
    pub const SHADING: u8 = command_stream::SHADING_WORD as u8;
    /// Material of an object.
    pub const MATERIAL: u8 = command_stream::MATERIAL_WORD as u8;
    /// Command.
    pub const COMMAND: u8 = command_stream::COMMAND as u8;
}

/// Addresses of commands.
pub mod command {
    use imogene_contract::command_stream;

    /// First column and line of the zone.
    pub const ORIGIN: u16 = command_stream::ORIGIN as u16;
    /// Columns and lines of the zone.
    pub const SIZE: u16 = command_stream::SIZE as u16;
    /// Draw pass.
    pub const DRAW: u16 = command_stream::DRAW as u16;
    /// Light pass.
    pub const LIGHT: u16 = command_stream::LIGHT as u16;
    /// Show pass.
    pub const SHOW: u16 = command_stream::SHOW as u16;

    /// Bit of draw and light: the first one of the zone.
    pub const FIRST: u64 = 1;
    /// Bit of show: the zone had a light pass.
    pub const LIT: u64 = 1;
    /// Bit of show: the zone had a draw pass.
    pub const DRAWN: u64 = 2;
    /// Bit of show: the last zone of the frame. Bits 8..3 are the sample
    /// ([`Sample`](crate::machine::zone::sample::Sample)).
    pub const LAST_ZONE: u64 = 4;
}

/// Address of an object processor's id.
pub const ID_ADDRESS: u16 = command_stream::OBJECT_ID as u16;

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
