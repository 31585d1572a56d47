//! Square root by one row, digit after digit.

use super::RADICAND;
use super::root_rows::Row;
use super::square_root::{Root, all_live, square_root_row};
use imogene_hdl::{Bits, Value, bundles, module, net};

bundles! {
    /// A root that takes its time.
    Iterative {
        busy: Bits as "busy", "digits are being found";
        done: Bits as "done", "root and remainder are complete; high for one clock";
        result: Root as "", "kept until the next obeyed start";
    }
}

/// `floor(sqrt(radicand))` and its remainder by one row: one result in as many clocks as digits.
///
/// `start` is obeyed when not busy, beside `done` too, and ignored otherwise. The edge that obeys it reads the
/// radicand and finds the first digit. Latency: the digits. Section 2.3.3.
pub fn square_root_iterative(at: &str, start: Bits, radicand: Bits) -> Iterative {
    let meaning = "take the radicand; obeyed when not busy, ignored otherwise";
    let inputs = (("start", start, meaning), ("radicand", radicand, RADICAND));
    module("square_root_iterative", at, inputs, |(start, radicand)| {
        let digits = radicand.width() / 2;
        let count = |value: u32| Bits::new(value.into(), 6);
        let kept = Row {
            pairs: Bits::register(2 * digits),
            root: Bits::register(digits),
            remainder: Bits::register(digits + 1),
        };
        net! {
            let digits_left = Bits::register(6);
            let is_busy = !digits_left.is(0);
            let begins = start & !is_busy;
            let current = begins.select(count(digits), digits_left);
            let works = begins | is_busy;
        }
        let row = begins.select(Row::first(radicand, digits + 1), kept);
        let next = square_root_row("row", row, all_live(digits));
        kept.pairs.load_when(works, next.pairs);
        kept.root.load_when(works, next.root);
        kept.remainder.load_when(works, next.remainder);
        digits_left.load_when(works, current - count(1));
        let Row {
            root, remainder, ..
        } = kept;
        Iterative {
            busy: is_busy,
            done: current.is(1).reg(),
            result: Root { root, remainder },
        }
    })
}
