//! Helpers on exact rationals.
//!
//! A scene is written in decimal and prepared without rounding: every coefficient stays a ratio of big integers until
//! it is rounded, once, to the word the hardware is loaded with. These helpers are the two ends of that path.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::float::FloatCore;
use num_traits::{FromPrimitive, ToPrimitive, Zero};

/// The integer `value` as a rational.
pub fn integer(value: i64) -> BigRational {
    BigRational::from_integer(BigInt::from(value))
}

/// The fraction `numerator / denominator`.
/// Panics if `denominator` is zero.
pub fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(BigInt::from(numerator), BigInt::from(denominator))
}

/// The exact value of the shortest decimal that reads back as `value`: 0.1 gives 1/10, not the binary fraction beside
/// it.
///
/// Decimals of up to 15 significant digits survive the passage through `f64` unchanged.
/// Panics if `value` is not finite.
pub fn from_decimal(value: f64) -> BigRational {
    assert!(
        value.is_finite(),
        "{value} has no decimal value; finite numbers only"
    );
    // The `e` format prints the shortest digits that read back as the same number.
    let text = format!("{value:e}");
    let (mantissa, exponent) = text.split_once('e').expect("`{:e}` prints an exponent");
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: BigInt = format!("{whole}{decimals}")
        .parse()
        .expect("`{:e}` prints decimal digits");
    let exponent: i64 = exponent.parse().expect("`{:e}` prints a whole exponent");
    let shift = exponent - decimals.len() as i64;
    let power = BigInt::from(10).pow(shift.unsigned_abs() as u32);
    if shift < 0 {
        BigRational::new(digits, power)
    } else {
        BigRational::from_integer(digits * power)
    }
}

/// The exact binary value of `value`: 0.1 gives 3602879701896397/2^55.
/// Panics if `value` is not finite.
pub fn from_f64_exact(value: f64) -> BigRational {
    BigRational::from_f64(value).unwrap_or_else(|| panic!("{value} is not a finite number"))
}

/// The `f64` nearest to `value`, also when numerator and denominator are both far outside the range of `f64`.
pub fn to_f64(value: &BigRational) -> f64 {
    if value.is_zero() {
        return 0.0;
    }
    value
        .to_f64()
        .expect("every big rational has a nearest f64, infinite at worst")
}

/// The least `f64` that is not below `value`.
pub fn to_f64_up(value: &BigRational) -> f64 {
    let nearest = to_f64(value);
    if nearest.is_finite() && is_below(nearest, value) {
        nearest.next_up()
    } else {
        nearest
    }
}

/// Is a finite float less than `value`; by whole numbers, so that nothing has to be reduced.
fn is_below(float: f64, value: &BigRational) -> bool {
    let (mantissa, exponent, sign) = float.integer_decode();
    let product = value.denom() * mantissa * sign;
    match exponent < 0 {
        true => product < value.numer() << exponent.unsigned_abs(),
        false => product << exponent < *value.numer(),
    }
}

/// 2^`exponent`.
pub fn power_of_two(exponent: u32) -> BigRational {
    BigRational::from_integer(BigInt::from(1) << exponent)
}

/// The largest integer that is not above `value`.
pub fn floor(value: &BigRational) -> BigInt {
    value.floor().to_integer()
}

/// `value` rounded to the nearest integer, halves upwards: `floor(value + 1/2)`.
pub fn round_half_up(value: &BigRational) -> BigInt {
    // Of the doubled fraction, so that nothing has to be reduced.
    let doubled: BigInt = value.numer() * 2 + value.denom();
    doubled.div_floor(&(value.denom() * 2))
}
