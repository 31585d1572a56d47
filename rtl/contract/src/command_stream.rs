//! What the words of a machine carry that come over its stream, by their `tdest`.

/// A word of an object.
pub const OBJECT_WORD: u64 = 0;
/// A word of a volume.
pub const VOLUME_WORD: u64 = 1;
/// A word of the shading processor.
pub const SHADING_WORD: u64 = 2;
/// The material of an object.
pub const MATERIAL_WORD: u64 = 3;
/// A command.
pub const COMMAND: u64 = 4;

/// Command: first column and line of the zone.
pub const ORIGIN: u64 = 0;
/// Command: columns and lines of the zone.
pub const SIZE: u64 = 1;
/// Command: a drawing pass.
pub const DRAW: u64 = 2;
/// Command: a lighting pass.
pub const LIGHT: u64 = 3;
/// Command: a showing pass.
pub const SHOW: u64 = 4;

/// Address of the id of an object in a machine that shares its processors in time.
pub const OBJECT_ID: u64 = 255;
