//! Square of a word wider than the multipliers.

use imogene_hdl::{Bits, Value, module};

/// Bits of a digit: the factors of a signed multiplier of 16 bits by 16.
const DIGIT: u32 = 15;

/// `value^2 mod 2^width` of at most 45 bits, from products of its digits of 15 bits, each pair of digits once.
///
/// Without registers: a multiplier and three additions deep.
pub(super) fn square(at: &str, value: Bits, width: u32) -> Bits {
    let inputs = ("value", value);
    module("square", at, inputs, |value| {
        let highest = value.width() - 1;
        let digit = |index: u32| {
            let first = DIGIT * index;
            let digit = value.slice(highest.min(first + DIGIT - 1), first);
            digit.extend(DIGIT + 1).int()
        };
        let pairs = (0..=highest / DIGIT).flat_map(|j| (0..=j).map(move |i| (i, j)));
        // A pair of different digits counts twice.
        let placed = pairs.map(|(i, j)| (i, j, DIGIT * (i + j) + u32::from(i != j)));
        let within = placed.filter(|(_, _, place)| *place < width);
        let terms = within.map(|(i, j, place)| {
            let product = (digit(i) * digit(j)).bits();
            let product = product.low(product.width().min(width));
            product.extend(width).left(place)
        });
        let terms: Vec<Bits> = terms.collect();
        let sum = |terms: &[Bits]| terms.iter().copied().reduce(|a, b| a + b).expect("a term");
        let sums: Vec<Bits> = terms.chunks(2).map(sum).collect();
        ("square", sum(&sums))
    })
}
