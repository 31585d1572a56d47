//! What runs along the lines of a zone: flags, and the elementary processors that add up polynomials.

mod lanes;
mod memory_pe2;
mod pe1;
mod pe2;
mod programmable_pe;
mod steps;

pub(crate) use lanes::laned;
pub use lanes::{LANES_LATENCY, Laned, lane_pixel, lane_scans, lanes_latency};
pub use memory_pe2::{Commands, LoadWord, Stepped, memory_pe2};
pub use pe1::pe1;
pub use pe2::pe2;
pub use programmable_pe::{Program, Programmed, SplitWords, programmable_pe};
pub use steps::{SecondSteps, Steps};

use crate::rows::alike;
pub(crate) use imogene_contract::words::COORDINATE;
use imogene_hdl::{Bits, Value, bundles};

/// Meaning of the words of a polynomial.
pub(crate) const HELD: &str = "unchanged from start to the last pixel of the zone";

bundles! {
    /// Raster flags.
    #[derive(Copy)]
    Flags {
        valid: Bits as "valid", "this clock carries a pixel; without it no state of the elementary processors changes";
        start: Bits as "start", "first pixel of the zone; counts under valid";
        line: Option<Bits> as "line", "first pixel of any other line; counts under valid";
    }
}

impl Flags {
    /// Flags from outside of the design.
    pub fn input() -> Flags {
        Flags {
            valid: Bits::input(1),
            start: Bits::input(1),
            line: Some(Bits::input(1)),
        }
    }

    /// 1 with the first pixel of any line. In a lane every line begins as a zone does, and no other one is told.
    pub(crate) fn first(&self) -> Bits {
        self.line.map_or(self.start, |line| self.start | line)
    }
}

alike! {
    /// A place on the screen or in a zone.
    Pixel(): [Bits(COORDINATE); 2] {
        x, "column";
        y, "line";
    }

    /// Words of `a x + b y + c`.
    Linear(width): [Int(width); 3] {
        a, "increment from pixel to pixel";
        b, "increment from line to line";
        c, "value at the first pixel";
    }

    /// Preconditioned words of a polynomial of second degree (section B.2.1).
    Quadratic(width): [Int(width); 6] {
        a2, "2a of a x^2 + b y^2 + c xy + d x + e y + f";
        b2, "2b";
        c, "c";
        i0, "e + b, the first increment from line to line";
        p0, "d + a, the first increment from pixel to pixel";
        f, "f, the value at the first pixel";
    }
}

bundles! {
    /// A pixel on its way through a zone.
    #[derive(Copy)]
    Scan() {
        /// What begins with it.
        flags: Flags() as "";
        pixel: Pixel() as "", "pixel of the zone, counted from 0";
    }
}
