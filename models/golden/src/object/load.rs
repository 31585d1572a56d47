//! The load bus: coefficient words as addresses and bits (`docs/architecture.md`, section 7).
//!
//! For each kind of words one function says in which order they stand, of how many bits each is, and what a bit means.
//! It sends them and it reads what was sent.

use super::quadric::{PlaneWords, QuadricWords, ScreenBox};
use crate::format::{Format, wrap};
use crate::unit::cut_plane::PlaneKind;
use crate::unit::depth_interval::Class;
use crate::unit::normal::NormalWords;
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use imogene_contract::object;
use serde::Serialize;

/// One word of the load bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct LoadWord {
    /// Address within the object.
    pub address: u8,
    /// Bits of the word, in the low end.
    pub bits: u64,
    /// Width of the word.
    pub width: u32,
}

/// Width of the kind of a plane.
pub const KIND_WIDTH: u32 = 2;
/// Bits of the shift of a root.
const SHIFT: u32 = 5;

/// All words of an object for one zone, by ascending address; absent planes up to `planes` are written as kind none.
pub fn load_words(words: &QuadricWords, format: &Format, planes: usize) -> Vec<LoadWord> {
    let mut words = words.clone();
    words.planes.resize(planes, PlaneWords::default());
    let mut bus = Bus::sending(format);
    bus.quadric(&mut words);
    debug_assert_eq!(bus.words.len(), object::words(planes));
    bus.words
}

/// Words at ascending addresses from 0. Each method takes the words that are sent and leaves those that were received.
pub(super) struct Bus<'a> {
    pub(super) format: &'a Format,
    /// What is received in the place of what is sent.
    received: Option<&'a [u64]>,
    /// What went over the bus.
    pub(super) words: Vec<LoadWord>,
}

impl<'a> Bus<'a> {
    pub(super) fn sending(format: &'a Format) -> Bus<'a> {
        Bus {
            format,
            received: None,
            words: vec![],
        }
    }

    /// A word for each address.
    pub(super) fn receiving(format: &'a Format, words: &'a [u64]) -> Bus<'a> {
        Bus {
            received: Some(words),
            ..Bus::sending(format)
        }
    }

    /// A word without a sign.
    pub(super) fn bits(&mut self, value: i128, width: u32) -> u64 {
        let address = self.words.len();
        let received = self.received.map(|words| words[address]);
        let word = received.unwrap_or(wrap(value, width) as u64);
        let bits = word & (u64::MAX >> (64 - width));
        self.words.push(LoadWord {
            address: address as u8,
            bits,
            width,
        });
        bits
    }

    /// A word in two's complement.
    pub(super) fn number(&mut self, value: i128, width: u32) -> i128 {
        wrap(self.bits(value, width).into(), width)
    }

    pub(super) fn flag(&mut self, flag: &mut bool) {
        *flag = self.bits((*flag).into(), 1) == 1;
    }

    pub(super) fn vector(&mut self, parts: &mut [i16; 3]) {
        *parts = parts.map(|part| self.number(part.into(), self.format.normal) as i16);
    }

    pub(super) fn linear(&mut self, words: &mut Linear, width: u32) {
        let [a, b, c] = [words.a, words.b, words.c].map(|word| self.number(word, width));
        *words = Linear::new(a, b, c);
    }

    pub(super) fn quadratic(&mut self, words: &mut Quadratic, width: u32) {
        let sent = words.preconditioned(width);
        *words = Quadratic::of_preconditioned(&sent.map(|word| self.number(word, width)));
    }

    /// Words of planes or sides of first degree.
    pub(super) fn planes_of<'b>(&mut self, words: impl IntoIterator<Item = &'b mut Linear>) {
        (words.into_iter()).for_each(|word| self.linear(word, self.format.plane));
    }

    /// Expressions of second degree without guard bits.
    pub(super) fn conics<'b>(&mut self, words: impl IntoIterator<Item = &'b mut Quadratic>) {
        (words.into_iter()).for_each(|word| self.quadratic(word, self.format.quadratic));
    }

    /// Parts of a normal of first degree.
    pub(super) fn gradients(&mut self, words: &mut [Linear]) {
        (words.iter_mut()).for_each(|word| self.linear(word, self.format.normal_linear));
    }

    pub(super) fn window(&mut self, window: &mut ScreenBox) {
        let ScreenBox { x0, x1, y0, y1 } = window.or_empty();
        let mut side = |first: i64, last: i64| {
            let word = self.bits((first | last << 12).into(), Format::BOX_WORD);
            [word & 0xfff, word >> 12].map(|end| end as i64)
        };
        *window = ScreenBox::of(side(x0, x1), side(y0, y1));
    }

    pub(super) fn plane(&mut self, kind: &mut PlaneKind, depth: &mut Linear) {
        *kind = PlaneKind::ALL[self.bits(*kind as i128, KIND_WIDTH) as usize];
        self.linear(depth, self.format.plane);
    }

    /// Planes with their normals.
    pub(super) fn planes(&mut self, planes: &mut [PlaneWords]) {
        for plane in planes {
            self.plane(&mut plane.kind, &mut plane.depth);
            self.vector(&mut plane.normal);
        }
    }

    pub(super) fn depths(&mut self, f1: &mut Linear, f2: &mut Quadratic) {
        self.linear(f1, self.format.pe1_width());
        self.quadratic(f2, self.format.pe2_width());
    }

    pub(super) fn normal(&mut self, normal: &mut NormalWords) {
        self.gradients(&mut normal.g);
        self.vector(&mut normal.k);
        normal.shift = self.bits(normal.shift.into(), SHIFT) as u8;
    }

    pub(super) fn quadric(&mut self, words: &mut QuadricWords) {
        self.depths(&mut words.f1, &mut words.f2);
        self.gradients(&mut words.normal.g);
        self.vector(&mut words.normal.k);
        self.window(&mut words.screen_box);
        let control = words.class as i128 | i128::from(words.normal.shift) << 2;
        let control = self.bits(control, 2 + SHIFT);
        words.class = class(control);
        words.normal.shift = (control >> 2) as u8;
        self.planes(&mut words.planes);
    }
}

/// In the lowest bits of a control word.
pub(super) fn class(control: u64) -> Class {
    Class::ALL[(control & 3) as usize]
}
