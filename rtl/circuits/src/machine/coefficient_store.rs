//! Coefficient words of one object.

use crate::object::{Factors, Gradients, Normal, Place, Plane, Widths, Words};
use crate::raster::{Linear, Quadratic};
use imogene_hdl::{Bits, Int, Value, bundle, module};

bundle! {
    /// The load bus.
    LoadBus(width) {
        write: Bits(1), "write `data` to `address`";
        address: Bits(8), "which word";
        data: Bits(width), "the word, a narrower one in the low bits";
    }
}

/// Address of the columns of the screen box, in front of those of its lines, of class and shift, and of the planes.
pub const BOX_COLUMNS: u64 = 21;
/// Words of one plane.
pub const PLANE_WORDS: u64 = 7;

/// Keeps the words of one object; each is visible after the clock that writes it and holds until written again.
///
/// At power-up every word is zero, but the screen box is empty (`box_x0` = 4095), so that a store never loaded holds
/// an absent object. Addresses follow the order of [`Words`]; the box is packed in two words, class and shift in one.
/// Other addresses are ignored.
pub fn coefficient_store(at: &str, bus: LoadBus, widths: Widths, planes: u64) -> Words {
    module("coefficient_store", at, bus, |bus| {
        let store = Store { bus };
        let linear = |first: u64, width: u32| Linear {
            a: store.number(first, width),
            b: store.number(first + 1, width),
            c: store.number(first + 2, width),
        };
        let word = |index: u64| store.number(3 + index, widths.quadratic);
        let factor = |index: u64| store.number(18 + index, widths.normal);
        let plane = |index: u64| {
            let first = BOX_COLUMNS + 3 + PLANE_WORDS * index;
            let number = |word: u64, width: u32| store.number(first + word, width);
            Plane {
                kind: store.bits(first, 1, 0),
                linear: linear(first + 1, widths.plane),
                normal: Normal {
                    nx: number(4, widths.normal),
                    ny: number(5, widths.normal),
                    nz: number(6, widths.normal),
                },
            }
        };
        let inverted_box_x0 = (!bus.data.low(12)).reg_when(store.writes(BOX_COLUMNS));
        Words {
            f1: linear(0, widths.linear),
            f2: Quadratic {
                a2: word(0),
                b2: word(1),
                c: word(2),
                i0: word(3),
                p0: word(4),
                f: word(5),
            },
            gradients: Gradients {
                gx: linear(9, widths.gradient),
                gy: linear(12, widths.gradient),
                gz: linear(15, widths.gradient),
                factors: Factors {
                    kx: factor(0),
                    ky: factor(1),
                    kz: factor(2),
                },
            },
            place: Place {
                box_x0: !inverted_box_x0.named("inverted_box_x0"),
                box_x1: store.bits(BOX_COLUMNS, 23, 12),
                box_y0: store.bits(BOX_COLUMNS + 1, 11, 0),
                box_y1: store.bits(BOX_COLUMNS + 1, 23, 12),
                object_class: store.bits(BOX_COLUMNS + 2, 1, 0),
                shift: store.bits(BOX_COLUMNS + 2, 6, 2),
            },
            planes: (0..planes).map(plane).collect(),
        }
    })
}

/// Registers behind a load bus.
struct Store {
    bus: LoadBus,
}

impl Store {
    fn writes(&self, address: u64) -> Bits {
        self.bus.write & self.bus.address.is(address)
    }

    fn bits(&self, address: u64, high: u32, low: u32) -> Bits {
        self.bus
            .data
            .slice(high, low)
            .reg_when(self.writes(address))
    }

    fn number(&self, address: u64, width: u32) -> Int {
        self.bus
            .data
            .low(width)
            .int()
            .reg_when(self.writes(address))
    }
}
