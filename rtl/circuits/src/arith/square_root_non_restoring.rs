//! Non-restoring square root network.

use super::RADICAND;
use super::root_rows::{Row, Rows, grown};
use super::square_root::Root;
use imogene_hdl::{Bits, Value, join, module, net};

/// `floor(sqrt(radicand))` and its remainder by non-restoring rows, `rows_per_stage` of them between registers.
///
/// No row chooses between two remainders, so a row is an addition alone; in return a negative last remainder gets `2
/// root + 1` added behind the last register. Latency `ceil(digits / rows_per_stage)`. Section 2.3.3.
pub fn square_root_non_restoring(at: &str, radicand: Bits, rows_per_stage: u32) -> Root {
    let inputs = ("radicand", radicand, RADICAND);
    module("square_root_non_restoring", at, inputs, |radicand| {
        let digits = radicand.width() / 2;
        let kind: Rows = ("non_restoring_stage", non_restoring_row);
        let last = Row::first(radicand, digits + 2).behind(0..digits, rows_per_stage, kind);
        net! {
            let restoring = join([Bits::new(0, 1), last.root, Bits::new(1, 1)]);
            let restored = last.remainder + restoring;
            let whole = last.remainder.top().select(restored, last.remainder);
        }
        Root {
            root: last.root,
            remainder: whole.low(digits + 1),
        }
    })
}

/// One digit of the root: `4 remainder + next pair`, less `4 root + 1` where the remainder is not negative, plus `4
/// root + 3` where it is.
///
/// Because `-(4 root + 1) = ~(4 root)` in two's complement, both are one addition whose addend is `4 root` or its
/// complement, the low two bits set. Row k takes a remainder of `k + 2` bits with its sign; the bits above are zeros.
fn non_restoring_row(at: &str, row: Row, live: Bits) -> Row {
    let inputs = (row, ("live", live));
    module("non_restoring_row", at, inputs, |(row, live)| {
        let width = live.width();
        net! {
            let sign = live ^ live.slice(width - 1, 1).extend(width);
            let was_negative = !(row.remainder & sign).is(0);
            let addend = join([was_negative.select(row.root, !row.root), Bits::new(3, 2)]);
            let sum = row.dividend() + addend;
            let next_live = grown(live);
            let next_sign = next_live ^ live;
            let negative = !(sum & next_sign).is(0);
        }
        ("next", row.next(negative, sum & next_live))
    })
}
