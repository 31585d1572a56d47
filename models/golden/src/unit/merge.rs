//! The merge of the two halves of a solid seen from inside (source: 2.4.2).

use super::depth_interval::Interval;

/// The nearer half; half A if both start at the same depth.
#[inline]
pub fn merge(a: Interval, b: Interval) -> Interval {
    if a.zf <= b.zf { a } else { b }
}
