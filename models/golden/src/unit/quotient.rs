//! The quotient of two integers by a restoring array, rounded downwards: the depth of a surface that the eye lies on
//! (thesis section 2.1.1: c' = 0).
//!
//! The array is the sibling of the root network: one row for each digit of the result, each row a subtraction whose
//! borrow is the digit. The least word is added before the division (`denominator * 2^(bits - 1)` to the numerator), so
//! that all digits of a word in range are those of a number that is not negative and no sign is corrected afterwards.

/// What the array finds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quotient {
    /// Less than every word.
    Below,
    /// The quotient rounded downwards.
    Word(i64),
    /// Greater than every word.
    Above,
    /// The denominator is zero.
    None,
}

/// `floor(numerator / denominator)` as a two's complement word of `bits` bits (1 to 40); the magnitude of the
/// denominator is less than `2^64` and that of the numerator less than `2^120`.
pub fn restoring_quotient(numerator: i128, denominator: i128, bits: u32) -> Quotient {
    if denominator == 0 {
        return Quotient::None;
    }
    let sign = denominator.signum();
    let (n, d) = (sign * numerator, sign * denominator);
    let mut rest = n + (d << (bits - 1));
    if rest < 0 {
        return Quotient::Below;
    }
    if rest >= d << bits {
        return Quotient::Above;
    }
    let mut digits = 0i64;
    for row in (0..bits).rev() {
        let less = rest - (d << row);
        let digit = less >= 0;
        if digit {
            rest = less;
        }
        digits = digits << 1 | i64::from(digit);
    }
    Quotient::Word(digits - (1 << (bits - 1)))
}
