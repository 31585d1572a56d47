//! The normal unit.

use super::Description;
use super::{Late, bit};
use crate::stimulus::{flags, word};
use crate::subject::{GoldenFn, Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::unit::normal::{NormalWords, select};
use imogene_golden::unit::pe1::{Linear, Pe1};
use proptest::prelude::*;

/// Where the ports begin, in their order.
mod port {
    pub const NUMBER: usize = 3;
    pub const ABSENT: usize = 4;
    pub const ROOT: usize = 5;
    pub const SHIFT: usize = 6;
    pub const WORDS: usize = 7;
    pub const PLANES: usize = 19;
}

pub(super) fn normal_unit(planes: usize) -> Description {
    Description {
        golden: Box::new(move || {
            let mut g: Option<[Pe1; 3]> = None;
            let mut late = Late::new(3);
            Box::new(GoldenFn(move |i: &[i64]| {
                let result = golden_clock(&mut g, i, planes);
                match late.push(result).flatten() {
                    Some(normal) => normal.map(|v| Some(i64::from(v))).to_vec(),
                    None => vec![None; 3],
                }
            }))
        }),
        stimulus: words_held,
    }
}

/// The normal of a clock with a pixel.
fn golden_clock(g: &mut Option<[Pe1; 3]>, i: &[i64], planes: usize) -> Option<[i16; 3]> {
    if !bit(i[0]) {
        return None;
    }
    let words = normal_words(&i[port::WORDS..], i[port::SHIFT]);
    if bit(i[1]) {
        *g = Some(words.g.map(|g| Pe1::object_start(&g, 24)));
    } else if bit(i[2]) {
        g.as_mut()?.iter_mut().for_each(Pe1::line_step);
    }
    let linear = g.as_mut()?.each_mut().map(|pe| pe.pixel() as i64);
    let constants: Vec<[i16; 3]> = (0..planes)
        .map(|p| std::array::from_fn(|k| i[port::PLANES + 3 * p + k] as i16))
        .collect();
    Some(select(
        i[port::NUMBER] as u8,
        !bit(i[port::ABSENT]),
        linear,
        i[port::ROOT],
        &words,
        &constants,
        &Format::BASE,
    ))
}

/// The words of twelve consecutive ports.
pub(super) fn normal_words(i: &[i64], shift: i64) -> NormalWords {
    let linear = |k: usize| Linear::new(i[3 * k].into(), i[3 * k + 1].into(), i[3 * k + 2].into());
    NormalWords {
        g: [linear(0), linear(1), linear(2)],
        k: [9, 10, 11].map(|k| i[k] as i16),
        shift: shift as u8,
    }
}

/// Coefficients are read over several clocks, so they are held; numbers and roots change every clock.
fn words_held(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let held: Vec<_> = subject.inputs[port::SHIFT..].iter().map(word).collect();
    let moving = (
        flags(),
        0i64..16,
        prop_oneof![4 => Just(0i64), 1 => Just(1)],
        word(&subject.inputs[port::ROOT]),
    );
    (held, proptest::collection::vec(moving, clocks))
        .prop_map(|(held, list)| {
            let clock = |(flags, number, absent, root): ([i64; 3], i64, i64, i64)| {
                flags
                    .into_iter()
                    .chain([number, absent, root])
                    .chain(held.iter().copied())
                    .collect::<Inputs>()
            };
            let mut list: Vec<Inputs> = list.into_iter().map(clock).collect();
            list[0][..3].copy_from_slice(&[1, 1, 0]);
            list
        })
        .boxed()
}
