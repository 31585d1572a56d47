//! Products of numbers that are longer than a factor of a multiplier.

use imogene_hdl::{Int, Value, join, module, net, ports};

/// Bits of a factor of a multiplier, with a sign.
const FACTOR: u32 = 18;
/// Bits of the low part of a longer number, which has no sign.
const LOW: u32 = FACTOR - 1;

/// Latency of a product of long numbers.
pub const PRODUCT: u32 = 5;

/// Latency of a product whose `b` has so many bits: where it is one factor, there is no sum of those in the middle.
pub fn product_latency(b: u32) -> u32 {
    if b > FACTOR { PRODUCT } else { PRODUCT - 1 }
}

/// The whole product, at most one multiplier or one sum between two registers; `a` has more than 18 bits, both at
/// most 35.
///
/// Latency [`product_latency`]: a register before the products of the parts, these, a register behind them, the sum of
/// those in the middle, the sum of all.
pub fn product(at: &str, a: Int, b: Int) -> Int {
    module("product", at, ports!(a, b), |(a, b)| {
        let whole = match b.width() > FACTOR {
            true => of_parts(halves(a), halves(b)),
            false => of_half(halves(a), b),
        };
        ("product", whole)
    })
}

/// The low part of a number as one that is not negative, and the high part.
fn halves(number: Int) -> [Int; 2] {
    let low = number.slice(LOW - 1, 0).extend(FACTOR).int();
    [low, number.slice(number.width() - 1, LOW).int()]
}

fn of_half([low, high]: [Int; 2], b: Int) -> Int {
    net! {
        let low_part = low.reg();
        let high_part = high.reg();
        let factor = b.reg();
        let low_product = (low_part * factor).delay(2);
        let high_product = (high_part * factor).delay(2);
    }
    let width = high_product.width();
    let carried = low_product.slice(low_product.width() - 1, LOW).int();
    net! {
        let high_sum = (high_product + carried.extend(width)).reg();
        let low_bits = low_product.slice(LOW - 1, 0).reg();
    }
    join([high_sum.bits(), low_bits]).int()
}

fn of_parts(a: [Int; 2], b: [Int; 2]) -> Int {
    let [a, b] = [a, b].map(|parts| parts.map(Int::reg));
    net! {
        let low_product = (a[0] * b[0]).delay(2);
        let first_middle = (a[1] * b[0]).delay(2);
        let second_middle = (a[0] * b[1]).delay(2);
        let high_product = (a[1] * b[1]).delay(2);
    }
    let width = first_middle.width().max(second_middle.width()) + 1;
    let low_bits = low_product.slice(2 * LOW - 1, 0);
    net! {
        let middle = (first_middle.extend(width) + second_middle.extend(width)).reg();
        // The product of the low parts has no more bits than stand below that of the high ones.
        let outer = join([high_product.bits(), low_bits]).reg();
    }
    let upper = outer.slice(outer.width() - 1, LOW).int();
    net! {
        let high_sum = (upper + middle.extend(upper.width())).reg();
        let low_sum = outer.slice(LOW - 1, 0).reg();
    }
    join([high_sum.bits(), low_sum]).int()
}
