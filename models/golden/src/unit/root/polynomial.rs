//! Estimates of the root by polynomials, and steps that correct them (source: 2.3.3, 4.1.2).

/// `m`: bits of the root of a radicand, which has `2m` or `2m - 1` significant bits; 0 for radicand 0.
pub const fn root_length(radicand: u128) -> u32 {
    (128 - radicand.leading_zeros()).div_ceil(2)
}

/// With `m` from [`root_length`]: `floor((X + 4^m) / 2^(m+1))` for `2m` bits, `floor((X + 4^(m-1)) / 2^m)` for `2m -
/// 1`.
///
/// These are the printed `X / 2^(m+1) + 2^(m-1)` and `X / 2^m + 2^(m-1) - 2^(m-2)`: a shift and one addition. The sum
/// takes `2 K + 1` bits before the shift, or `K` bits after it, because the constant is a multiple of the divisor but
/// for `m = 1`. Error: 0 to 6.066 % of the root before the floor, most at the middle `X = 2^(2m-1)`.
pub fn linear_estimate(radicand: u128) -> u64 {
    let m = root_length(radicand);
    if m == 0 {
        return 0;
    }
    let is_odd_length = radicand >> (2 * m - 1) == 0;
    let estimate = if is_odd_length {
        (radicand + (1 << (2 * m - 2))) >> m
    } else {
        (radicand + (1 << (2 * m))) >> (m + 1)
    };
    estimate as u64
}

/// `15 R = floor(15 X / 2^m) + 2^(m+2) - floor(A^2 / 2^(m-2))` with `A = floor(X / 2^m)`, and `R` the floor of a
/// fifteenth of it.
///
/// That is `R / 2^m = (-4 t^2 + 15 t + 4) / 15` at `t = X / 4^m`, exact at `t` = 1/4, 0.7238 and 1, hence continuous
/// between octaves. The printed sign of the square term is plus, which errs by 53 %. Widths: `A` has `K` bits, its
/// square `2 K`, the sum `K + 4`. The square is taken of `A` and not of `X`, because a square of `2 K` bits costs four
/// times as much and the difference is below one place of 15 R. Error before the floors: 1.345 % of the root.
pub fn quadratic_estimate(radicand: u128) -> u64 {
    let m = root_length(radicand);
    if m == 0 {
        return 0;
    }
    let scaled = radicand >> m;
    // A shift by m - 2 = -1, at m = 1, would change 15 R only where its fifteenth is the same.
    let square = (scaled * scaled) >> m.saturating_sub(2);
    let fifteenfold = ((15 * radicand) >> m) + (4 << m) - square;
    fifteenth(fifteenfold as u64)
}

/// floor(value / 15) for `value < 2^39`, by additions alone and without error.
///
/// `value = 2^16 h + l`, and `2^16 = 15 * 0x1111 + 1`, so the quotient is `0x1111 h + floor((h + l) / 15)`. For
/// `s = h + l < 2^24` the floor is `((s + 1) * 0x111111) >> 24`: with `s = 15 q + r` the product over `2^24` is
/// `q + (r + 1) / 15 - (s + 1) / (15 * 2^24)`, which stays in `[q, q + 1)`. The factors of ones are sums of shifts:
/// eight additions in all, with those that make `s + 1` and join the parts.
pub fn fifteenth(value: u64) -> u64 {
    let (high, low) = (value >> 16, value & 0xffff);
    let sum = high + low + 1;
    0x1111 * high + ((0x11_1111 * sum) >> 24)
}

/// `R' = R - floor((R^2 - X) / 2^(m+1))`, `corrections` times, in floor arithmetic.
///
/// Widths for a radicand of `2 K` bits: `R` has `K + 1` bits, because the floor of a negative excess can round a root
/// up to `2^m`; the excess `R^2 - X` is less than a quarter of the radicand's range and stands in `2 K` bits, two's
/// complement; what is taken from `R` has `K` bits and a sign. The error shrinks by the factor `1 - (R + s) / 2^(m+1)`
/// about the true root `s`: a half at worst.
pub fn corrected(radicand: u128, estimate: u64, corrections: u32) -> u64 {
    let m = root_length(radicand);
    (0..corrections).fold(estimate, |root, _| {
        let excess = i128::from(root) * i128::from(root) - radicand as i128;
        (i128::from(root) - (excess >> (m + 1))) as u64
    })
}
