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
    let (n, d) = if denominator < 0 {
        (-numerator, -denominator)
    } else {
        (numerator, denominator)
    };
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

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use num_integer::Integer;
    use proptest::prelude::*;

    fn expected(n: i128, d: i128, bits: u32) -> Quotient {
        if d == 0 {
            return Quotient::None;
        }
        let exact = BigInt::from(n).div_floor(&BigInt::from(d));
        let half = BigInt::from(1) << (bits - 1);
        if exact < -&half {
            Quotient::Below
        } else if exact >= half {
            Quotient::Above
        } else {
            Quotient::Word(i64::try_from(exact).expect("a word"))
        }
    }

    #[test]
    fn every_small_quotient_is_rounded_downwards() {
        for bits in 1..=6 {
            for n in -300..=300 {
                for d in -20..=20 {
                    assert_eq!(
                        restoring_quotient(n, d, bits),
                        expected(n, d, bits),
                        "{n} / {d}"
                    );
                }
            }
        }
    }

    proptest! {
        #[test]
        fn wide_words_too(d in -(1i128 << 44)..1 << 44, q in -(1i128 << 33)..1 << 33, rest in -(1i128 << 44)..1 << 44, bits in prop_oneof![Just(16u32), Just(24), Just(32)]) {
            // About the ends of the word as often as within it.
            let q = if q % 3 == 0 { q >> 20 } else { q };
            let n = q * d + rest % (d.abs() + 1);
            prop_assert_eq!(restoring_quotient(n, d, bits), expected(n, d, bits));
        }
    }
}
