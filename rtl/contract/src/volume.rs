//! Addresses of the words of a shadow or light volume: f1 and f2 come first.

/// Address of the columns of the screen box, in front of that of its lines.
pub const BOX_COLUMNS: u64 = 9;
/// Address of class (bits 1..0), shift of the depth (5..2), light volume (6) and source (10..7).
pub const CONTROL: u64 = 11;
/// Address of the margin.
pub const MARGIN: u64 = 12;
/// Address of the first word of plane 0.
pub const PLANES: u64 = 13;
/// Words of one plane.
pub const PLANE_WORDS: u64 = 4;

/// Words of a volume with so many planes.
pub const fn words(planes: usize) -> usize {
    PLANES as usize + PLANE_WORDS as usize * planes
}
