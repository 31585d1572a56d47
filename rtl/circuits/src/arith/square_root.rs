//! Cellular square root network.

use super::RADICAND;
use super::root_rows::{Row, Rows, live};
use imogene_hdl::{Bits, Value, bundle, join, module, net};

bundle! {
    /// A root and what it leaves.
    Root(digits) {
        root: Bits(digits), "floor(sqrt(radicand))";
        remainder: Bits(digits + 1), "radicand - root^2";
    }
}

/// Rows that keep the old remainder where a trial is negative.
pub(super) const RESTORING: Rows = ("square_root_stage", square_root_row);

/// `floor(sqrt(radicand))` and its remainder by restoring rows, `rows_per_stage` of them between registers.
///
/// Latency `ceil(digits / rows_per_stage)`. Section 2.3.3.
pub fn square_root(at: &str, radicand: Bits, rows_per_stage: u32) -> Root {
    first_digits(at, radicand, radicand.width() / 2, rows_per_stage)
}

/// The same without the last rows: the first `kept` digits are the low bits of the root.
///
/// Latency `ceil(kept / rows_per_stage)`.
fn first_digits(at: &str, radicand: Bits, kept: u32, rows_per_stage: u32) -> Root {
    let inputs = ("radicand", radicand, RADICAND);
    module("square_root", at, inputs, |radicand| {
        let first = Row::first(radicand, radicand.width() / 2 + 1);
        let last = first.behind(0..kept, rows_per_stage, RESTORING);
        let Row {
            root, remainder, ..
        } = last;
        Root { root, remainder }
    })
}

/// The first `kept` digits of the root, the lower ones zero: low by less than `2^(digits - kept)`.
///
/// Latency `ceil(kept / rows_per_stage)`. Restatement 4.3.
pub fn square_root_rows(at: &str, radicand: Bits, kept: u32, rows_per_stage: u32) -> Bits {
    let inputs = ("radicand", radicand, RADICAND);
    module("square_root_rows", at, inputs, |radicand| {
        let network = first_digits("network", radicand, kept, rows_per_stage);
        let root = network.root.left(radicand.width() / 2 - kept);
        let meaning = "root whose first D digits are kept, the lower ones zero";
        ("root", root, meaning)
    })
}

/// The live bits of a row that leaves a remainder of any length.
pub(super) fn all_live(digits: u32) -> Bits {
    live(digits - 1, digits)
}

/// One digit of the root: `trial = 4 remainder + next pair - (4 root + 1)`. One subtraction serves both as the
/// comparison, by its sign, and as the new remainder.
///
/// The remainder is at most twice the root: row k leaves one of `k + 2` bits and finds the sign of the trial above
/// them.
pub(super) fn square_root_row(at: &str, row: Row, live: Bits) -> Row {
    let inputs = (row, ("live", live));
    module("square_root_row", at, inputs, |(row, live)| {
        let width = live.width();
        net! {
            let divisor = join([row.root, Bits::new(1, 2)]);
            let trial = row.dividend() - divisor;
            let sign = live + Bits::new(1, width);
            let negative = !(trial & sign).is(0);
            let kept = negative.select(row.dividend(), trial) & live;
        }
        ("next", row.next(negative, kept.low(width - 1)))
    })
}
