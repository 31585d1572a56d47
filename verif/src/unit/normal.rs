//! The normal unit.

use super::description::{Description, bit, late, scan, stated};
use super::zone::Reader;
use crate::stimulus::{flags, word};
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::unit::normal::select;
use imogene_golden::unit::pe1::Pe1;
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
    Description::new(words_held, move || {
        let mut g = None;
        let mut late = late(3);
        move |i: &[i64]| stated(late.push(normal(&mut g, i, planes)).flatten())
    })
}

/// The normal of a clock with a pixel.
fn normal(g: &mut Option<[Pe1; 3]>, i: &[i64], planes: usize) -> Option<[i64; 3]> {
    let mut words = Reader::of(&i[port::WORDS..]).normal();
    words.shift = i[port::SHIFT] as u8;
    let start = || words.g.map(|g| Pe1::object_start(&g, 24));
    let g = scan(g, i, start, |g| g.iter_mut().for_each(Pe1::line_step))?;
    let linear = g.each_mut().map(|pe| pe.pixel() as i64);
    let mut constants = Reader::of(&i[port::PLANES..]);
    let constants: Vec<[i16; 3]> = (0..planes).map(|_| constants.vector()).collect();
    let (number, present) = (i[port::NUMBER] as u8, !bit(i[port::ABSENT]));
    let (root, format) = (i[port::ROOT], &Format::BASE);
    let found = select(number, present, linear, root, &words, &constants, format);
    Some(found.map(i64::from))
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
