//! Division by fifteen.

use imogene_hdl::{Bits, Value, net};

/// Bits of a value, at least.
pub(super) const FIFTEENTH: u32 = 17;

/// `floor(value / 15)` without error, by additions alone; the value is at most `15 * 2^32`.
///
/// With its low 16 bits l and the rest h, `2^16 = 15 * 0x1111 + 1` gives the quotient `0x1111 h + floor((h + l) /
/// 15)`, and the floor is `((h + l + 1) * 0x11111) >> 20`. Both factors are sums of shifts: eight additions in all.
/// Without registers.
pub(super) fn fifteenth(value: Bits) -> Bits {
    // `h + l + 1` has a bit more than the longer of both, and 0x11111 has 17.
    let width = (value.width() - 16).max(16) + 1 + 17;
    let and_shifted = |word: Bits, places: u32| word + word.left(places);
    net! {
        let high = value.slice(value.width() - 1, 16).extend(width);
        let low = value.low(16).extend(width);
        let more = high + low + Bits::new(1, width);
        let ones_2 = and_shifted(more, 4);
        let ones_5 = and_shifted(ones_2, 8) + more.left(16);
        let low_quotient = ones_5.slice(width - 1, 20).extend(width);
        let high_quotient = and_shifted(and_shifted(high, 4), 8);
    }
    high_quotient + low_quotient
}
