//! Division by fifteen.

use imogene_hdl::{Bits, Value, net};

/// Bits in which the sums are formed.
const WIDTH: u32 = 48;

/// `floor(value / 15)` without error, by additions alone; the value is below `2^39`.
///
/// With its low 16 bits l and the rest h, `2^16 = 15 * 0x1111 + 1` gives the quotient `0x1111 h + floor((h + l) /
/// 15)`, and the floor is `((h + l + 1) * 0x111111) >> 24`. Both factors are sums of shifts: eight additions in all.
/// Without registers.
pub(super) fn fifteenth(value: Bits) -> Bits {
    let and_shifted = |word: Bits, places: u32| word + word.left(places);
    net! {
        let high = value.slice(value.width() - 1, 16).extend(WIDTH);
        let low = value.low(16).extend(WIDTH);
        let more = high + low + Bits::new(1, WIDTH);
        let ones_2 = and_shifted(more, 4);
        let ones_6 = and_shifted(ones_2, 8) + ones_2.left(16);
        let low_quotient = ones_6.slice(WIDTH - 1, 24).extend(WIDTH);
        let high_quotient = and_shifted(and_shifted(high, 4), 8);
    }
    high_quotient + low_quotient
}
