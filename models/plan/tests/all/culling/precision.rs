use imogene_algebra::rational::{fraction, integer};
use imogene_plan::culling::precision::guard_bits;
use num_rational::BigRational;

/// Coefficients about the middle of the box, each rounded to half of its last bit, at the pixel farthest from it,
/// exactly.
#[test]
fn rounding_with_guard_bits_moves_less_than_half_a_count() {
    for pixels in (1..=130).chain([719, 720, 1023, 1024, 1025, 4096]) {
        // A box of n pixels about a pixel in its middle.
        let far = integer(pixels / 2);
        let [linear, quadratic] = guard_bits(pixels as u64);
        let last = |guards: u32| fraction(1, 1 << guards) / integer(2);
        let one = integer(1);
        let of_f1: BigRational = (&far + &far + &one) * last(linear);
        let square = &far * &far;
        let of_f2 = (integer(3) * &square + integer(2) * &far + &one) * last(quadratic);
        assert!(of_f1 <= fraction(1, 2), "{pixels}: {of_f1}");
        assert!(of_f2 <= fraction(1, 2), "{pixels}: {of_f2}");
    }
}
