//! The same root through the processor's floating-point unit, for whole pictures.

/// floor(sqrt(radicand)), exact for every radicand from 0 below 2^63. No branch, so that lanes of it run side by side.
///
/// Let `s` be the true root, below 2^31.6. The radicand as a double is off by a factor of at most 1 + 2^-53, its root
/// by half of that, and rounding the root adds as much as the first: together less than 2^-20. The sum with 2^52 is an
/// integer, the one that is nearest. So `|nearest - s| < 1/2 + 2^-20`, and the floor of `s` is `nearest`, or one less
/// if `nearest^2 > radicand`. The difference is less than 2^33 either way; its sign is right although both may wrap.
#[inline(always)]
pub fn fast_root(radicand: i64) -> i64 {
    const INTEGERS: f64 = (1u64 << 52) as f64;
    let sum = (radicand as u64 as f64).sqrt() + INTEGERS;
    let nearest = i64::from(sum.to_bits() as u32);
    let remainder = radicand.wrapping_sub(nearest.wrapping_mul(nearest));
    nearest + (remainder >> 63)
}
