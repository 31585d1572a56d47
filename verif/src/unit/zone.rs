//! What all object processors have in common: words held over a zone, a golden processor that runs over it, results a
//! fixed time later.

use super::description::{Description, behind_valid, late, scan};
use crate::signal::Delay;
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::{PlaneWords, QuadricWords};
use imogene_golden::object::screen_box::ScreenBox;
use imogene_golden::object::words::Running;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::normal::NormalWords;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use proptest::prelude::*;

/// Ports before the first word: the flags, then the column and the line.
pub(super) const WORDS: usize = 5;

/// A processor with `N` outputs behind `out_valid`, `latency` clocks after the flags. `words` reads those of a zone
/// from the ports; `pixel` gives the outputs of its next pixel, from what the ports show `entry` clocks after the
/// flags.
pub(super) fn zone<W: Clone + Send + 'static, const N: usize>(
    stimulus: impl Fn(&Subject, usize) -> BoxedStrategy<Vec<Inputs>> + Sync + 'static,
    format: Format,
    [entry, latency]: [u32; 2],
    words: impl Fn(&[i64]) -> W + Clone + Send + Sync + 'static,
    pixel: fn(&mut Running<W>, &[i64]) -> [i64; N],
) -> Description {
    Description::new(stimulus, move || {
        let words = words.clone();
        let mut entered = Delay::new(entry as usize);
        let mut late = late((latency - entry) as usize);
        let mut zone = None;
        move |i: &[i64]| {
            let Some(raster) = entered.push([i[0], i[1], i[2], i[3], i[4]]) else {
                return behind_valid::<N>(None);
            };
            let [flags @ .., x, y] = raster;
            let start = || Running::zone_start(&words(&at_origin(i, [x, y])), &format);
            let seen = scan(&mut zone, &flags, start, Running::line_step);
            behind_valid(late.push(seen.map(|processor| pixel(processor, i))))
        }
    })
}

/// The ports with the origin of their zone for column and line.
fn at_origin(i: &[i64], [x, y]: [i64; 2]) -> Vec<i64> {
    [&i[..3], &[x, y], &i[WORDS..]].concat()
}

/// Reads the ports of a processor one after the other.
pub(super) struct Reader<'a> {
    words: &'a [i64],
    /// Column and line of the first pixel of the zone.
    origin: [i64; 2],
}

impl<'a> Reader<'a> {
    /// From the first of these on.
    pub fn of(words: &'a [i64]) -> Reader<'a> {
        Reader {
            words,
            origin: [0; 2],
        }
    }

    /// From the first word behind the raster's ports on.
    pub fn new(inputs: &'a [i64]) -> Reader<'a> {
        Reader {
            words: &inputs[WORDS..],
            origin: [inputs[3], inputs[4]],
        }
    }

    pub fn word(&mut self) -> i64 {
        let (first, rest) = self.words.split_first().expect("a port for each word");
        self.words = rest;
        *first
    }

    pub fn linear(&mut self) -> Linear {
        let [a, b, c] = [(); 3].map(|()| i128::from(self.word()));
        Linear::new(a, b, c)
    }

    /// The coefficients whose preconditioned words these are, modulo the width. `a2 = 2a` and `b2 = 2b` have no unique
    /// half modulo 2^n, but the halves may be taken in one bit more.
    pub fn quadratic(&mut self) -> Quadratic {
        let [a2, b2, c, i0, p0, f] = [(); 6].map(|()| i128::from(self.word()));
        let (a, b) = (a2 / 2, b2 / 2);
        let (d, e) = (p0 - a, i0 - b);
        Quadratic { a, b, c, d, e, f }
    }

    pub fn screen_box(&mut self) -> ScreenBox {
        let [x, y] = self.origin;
        let [x0, x1] = [(); 2].map(|()| self.word() - x);
        let [y0, y1] = [(); 2].map(|()| self.word() - y);
        ScreenBox { x0, x1, y0, y1 }
    }

    pub fn vector(&mut self) -> [i16; 3] {
        [(); 3].map(|()| self.word() as i16)
    }

    pub fn kind(&mut self) -> PlaneKind {
        plane_kind(self.word())
    }

    pub fn class(&mut self) -> Class {
        class(self.word())
    }

    /// Planes, with their normals or without.
    pub fn planes(&mut self, count: usize, with_normals: bool) -> Vec<PlaneWords> {
        let plane = |_| PlaneWords {
            kind: self.kind(),
            depth: self.linear(),
            normal: match with_normals {
                true => self.vector(),
                false => [0; 3],
            },
        };
        (0..count).map(plane).collect()
    }

    /// The words of the normal unit but for its shift.
    pub fn normal(&mut self) -> NormalWords {
        NormalWords {
            g: [(); 3].map(|()| self.linear()),
            k: self.vector(),
            shift: 0,
        }
    }

    /// f1, f2, the normal, the screen box and the shift, in this order, without class and planes.
    pub fn quadric(&mut self) -> QuadricWords {
        let mut words = QuadricWords {
            class: Class::Side,
            f1: self.linear(),
            f2: self.quadratic(),
            normal: self.normal(),
            screen_box: self.screen_box(),
            planes: vec![],
        };
        words.normal.shift = self.word() as u8;
        words
    }

    /// All words of a quadric processor.
    pub fn quadric_processor(&mut self, planes: usize) -> QuadricWords {
        let mut words = self.quadric();
        words.class = self.class();
        words.planes = self.planes(planes, true);
        words
    }
}

/// How an object lies, by its word.
pub(super) fn class(word: i64) -> Class {
    [Class::Side, Class::Front, Class::Patch, Class::Prism][word as usize]
}

/// How a plane lies, by its word.
pub(super) fn plane_kind(word: i64) -> PlaneKind {
    use PlaneKind::{Back, Front, None, Perpendicular};
    [None, Front, Back, Perpendicular][word as usize]
}
