//! Leading significant digits of the square root.

use super::RADICAND;
use super::root_length::{LENGTH, root_length};
use super::root_rows::Row;
use super::square_root::RESTORING;
use imogene_hdl::{Bits, Value, join, module, net};

/// The `kept` leading significant digits of `floor(sqrt(radicand))`, the lower digits zero; shorter roots are exact.
///
/// The radicand is shifted up by the even count that fills its top pair, so the first digit is 1. Rows find the others
/// that are kept, and the root is shifted back by half the count: the rows left out would only find digits that are
/// zeroed. Of the radicand 0 the shift leaves nothing. The root is low by less than `2^(1 - kept)` of itself. Latency
/// `ceil((kept - 1) / rows_per_stage) + 2`, one clock for each shift. Section B.10.
pub fn square_root_leading(at: &str, radicand: Bits, kept: u32, rows_per_stage: u32) -> Bits {
    let inputs = ("radicand", radicand, RADICAND);
    module("square_root_leading", at, inputs, |radicand| {
        let digits = radicand.width() / 2;
        net! {
            let places = Bits::new(digits.into(), LENGTH) - root_length("measured", radicand);
            let doubled_places = join([places, Bits::new(0, 1)]);
            let normal = radicand.left_by(doubled_places).reg();
            let kept_places = places.reg();
        }
        let root = behind_one(normal)
            .behind(1..kept, rows_per_stage, RESTORING)
            .root;
        net! { let aligned = root.left(digits - kept); }
        let places = kept_places.delayed_as("places_late", (kept - 1).div_ceil(rows_per_stage));
        let root = aligned.right_by(places).reg();
        let meaning = "root whose D leading significant digits are kept, the lower ones zero";
        ("root", root, meaning)
    })
}

/// What the first row leaves of a radicand whose first pair is not 0: the digit 1, and the pair less 1.
fn behind_one(radicand: Bits) -> Row {
    let digits = radicand.width() / 2;
    let [high, low] = [1, 2].map(|place| radicand.bit(2 * digits - place));
    net! { let rest = join([high & low, high & !low]); }
    Row {
        pairs: radicand.left(2),
        root: Bits::new(1, digits),
        remainder: rest.extend(digits + 1),
    }
}
