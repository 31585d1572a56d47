//! Words of the shading processor and their addresses.

/// Clocks from a pixel to its colour.
pub const LATENCY: usize = 66;
/// The same of lit-sphere shading.
pub const LIT_SPHERE_LATENCY: u32 = 36;
/// The same of tables of `2^places` by `2^places` entries, between them or of the nearest one.
pub const fn table_latency(places: u32, nearest: bool) -> u32 {
    if nearest {
        12 + places
    } else {
        LIT_SPHERE_LATENCY
    }
}
/// The same where there are no lights.
pub const FLAT_LATENCY: u32 = 5;
/// Bits after the point of a level before it is rounded.
pub const LEVEL_FRACTION: usize = 21;

/// Address of columns and lines of the picture.
pub const SIZE: u64 = 0;
/// Address of the flags of the view and of its shift.
pub const VIEW: u64 = 1;
/// Address of the distance of the eye.
pub const DISTANCE: u64 = 2;
/// Address of the word of the attenuation.
pub const ATTENUATION: u64 = 3;
/// Address of the colour of the background.
pub const BACKGROUND: u64 = 4;
/// Address of the first word of light 0.
pub const LIGHT: u64 = 0x10;
/// Addresses from one light to the next.
pub const LIGHT_WORDS: u64 = 0x10;
/// Address of the first word of material 0.
pub const MATERIAL: u64 = 0x1000;
/// Words of a material.
pub const MATERIAL_WORDS: u64 = 4;
/// Materials at most.
pub const MOST_MATERIALS: u64 = 256;
/// Address of the first entry of the table of lit-sphere shading.
pub const TABLE: u64 = 0x8000;
/// Tables of lit-sphere shading at most.
pub const MOST_TABLES: u32 = 32;
/// Bits of the address of an entry: of all tables together.
pub const TABLE_BITS: u32 = 15;
/// Bits of a level in an entry, of which two are behind the point; red stands in the low ones.
pub const ENTRY_LEVEL: u32 = 10;
/// Bits of a level where the nearest entry is taken as it is.
pub const NEAREST_LEVEL: u32 = 8;
/// Low bits of a line of sight in perspective that are left out where the nearest entry is taken.
pub const NEAREST_DROPPED: u32 = 2;
