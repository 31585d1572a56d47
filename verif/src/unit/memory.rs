//! The elementary processor with a coefficient memory.

use super::description::{Description, bit};
use crate::stimulus::word;
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::unit::interlaced::MemoryPe2;
use imogene_golden::unit::pe2::Quadratic;
use proptest::prelude::*;

/// Where the ports stand.
mod port {
    pub const LOAD: usize = 0;
    pub const ADDRESS: usize = 1;
    pub const DATA: usize = 2;
    pub const FIELD: usize = 3;
    pub const PICTURE: usize = 4;
    pub const ODD: usize = 5;
    pub const LINE: usize = 6;
    pub const PIXEL: usize = 7;
    pub const COUNT: usize = 8;
}

/// Words of the polynomial; the copies of the last three follow them.
const WORDS: usize = 6;

pub(super) fn memory_pe2(format: Format) -> Description {
    let width = format.quadratic;
    Description::new(pictures, move || {
        let mut golden = Clocked {
            width,
            words: [0; WORDS],
            pe: None,
            busy: 0,
        };
        move |i: &[i64]| golden.clock(i)
    })
}

/// The golden processor, whose commands take their clocks one by one.
struct Clocked {
    width: u32,
    words: [i128; WORDS],
    pe: Option<MemoryPe2>,
    busy: u64,
}

impl Clocked {
    fn clock(&mut self, i: &[i64]) -> Vec<Option<i64>> {
        let mut value = None;
        if self.busy > 0 {
            self.busy -= 1;
        } else {
            if bit(i[port::LOAD]) && i[port::ADDRESS] < WORDS as i64 {
                self.words[i[port::ADDRESS] as usize] = i[port::DATA].into();
            }
            value = self.obey(i);
        }
        vec![
            Some(i64::from(self.busy == 0)),
            Some(i64::from(value.is_some())),
            value,
        ]
    }

    fn obey(&mut self, i: &[i64]) -> Option<i64> {
        if bit(i[port::FIELD]) {
            // The memory is written by the loader before a picture, not between its two fields.
            let pe = match self.pe.take() {
                Some(pe) if pe.memory_words() > WORDS => pe,
                _ => MemoryPe2::interlaced(&self.polynomial(), self.width),
            };
            self.pe = Some(pe);
            self.run(|pe| pe.field_start(i[port::ODD] as u32));
        } else if bit(i[port::PICTURE]) {
            self.pe = Some(MemoryPe2::progressive(&self.polynomial(), self.width));
        } else if bit(i[port::LINE]) {
            self.run(MemoryPe2::line_start);
        } else if bit(i[port::PIXEL]) {
            return self.pe.as_mut().map(|pe| pe.pixel() as i64);
        }
        None
    }

    /// Runs a command and is busy for all of its clocks but this one.
    fn run(&mut self, command: impl FnOnce(&mut MemoryPe2)) {
        if let Some(pe) = &mut self.pe {
            let before = pe.clocks();
            command(pe);
            self.busy = pe.clocks() - before - 1;
        }
    }

    /// The polynomial of the words, which are those of the polynomial moved by (-1, -1).
    fn polynomial(&self) -> Quadratic {
        let [a2, b2, c, e_less_b, d_less_a, f] = self.words;
        let (a, b) = (a2 / 2, b2 / 2);
        Quadratic::new([a, b, c, d_less_a + a, e_less_b + b, f]).from_zone(1, 1)
    }
}

/// A command on a clock.
fn command(at: usize) -> Inputs {
    let mut inputs = vec![0; port::COUNT];
    inputs[at] = 1;
    inputs
}

/// A loaded picture: progressive, or its two fields in any order; the raster waits for `ready` and now and then a clock
/// longer.
fn pictures(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let words = proptest::collection::vec(word(&subject.inputs[port::DATA]), WORDS);
    let shape = (any::<[bool; 2]>(), 1usize..9, 1usize..4, 0usize..3);
    (words, shape)
        .prop_map(
            move |(words, ([interlaced, odd_first], width, height, pause))| {
                let mut list = load(&words);
                while list.len() < clocks {
                    if interlaced {
                        for field in [odd_first, !odd_first] {
                            let mut start = command(port::FIELD);
                            start[port::ODD] = field.into();
                            list.push(start);
                            wait(&mut list, 5 + pause);
                            let lines = if field { 27 } else { 15 };
                            draw(&mut list, [lines, 27], width, height, pause);
                        }
                    } else {
                        list.extend(load(&words));
                        list.push(command(port::PICTURE));
                        draw(&mut list, [15, 15], width, height, pause);
                    }
                }
                list
            },
        )
        .boxed()
}

fn load(words: &[i64]) -> Vec<Inputs> {
    let kept = [3, 4, 5];
    let all = (0..WORDS).chain(kept);
    all.enumerate()
        .map(|(address, word)| {
            let mut inputs = command(port::LOAD);
            inputs[port::ADDRESS] = address as i64;
            // Second differences are even: they are twice a coefficient.
            let mask = if word < 2 { !1 } else { !0 };
            inputs[port::DATA] = words[word] & mask;
            inputs
        })
        .collect()
}

fn wait(list: &mut Vec<Inputs>, clocks: usize) {
    list.extend(std::iter::repeat_n(vec![0; port::COUNT], clocks));
}

/// Lines of pixels; the first line takes another number of clocks than the others.
fn draw(list: &mut Vec<Inputs>, clocks: [usize; 2], width: usize, height: usize, pause: usize) {
    for line in 0..height {
        list.push(command(port::LINE));
        wait(list, clocks[line.min(1)] - 1 + pause);
        list.extend(std::iter::repeat_n(command(port::PIXEL), width));
    }
}
