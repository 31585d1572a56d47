//! Ends of a depth word.

use imogene_contract::words::far_end;
use imogene_hdl::{Bits, Int, Value};

/// An end of a depth word.
pub(super) fn end(of: fn(u32) -> i64, width: u32) -> Int {
    Int::new(of(width), width)
}

/// The far end: the background, and the mark of what is absent.
pub(crate) fn absent(width: u32) -> Int {
    end(far_end, width)
}

/// 1 where a depth word lies behind the near end, which is one above the least word.
pub(super) fn is_behind_near_end(depth: Int) -> Bits {
    let width = depth.width();
    let places = depth.low(width - 1).bits().high(width - 2);
    !(depth.is_negative() & places.is(0))
}

/// Whether a number is before the near end of a depth word of so many bits, and whether it is not before the far end.
/// The bits say so: a comparison with a constant would take a chain of carries.
pub(super) fn beyond(name: &str, number: Int, width: u32) -> [Bits; 2] {
    let sign = number.is_negative();
    let is_outside = (!fits(number, width)).named(&format!("{name}_is_outside"));
    // The near end is one above the least word, the far end is the greatest.
    let rest = number.low(width - 1).bits();
    [
        sign & (is_outside | rest.is(0)),
        !sign & (is_outside | all_ones(rest)),
    ]
}

/// 1 where a number has a word of so many bits.
pub(super) fn fits(number: Int, width: u32) -> Bits {
    let signs = number.high(number.width() - width + 1).bits();
    signs.is(0) | all_ones(signs)
}

fn all_ones(bits: Bits) -> Bits {
    bits.is(u64::MAX >> (u64::BITS - bits.width()))
}
