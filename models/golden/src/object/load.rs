//! The load bus: an object's coefficient words as addresses and bits (`docs/architecture.md`, section 7).

use super::quadric::{PlaneWords, QuadricWords, ScreenBox};
use crate::format::{Format, wrap};
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

/// Address of the first word of plane 0.
pub const FIRST_PLANE: u8 = object::PLANES as u8;
/// Address of the columns of the screen box.
pub const BOX_COLUMNS: u8 = object::BOX_COLUMNS as u8;
/// Address of the control word.
pub const CONTROL: u8 = object::CONTROL as u8;
/// Words of one plane.
pub const PLANE_WORDS: u8 = object::PLANE_WORDS as u8;
/// Width of the kind of a plane.
pub const KIND_WIDTH: u32 = 2;

/// All words of an object for one zone, by ascending address; absent planes up to `planes` are written as kind none.
pub fn load_words(words: &QuadricWords, format: &Format, planes: usize) -> Vec<LoadWord> {
    let mut list = List(Vec::new());
    list.linear(&words.f1, format.pe1_width());
    list.quadratic(&words.f2, format.pe2_width());
    for g in &words.normal.g {
        list.linear(g, format.normal_linear);
    }
    for k in words.normal.k {
        list.push(k.into(), format.normal);
    }
    list.window(&words.screen_box);
    let control = words.class as i128 | i128::from(words.normal.shift) << 2;
    list.push(control, 7);
    let none = PlaneWords::default();
    for index in 0..planes {
        let plane = words.planes.get(index).unwrap_or(&none);
        list.push(plane.kind as i128, KIND_WIDTH);
        list.linear(&plane.depth, format.plane);
        for n in plane.normal {
            list.push(n.into(), format.normal);
        }
    }
    debug_assert_eq!(list.0.len(), object::words(planes));
    list.0
}

/// Words at ascending addresses from 0.
pub(super) struct List(pub(super) Vec<LoadWord>);

impl List {
    pub(super) fn push(&mut self, value: i128, width: u32) {
        let bits = wrap(value, width) as u64 & (u64::MAX >> (64 - width));
        self.0.push(LoadWord {
            address: self.0.len() as u8,
            bits,
            width,
        });
    }

    pub(super) fn linear(&mut self, words: &Linear, width: u32) {
        for value in [words.a, words.b, words.c] {
            self.push(value, width);
        }
    }

    pub(super) fn quadratic(&mut self, words: &Quadratic, width: u32) {
        let words = words.preconditioned(width);
        for value in [words.a2, words.b2, words.c, words.i0, words.p0, words.f] {
            self.push(value, width);
        }
    }

    pub(super) fn window(&mut self, window: &ScreenBox) {
        let window = if window.is_empty() {
            &ScreenBox::EMPTY
        } else {
            window
        };
        self.push((window.x0 | window.x1 << 12).into(), Format::BOX_WORD);
        self.push((window.y0 | window.y1 << 12).into(), Format::BOX_WORD);
    }
}
