//! What the words of a machine carry that come over its stream.

/// Kinds of words, by their `tdest`.
pub mod kind {
    /// A word of an object.
    pub const OBJECT: u8 = 0;
    /// A word of a volume.
    pub const VOLUME: u8 = 1;
    /// A word of the shading processor.
    pub const SHADING: u8 = 2;
    /// The material of an object.
    pub const MATERIAL: u8 = 3;
    /// A command.
    pub const COMMAND: u8 = 4;
}

/// Addresses of commands, and bits of their words.
pub mod command {
    /// First column and line of the zone.
    pub const ORIGIN: u16 = 0;
    /// Columns and lines of the zone.
    pub const SIZE: u16 = 1;
    /// A drawing pass.
    pub const DRAW: u16 = 2;
    /// A lighting pass.
    pub const LIGHT: u16 = 3;
    /// A showing pass.
    pub const SHOW: u16 = 4;
    /// Of a beam machine of several graphics modules: those that the words behind it are for, a bit each.
    pub const MODULES: u16 = 5;

    /// Bit of draw and light: the first one of the zone.
    pub const FIRST: u64 = 1;
    /// Bit of show: the zone had a light pass.
    pub const LIT: u64 = 1;
    /// Bit of show: the zone had a draw pass.
    pub const DRAWN: u64 = 2;
    /// Bit of show: the last zone of the frame. Bits 8..3 are the sample of a pixel.
    pub const LAST_ZONE: u64 = 4;
}

/// Address of the id of an object in a machine that shares its processors in time.
pub const OBJECT_ID: u16 = 255;
