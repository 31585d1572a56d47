//! Coefficient words of one object.

use crate::object::{
    Factors, Gradients, HalfSpace, Normal, Plane, Quadric, ScreenBox, Widths, Words,
};
use crate::raster::{Linear, Quadratic};
use imogene_contract::command_stream::OBJECT_ID;
use imogene_contract::object::{BOX_COLUMNS, CONTROL, PLANE_WORDS, PLANES};
use imogene_hdl::{Bits, Int, Value, bundle, module, net};

bundle! {
    /// The load bus.
    LoadBus(width) {
        write: Bits(1), "write data to address";
        address: Bits(8), "address of the word (table of the load bus); others are ignored";
        data: Bits(width), "the word; a narrower one sits in the low bits";
    }
}

/// Keeps the words of one object; each is visible after the clock that writes it and holds until written again.
///
/// At power-up every word is zero, but the screen box is empty (`box_x0` = 4095), so that a store never loaded holds
/// an absent object. Addresses follow the order of [`Words`]; the box is packed in two words, class and shift in one.
/// Other addresses are ignored.
pub fn coefficient_store(at: &str, bus: LoadBus, widths: Widths, planes: u64) -> Words {
    module("coefficient_store", at, bus, |bus| {
        let plane = |index: u64| {
            let first = PLANES + PLANE_WORDS * index;
            Plane {
                half_space: bus.half_space(first, widths.plane),
                normal: Normal::of(bus.numbers(first + 4, widths.normal)),
            }
        };
        net! { let inverted_box_x0 = (!bus.data.low(12)).reg_when(bus.writes(BOX_COLUMNS)); }
        let quadric = Quadric {
            f1: bus.linear(0, widths.linear),
            f2: bus.quadratic(3, widths.quadratic),
            gradients: Gradients {
                gx: bus.linear(9, widths.gradient),
                gy: bus.linear(12, widths.gradient),
                gz: bus.linear(15, widths.gradient),
                factors: Factors::of(bus.numbers(18, widths.normal)),
            },
            screen_box: bus.screen_box(BOX_COLUMNS, !inverted_box_x0),
            shift: bus.bits(CONTROL, 6, 2),
        };
        Words {
            quadric,
            object_class: bus.bits(CONTROL, 1, 0),
            planes: (0..planes).map(plane).collect(),
        }
    })
}

impl LoadBus {
    /// 1 where the word of an address is written.
    pub fn writes(self, address: u64) -> Bits {
        self.write & self.address.is(address)
    }

    /// Bits of the word of an address, held.
    pub fn bits(self, address: u64, high: u32, low: u32) -> Bits {
        self.data.slice(high, low).reg_when(self.writes(address))
    }

    /// The number of an address, held.
    pub fn number(self, address: u64, width: u32) -> Int {
        self.data.low(width).int().reg_when(self.writes(address))
    }

    /// The numbers from an address on, held.
    pub fn numbers<const N: usize>(self, first: u64, width: u32) -> [Int; N] {
        std::array::from_fn(|index| self.number(first + index as u64, width))
    }

    /// The words of a polynomial of first degree from an address on, held.
    pub fn linear(self, first: u64, width: u32) -> Linear {
        Linear::of(self.numbers(first, width))
    }

    /// The words of a polynomial of second degree from an address on, held.
    pub fn quadratic(self, first: u64, width: u32) -> Quadratic {
        Quadratic::of(self.numbers(first, width))
    }

    /// The kind and the depth of a plane from an address on, held.
    pub fn half_space(self, first: u64, width: u32) -> HalfSpace {
        HalfSpace {
            kind: self.bits(first, 1, 0),
            linear: self.linear(first + 1, width),
        }
    }

    /// A screen box in the words of two addresses, but for its first column, held.
    pub fn screen_box(self, columns: u64, box_x0: Bits) -> ScreenBox {
        ScreenBox {
            box_x0,
            box_x1: self.bits(columns, 23, 12),
            box_y0: self.bits(columns + 1, 11, 0),
            box_y1: self.bits(columns + 1, 23, 12),
        }
    }

    /// The id of the object, written to its own address on the bus, as it was taken over.
    pub fn held_id(self, take: Bits) -> Bits {
        net! { let next_id = self.bits(OBJECT_ID.into(), 11, 0); }
        next_id.reg_when(take)
    }

    /// 1 from the clock that writes the word of an address until it is taken over.
    pub fn is_new(self, address: u64, take: Bits) -> Bits {
        net! {
            let is_written = self.writes(address);
            let is_new = Bits::register(1);
        }
        is_new.load_when(take | is_written, is_written);
        is_new
    }
}
