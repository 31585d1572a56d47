//! Words of a tile: a chip that shows one quadric with its cut planes. They stand in its wiring.

use crate::MachineWords;
use crate::video::VideoMode;

/// Bits of the light.
pub const LIGHT: u32 = 6;
/// Bits of a factor of a colour.
pub const FACTOR: u32 = 5;
/// Bits of the linear part of the light behind its point.
pub const LIGHT_FRACTION: u32 = 8;
/// Bits of the linear part of the light: two more before the point than the light has, for both signs.
pub const LIGHT_LINEAR: u32 = LIGHT + 2 + LIGHT_FRACTION;
/// Bits that a threshold of the dither has; as many of a level lie below the bits of the pins.
pub const THRESHOLD: u32 = 4;
/// Greatest level: all bits of the pins at every threshold.
pub const MOST_LEVEL: u64 = 3 << THRESHOLD;
/// Bits of a colour on the pins.
pub const PIN_BITS: u32 = 2;
/// Cut planes at most.
pub const MOST_TILE_PLANES: usize = 3;

/// All of a tile. The object is a solid between its two roots (class side).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TileWords {
    /// The screen.
    pub mode: VideoMode,
    /// Widths of the words.
    pub widths: MachineWords,
    /// Columns and lines of the window that the object is drawn in; smaller than the screen.
    pub window: [u64; 2],
    /// Column and line of the window on the screen in the first frame.
    pub start: [u64; 2],
    /// Linear part of the depth: a, b, c of `a x + b y + c` in the pixels of the window.
    pub f1: [i64; 3],
    /// Quadratic under the root: a to f of `a x^2 + b y^2 + c xy + d x + e y + f`.
    pub f2: [i64; 6],
    /// The cut planes.
    pub planes: Vec<TilePlane>,
    /// What the depth of the first plane grows by in a frame in which the window goes to the right; it shrinks by as
    /// much in others.
    pub drift: i64,
    /// The light on the quadric.
    pub light: TileLight,
    /// Factors of the light in red, green, blue, in 32ths.
    pub colour: [u64; 3],
    /// Levels where nothing is.
    pub background: [u64; 3],
}

/// A cut plane of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TilePlane {
    /// 1 front, 2 back, 3 perpendicular.
    pub kind: u64,
    /// Its depth.
    pub depth: [i64; 3],
    /// The light on it.
    pub light: u64,
}

/// The light on a quadric: `linear / 2^8 + (factor r) / 2^shift`, both rounded down, and no less than the ambient one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TileLight {
    /// Its part without the root.
    pub linear: [i64; 3],
    /// Factor of the root, -7 to 7.
    pub factor: i64,
    /// Places that the product with the root is shifted to the right.
    pub shift: u32,
    /// Where there is no other.
    pub ambient: u64,
}
