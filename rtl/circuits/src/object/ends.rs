//! Ends of a depth word.

use imogene_contract::words::far_end;
use imogene_hdl::Int;

/// An end of a depth word.
pub(super) fn end(of: fn(u32) -> i64, width: u32) -> Int {
    Int::new(of(width), width)
}

/// The far end: the background, and the mark of what is absent.
pub(crate) fn absent(width: u32) -> Int {
    end(far_end, width)
}
