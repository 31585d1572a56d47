//! Widths and special values of a format.

/// Depth words of the tables of errors, proofs and costs.
pub const DEPTH_WORDS: [u32; 5] = [16, 20, 24, 28, 32];
/// Least depth word.
pub const LEAST_DEPTH: u32 = 8;
/// Greatest depth word: the quadratic word has 64 bits.
pub const MOST_DEPTH: u32 = MOST_BITS / 2;
/// Bits of the widest word.
pub const MOST_BITS: u32 = 64;

/// A word, what it has, and the least and the greatest it may have, in bits.
pub type WordRange = (&'static str, u32, u32, u32);

/// Bits of a coordinate.
pub const COORDINATE: u32 = 12;
/// Bits of the first-degree part of a normal component.
pub const NORMAL_PART: u32 = 24;
/// Bits of a normal component and of the factor of the root in it.
pub const NORMAL: u32 = 16;
/// Least root.
pub const LEAST_ROOT: u32 = 4;
/// Least normal component.
pub const LEAST_NORMAL: u32 = 10;
/// Most guard bits of either part of a depth.
pub const MOST_GUARD: u32 = 16;
/// Most last digits of the root that are not computed.
pub const MOST_DROPPED: u32 = 8;
/// Length of an exact normal in a 16-bit component; that of a paraboloid is up to 21 pi / 64 longer, which still fits.
pub const NORMAL_LENGTH: i64 = 31_000;
/// Most cut planes of one object.
pub const MOST_PLANES: u32 = 12;
/// Most sides of a facet.
pub const MOST_SIDES: u32 = 4;
/// Lights of a shading processor at most.
pub const MOST_LIGHTS: u32 = 16;
/// Most objects of one machine.
pub const MOST_OBJECTS: u32 = 256;
/// Most transparent objects of a pipeline.
pub const MOST_LAYERS: u32 = 8;
/// Most objects that a product of a solid intersects, and most that it takes away.
pub const MOST_MEMBERS: u32 = 16;

/// Bits of a depth sum of a format.
pub const fn depth_sum(depth_word: u32) -> u32 {
    depth_word + 2
}

/// Bits of a quadratic word, and of the radicand.
pub const fn quadratic(depth_word: u32) -> u32 {
    2 * depth_word
}

/// Bits of a plane word.
pub const fn plane(depth_word: u32) -> u32 {
    depth_word.saturating_add(12)
}

/// Bits of the denominator of a quotient: those of a plane word, if the numerator then has a bit less than the widest
/// word.
pub const fn denominator(plane: u32, depth_word: u32) -> u32 {
    let most = MOST_BITS - 1 - depth_word;
    if plane < most { plane } else { most }
}

/// `ZMAX`: the far end, the background and the mark of an absent object.
pub const fn far_end(depth_word: u32) -> i64 {
    (1 << (depth_word - 1)) - 1
}

/// `ZLOW`: the near end.
pub const fn near_end(depth_word: u32) -> i64 {
    -far_end(depth_word)
}

/// The lowest word a plane is clamped to, one below the near end.
pub const fn saturated_near(depth_word: u32) -> i64 {
    near_end(depth_word) - 1
}

/// Face number of the near root of a quadric.
pub const NEAR_ROOT: u64 = 0;
/// Face number of the far root of a quadric.
pub const FAR_ROOT: u64 = 1;
/// Face number of the first plane.
pub const FIRST_PLANE: u64 = 2;
/// Face number of the cap at the near end.
pub const CAP: u64 = 15;

/// Class of a solid between its two roots.
pub const SIDE: u64 = 0;
/// Class of a solid outside its two roots.
pub const FRONT: u64 = 1;
/// Class of a bare surface.
pub const PATCH: u64 = 2;
/// Class of a solid present where the quadratic is not negative.
pub const PRISM: u64 = 3;

/// Kind of a plane that keeps what lies behind it.
pub const FRONT_PLANE: u64 = 1;
/// Kind of a plane that keeps what lies before it.
pub const BACK_PLANE: u64 = 2;
/// Kind of a plane perpendicular to the screen.
pub const PERPENDICULAR: u64 = 3;

/// Clocks from the flags of a line to those of its lanes, where several pixels are drawn at once.
pub const LANES_LATENCY: u32 = 3;
