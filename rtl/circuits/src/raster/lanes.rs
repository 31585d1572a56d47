//! Several pixels of a line at once: what runs from line to line is there once, what runs along a line in each lane.

use super::pe1::line_begin as pe1_line_begin;
use super::pe2::line_begin as pe2_line_begin;
use super::{Flags, HELD, Linear, Pixel, Quadratic, Scan};
use imogene_hdl::{Bits, Int, Value, module, net};

pub use imogene_contract::words::LANES_LATENCY;

/// Clocks by which the flags of the lanes are late: none where there is one.
pub fn lanes_latency(lanes: u32) -> u32 {
    if lanes > 1 { LANES_LATENCY } else { 0 }
}

/// The flags and places of each lane from those of the raster [`lanes_latency`] clocks late, which counts groups of
/// pixels along a line: lane j has pixel j of every group, and every line of it begins as a zone does.
pub fn lane_scans(late: Scan, lanes: u32) -> Vec<Scan> {
    if lanes == 1 {
        return vec![late];
    }
    let flags = Flags {
        valid: late.flags.valid,
        start: late.flags.first(),
        line: None,
    };
    let lane = |lane: u32| Scan {
        flags,
        pixel: lane_pixel(late.pixel, lane, lanes),
    };
    (0..lanes).map(lane).collect()
}

/// Pixel `lane` of a group of pixels of a line.
pub fn lane_pixel(group: Pixel, lane: u32, lanes: u32) -> Pixel {
    if lanes == 1 {
        return group;
    }
    let first = group.x.left(lanes.ilog2());
    Pixel {
        x: first | Bits::new(lane.into(), first.width()),
        ..group
    }
}

/// Words that lanes of a line are given in the place of those of a zone: they change from line to line.
///
/// Those of a line come with the flags of its lanes, and stay as long as the line is: no processor of a lane may begin
/// later than that.
pub trait Laned: Clone {
    /// The words of each of so many lanes, from the flags of the raster.
    fn laned(&self, at: &str, flags: Flags, lanes: u32) -> Vec<Self>;
}

/// Lets these fields of bundles be those of the lanes.
macro_rules! laned {
    ($($group:ident $(<$kind:ident>)? { $($field:ident)* })*) => {$(
        impl $(<$kind: $crate::raster::Laned>)? $crate::raster::Laned for $group $(<$kind>)? {
            fn laned(&self, at: &str, flags: $crate::raster::Flags, lanes: u32) -> Vec<Self> {
                let mut all = vec![self.clone(); lanes as usize];
                $(
                    let name = format!("{at}_{}", stringify!($field));
                    let own = $crate::raster::Laned::laned(&self.$field, &name, flags, lanes);
                    all.iter_mut().zip(own).for_each(|(lane, own)| lane.$field = own);
                )*
                all
            }
        }
    )*};
}

pub(crate) use laned;

impl<L: Laned> Laned for Vec<L> {
    fn laned(&self, at: &str, flags: Flags, lanes: u32) -> Vec<Self> {
        let mut all = vec![vec![]; lanes as usize];
        for (index, one) in self.iter().enumerate() {
            let own = one.laned(&format!("{at}_{index}"), flags, lanes);
            let lanes = all.iter_mut().zip(own);
            lanes.for_each(|(lane, own)| lane.push(own));
        }
        all
    }
}

impl<L: Laned, const N: usize> Laned for [L; N] {
    fn laned(&self, at: &str, flags: Flags, lanes: u32) -> Vec<Self> {
        let all = self.to_vec().laned(at, flags, lanes);
        let lane = |own: Vec<L>| own.try_into().ok().expect("as many as before");
        all.into_iter().map(lane).collect()
    }
}

impl Laned for Linear {
    fn laned(&self, at: &str, flags: Flags, lanes: u32) -> Vec<Linear> {
        let begins = pe1_lines(at, flags, *self, lanes);
        let unread = Int::new(0, self.c.width());
        let a = times(self.a, lanes.into());
        let lane = |c| Linear { a, b: unread, c };
        begins.into_iter().map(lane).collect()
    }
}

impl Laned for Quadratic {
    fn laned(&self, at: &str, flags: Flags, lanes: u32) -> Vec<Quadratic> {
        let (begins, steps) = pe2_lines(at, flags, *self, lanes);
        let unread = Int::new(0, self.f.width());
        let lane = |(f, p0)| Quadratic {
            a2: times(self.a2, (lanes * lanes).into()),
            b2: unread,
            c: unread,
            i0: unread,
            p0,
            f,
        };
        begins.into_iter().zip(steps).map(lane).collect()
    }
}

/// A number by a small constant that is not zero, modulo its width.
fn times(value: Int, constant: u64) -> Int {
    let places = (0..u64::BITS).filter(|place| constant >> place & 1 == 1);
    let places = places.map(|place| value.bits().left(place).int());
    places
        .reduce(|a, b| a + b)
        .expect("a constant that is not zero")
}

/// A number, and another one by a small constant: one clock later, and so is that product before the sum.
fn plus(value: Int, constant: u64, other: Int) -> Int {
    match constant {
        0 => value.reg(),
        _ => (value + times(other, constant).reg()).reg(),
    }
}

/// What each lane of a line of `a x + b y + c` begins with.
fn pe1_lines(at: &str, flags: Flags, words: Linear, lanes: u32) -> Vec<Int> {
    let inputs = (flags, ("", words, HELD));
    module("pe1_lines", at, inputs, |(flags, words)| {
        net! {
            let first = flags.first();
            let line_value = pe1_line_begin(flags, first, words).reg_when(flags.valid & first);
        }
        let begin = |lane: u64| plus(line_value, lane, words.a);
        let begins: Vec<Int> = (0..lanes.into()).map(begin).collect();
        ("lane", begins, "value at the first pixel of lane #")
    })
}

/// What each lane of a line of a polynomial of second degree begins with, and its first increments.
fn pe2_lines(at: &str, flags: Flags, words: Quadratic, lanes: u32) -> (Vec<Int>, Vec<Int>) {
    let inputs = (flags, ("", words, HELD));
    module("pe2_lines", at, inputs, |(flags, words)| {
        net! {
            let first = flags.first();
            let begins = flags.valid & first;
        }
        let (line_begin, first_step) = pe2_line_begin(flags, first, words);
        net! {
            let line_value = line_begin.reg_when(begins);
            let pixel_step = first_step.reg_when(begins);
        }
        let count = u64::from(lanes);
        // To pixel j of a line there are j steps, each 2a more than the one before.
        let more = |steps: u64| steps * steps.saturating_sub(1) / 2;
        let begin = |lane: u64| plus(plus(line_value, more(lane), words.a2), lane, pixel_step);
        let step = |lane: u64| {
            let steps = times(pixel_step, count);
            plus(steps, count * lane + more(count), words.a2)
        };
        let begins: Vec<Int> = (0..count).map(begin).collect();
        let steps: Vec<Int> = (0..count).map(step).collect();
        let begins = ("lane", begins, "value at the first pixel of lane #");
        let next = "increment from the first pixel of lane # to its next";
        (begins, ("step", steps, next))
    })
}
