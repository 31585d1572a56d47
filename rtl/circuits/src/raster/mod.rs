//! What runs along the lines of a zone: flags, and the elementary processors that add up polynomials.

mod memory_pe2;
mod pe1;
mod pe2;
mod programmable_pe;

pub use memory_pe2::{Commands, LoadWord, Stepped, memory_pe2};
pub use pe1::pe1;
pub use pe2::pe2;
pub use programmable_pe::{Program, Programmed, programmable_pe};

use imogene_contract::words::COORDINATE;
use imogene_hdl::bundle;

bundle! {
    /// Raster flags.
    Flags() {
        valid: Bits(1), "this clock carries a pixel";
        start: Bits(1), "first pixel of the zone";
        line: Bits(1), "first pixel of a later line";
    }

    /// A place on the screen or in a zone.
    Pixel() {
        x: Bits(COORDINATE as u32), "column";
        y: Bits(COORDINATE as u32), "line";
    }

    /// Words of `a x + b y + c`.
    Linear(width) {
        a: Int(width), "increment along the line";
        b: Int(width), "increment from line to line";
        c: Int(width), "value of the first pixel";
    }

    /// Preconditioned words of a polynomial of second degree (section B.2.1).
    Quadratic(width) {
        a2: Int(width), "second difference along the line";
        b2: Int(width), "second difference from line to line";
        c: Int(width), "mixed difference";
        i0: Int(width), "increment from the first line to the second";
        p0: Int(width), "increment from the first pixel to the second";
        f: Int(width), "value of the first pixel";
    }
}
