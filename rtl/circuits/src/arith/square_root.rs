//! Cellular square root network.

use imogene_hdl::{Bits, Value, bundle, join, module, net};

bundle! {
    /// What a row takes.
    Row(digits) {
        pairs: Bits(2 * digits), "pairs not used yet, the next one at the top";
        root: Bits(digits), "digits found so far";
        remainder: Bits(digits + 1), "remainder so far";
    }

    /// The same as the outputs of a row.
    Next(digits) {
        next_pairs: Bits(2 * digits), "pairs left";
        next_root: Bits(digits), "root with one more digit";
        next_remainder: Bits(digits + 1), "remainder after this digit";
    }

    /// A root and what it leaves.
    Root(digits) {
        root: Bits(digits), "largest integer whose square is not greater than the radicand";
        remainder: Bits(digits + 1), "radicand less the square of the root";
    }
}

impl Next {
    fn row(self) -> Row {
        Row {
            pairs: self.next_pairs,
            root: self.next_root,
            remainder: self.next_remainder,
        }
    }
}

/// `floor(sqrt(radicand))` and its remainder by restoring rows, `rows_per_stage` of them between registers.
///
/// Latency `ceil(digits / rows_per_stage)`. Section 2.3.3.
pub fn square_root(at: &str, radicand: Bits, rows_per_stage: u32) -> Root {
    module(
        "square_root",
        at,
        ("radicand", radicand),
        |(_, radicand)| {
            let digits = radicand.width() / 2;
            let mut row = Row {
                pairs: radicand,
                root: Bits::new(0, digits),
                remainder: Bits::new(0, digits + 1),
            };
            for stage in 0..digits.div_ceil(rows_per_stage) {
                let first = stage * rows_per_stage;
                let rows = rows_per_stage.min(digits - first);
                row = square_root_stage(&format!("stages_{stage}"), row, live(first, digits), rows);
            }
            Root {
                root: row.root,
                remainder: row.remainder,
            }
        },
    )
}

/// Ones at the bits that the remainder can have behind row k, from 0: it is at most twice the root of `k + 1` digits.
fn live(k: u32, digits: u32) -> Bits {
    Bits::new((1 << (k + 2)) - 1, digits + 2)
}

/// Some rows, then registers. `live` belongs to the first row.
fn square_root_stage(at: &str, row: Row, live: Bits, rows: u32) -> Row {
    module(
        "square_root_stage",
        at,
        (row, ("live", live)),
        |(mut row, (_, mut live))| {
            for index in 0..rows {
                row = square_root_row(&format!("rows_{index}"), row, live);
                live = join([live.low(live.width() - 1), Bits::new(1, 1)]);
            }
            Next {
                next_pairs: row.pairs.reg(),
                next_root: row.root.reg(),
                next_remainder: row.remainder.reg(),
            }
        },
    )
    .row()
}

/// One digit of the root: `trial = 4 remainder + next pair - (4 root + 1)`. One subtraction serves both as the
/// comparison, by its sign, and as the new remainder.
///
/// Row k finds the sign of the trial at bit `k + 2`, above the live bits. These are constants, so that synthesis trims
/// each row to its cells, while all are one module.
fn square_root_row(at: &str, row: Row, live: Bits) -> Row {
    module(
        "square_root_row",
        at,
        (row, ("live", live)),
        |(row, (_, live))| {
            let digits = row.root.width();
            net! {
                let pair = row.pairs.slice(2 * digits - 1, 2 * digits - 2);
                let dividend = join([row.remainder.low(digits), pair]);
                let divisor = join([row.root, Bits::new(1, 2)]);
                let trial = dividend - divisor;
                let sign = live + Bits::new(1, digits + 2);
                let negative = !(trial & sign).is(0);
            let kept = negative.select(dividend, trial) & live;
                let doubled = row.root.left(1);
            }
            Next {
                next_pairs: row.pairs.left(2),
                next_root: negative.select(doubled, doubled | Bits::new(1, digits)),
                next_remainder: kept.low(digits + 1),
            }
        },
    )
    .row()
}
