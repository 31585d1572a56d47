//! The normal unit.

use super::description::{Description, bit, late, scan, stated};
use super::words::{Ports, read};
use crate::stimulus::{flags, hold, mapped, word};
use crate::subject::{Inputs, Stimuli, Subject};
use imogene_golden::format::Format;
use imogene_golden::unit::normal::select;
use imogene_golden::unit::pe1::Pe1;
use proptest::prelude::*;

/// The bits of `g` below those of a component.
const LOW: i64 = (1 << Format::NORMAL_FRACTION) - 1;

/// Clocks from the flags of a zone to its words of g.
const WORDS_LATER: usize = 2;

/// Where the ports begin, in their order.
mod port {
    pub const NUMBER: usize = 3;
    pub const ABSENT: usize = 4;
    pub const ROOT: usize = 5;
    pub const WORDS: usize = 6;
    pub const FACTORS: usize = 15;
    pub const PLANES: usize = 18;
}

pub(super) fn normal_unit(planes: usize) -> Description {
    Description::new(words_held, move || {
        let mut g = None;
        let mut late = late(4);
        move |i: &[i64]| stated(late.push(normal(&mut g, i, planes)).flatten())
    })
}

/// The normal of a clock with a pixel.
fn normal(g: &mut Option<[Pe1; 3]>, i: &[i64], planes: usize) -> Option<[i64; 3]> {
    let format = &Format::BASE;
    let words = read(&i[port::WORDS..], format, Ports::normal);
    let start = || words.g.map(|g| Pe1::object_start(&g, 24));
    let g = scan(g, i, start, |g| g.iter_mut().for_each(Pe1::line_step))?;
    let linear = g.each_mut().map(|pe| pe.pixel() as i64);
    let planes = i[port::PLANES..].chunks(3).take(planes);
    let vector = |normal: &[i64]| read(normal, format, Ports::vector);
    let constants: Vec<_> = planes.map(vector).collect();
    let (number, present) = (i[port::NUMBER] as u8, !bit(i[port::ABSENT]));
    let root = i[port::ROOT];
    let found = select(number, present, linear, root, &words, &constants, format);
    Some(found.map(i64::from))
}

/// A bit of a word, often a low one.
fn low_bit(width: u32) -> impl Strategy<Value = u32> {
    prop_oneof![1 => 0..width, 2 => 0..3u32]
}

/// Numbers and roots change every clock; words are held, those of the `g` until they have started anew.
///
/// Half of the stimuli have words where a product decides by its lowest bit: factors and roots of one bit, and a `g`
/// whose low bits are those of `c` alone, often all of them 0 or 1.
fn words_held(subject: &Subject, clocks: usize) -> Stimuli {
    let held: Vec<_> = subject.inputs[port::WORDS..].iter().map(word).collect();
    let linear = &subject.inputs[port::WORDS..port::FACTORS];
    let linear: Vec<_> = linear.iter().map(word).collect();
    let root = &subject.inputs[port::ROOT];
    let power = low_bit(root.width).prop_map(|bit| 1i64 << bit);
    let moving = (
        flags(),
        prop_oneof![0i64..16, 0i64..2],
        prop_oneof![4 => Just(0i64), 1 => Just(1)],
        prop_oneof![word(root), power],
        linear,
        prop_oneof![Just(0), Just(LOW), 0..=LOW],
    );
    let width = subject.inputs[port::FACTORS].width;
    let factor = (low_bit(width - 1), any::<bool>());
    let factor = factor.prop_map(|(bit, negate)| if negate { -(1i64 << bit) } else { 1 << bit });
    let factor = factor.boxed();
    let exact = proptest::option::of([factor.clone(), factor.clone(), factor]);
    mapped(
        (held, exact, proptest::collection::vec(moving, clocks)),
        |(mut held, exact, list)| {
            if let Some(factors) = exact {
                held[port::FACTORS - port::WORDS..][..3].copy_from_slice(&factors);
            }
            let clock = |(flags, number, absent, root, mut linear, low)| {
                let (flags, linear): ([i64; 3], &mut Vec<i64>) = (flags, &mut linear);
                if exact.is_some() {
                    linear.iter_mut().for_each(|word| *word &= !LOW);
                    let c = linear.iter_mut().skip(2).step_by(3);
                    c.for_each(|word| *word |= low);
                }
                let words = [&linear[..], &held[port::FACTORS - port::WORDS..]].concat();
                [&flags[..], &[number, absent, root], &words].concat()
            };
            let mut list: Vec<Inputs> = list.into_iter().map(clock).collect();
            list[0][..3].copy_from_slice(&[1, 1, 0]);
            hold(&mut list, port::WORDS..port::FACTORS, WORDS_LATER + 1);
            list
        },
    )
}
