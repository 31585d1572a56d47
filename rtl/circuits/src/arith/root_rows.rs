//! Rows of a root network, and the registers between them.

use crate::rows::numbered;
use imogene_hdl::{Bits, Bundle, Value, bundle, join, module, net};
use std::ops::Range;

bundle! {
    /// What a row takes, and, called `next`, what it leaves.
    Row(digits, remainder) {
        pairs: Bits(2 * digits), "pairs not used yet, the next one at the top";
        root: Bits(digits), "digits found so far";
        remainder: Bits(remainder), "remainder so far";
    }
}

/// A kind of rows: the module of those between two registers, and the circuit of one row with its live bits.
pub(super) type Rows = (&'static str, fn(&str, Row, Bits) -> Row);

impl Row {
    /// What the first row takes.
    pub(super) fn first(radicand: Bits, remainder: u32) -> Row {
        Row {
            pairs: radicand,
            root: Bits::new(0, radicand.width() / 2),
            remainder: Bits::new(0, remainder),
        }
    }

    /// `4 remainder + next pair`, two bits longer than the root.
    pub(super) fn dividend(&self) -> Bits {
        let digits = self.root.width();
        net! {
            let pair = self.pairs.slice(2 * digits - 1, 2 * digits - 2);
            let dividend = join([self.remainder.low(digits), pair]);
        }
        dividend
    }

    /// What is left behind one more digit, which is 0 where the trial is negative.
    pub(super) fn next(&self, negative: Bits, remainder: Bits) -> Row {
        let doubled = self.root.left(1);
        Row {
            pairs: self.pairs.left(2),
            root: negative.select(doubled, doubled | Bits::new(1, doubled.width())),
            remainder,
        }
    }

    /// Behind these rows of a kind, `rows_per_stage` of them before each register.
    pub(super) fn behind(self, rows: Range<u32>, rows_per_stage: u32, kind: Rows) -> Row {
        let starts = rows.clone().step_by(rows_per_stage as usize);
        numbered("stages", starts).fold(self, |row, (at, first)| {
            let rows = rows_per_stage.min(rows.end - first);
            stage(&at, row, live(first, row.root.width()), rows, kind)
        })
    }
}

/// The live bits of row k, from 0: `k + 2` ones, as many as its remainder can have bits. They are constants, so that
/// synthesis trims each row to its cells, while all are one module.
pub(super) fn live(k: u32, digits: u32) -> Bits {
    Bits::new((1 << (k + 2)) - 1, digits + 2)
}

/// The live bits with one more.
pub(super) fn grown(live: Bits) -> Bits {
    join([live.low(live.width() - 1), Bits::new(1, 1)])
}

/// Some rows, then registers. `live` belongs to the first row.
fn stage(at: &str, row: Row, live: Bits, rows: u32, (name, make): Rows) -> Row {
    module(name, at, (row, ("live", live)), |(mut row, mut live)| {
        for (at, _) in numbered("rows", 0..rows) {
            row = make(&at, row, live);
            live = grown(live);
        }
        ("next", row.registered())
    })
}
