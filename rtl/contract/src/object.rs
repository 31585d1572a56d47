//! Addresses of the words of an object: f1, f2 and the words of the normal come first.

/// Address of the columns of the screen box, in front of that of its lines.
pub const BOX_COLUMNS: u64 = 21;
/// Address of class (bits 1..0) and shift of the root (6..2).
pub const CONTROL: u64 = 23;
/// Address of the first word of plane 0.
pub const PLANES: u64 = 24;
/// Words of one plane.
pub const PLANE_WORDS: u64 = 7;

/// Words of an object with so many planes.
pub const fn words(planes: usize) -> usize {
    PLANES as usize + PLANE_WORDS as usize * planes
}
