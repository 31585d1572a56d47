//! The elementary processors: PE1, PE2, the programmable one and the one with a coefficient memory.

use super::description::{Description, bit, last_pixel, zones};
use super::words::{Ports, read};
use crate::stimulus::{each, mapped, raster, word};
use crate::subject::{Inputs, Stimuli, Subject};
use imogene_golden::format::Format;
use imogene_golden::unit::interlaced::MemoryPe2;
use imogene_golden::unit::pe1::Pe1;
use imogene_golden::unit::pe2::{Pe2, PreconditionedWords, Quadratic};
use imogene_golden::unit::programmable::{Programmable, ProgrammableWords};
use proptest::prelude::*;

pub(super) fn pe1(format: Format) -> Description {
    Description::new(zones, move || {
        let words = move |i: &[i64]| read(&i[3..], &format, Ports::line);
        let start = move |i: &[i64]| Pe1::object_start(&words(i), format.sum);
        let mut last = last_pixel(start, Pe1::line_step, |pe| pe.pixel() as i64);
        move |i: &[i64]| vec![last(i)]
    })
}

pub(super) fn pe2(format: Format) -> Description {
    // Second differences are even: they are twice a coefficient.
    let stimulus = |subject: &_, clocks| {
        mapped(zones(subject, clocks), |mut list| {
            for inputs in &mut list {
                inputs[3] &= !1;
                inputs[4] &= !1;
            }
            list
        })
    };
    Description::new(stimulus, move || {
        let words = move |i: &[i64]| read(&i[3..], &format, Ports::quadratic);
        let start = move |i: &[i64]| Pe2::object_start(&words(i), format.quadratic);
        let mut last = last_pixel(start, Pe2::line_step, |pe| pe.pixel() as i64);
        move |i: &[i64]| vec![last(i)]
    })
}

pub(super) fn programmable_pe(format: Format) -> Description {
    Description::new(raster, move || {
        let mut pe: Option<Programmable> = None;
        let mut inside = None;
        move |i: &[i64]| {
            if bit(i[0]) {
                match &mut pe {
                    _ if bit(i[1]) => {
                        pe = Some(Programmable::start(&words_of(i), format.depth));
                    }
                    Some(pe) if bit(i[2]) => pe.next_line(),
                    Some(pe) => pe.next_pixel(),
                    None => {}
                }
            }
            // The decision is a clock behind the values.
            let Some(pe) = &pe else { return vec![None; 6] };
            let pixel = pe.pixel();
            let mut values = vec![Some(pixel.value as i64)];
            values.extend(pixel.lanes.map(|lane| Some(lane as i64)));
            values.push(inside.replace(i64::from(pixel.inside)));
            values
        }
    })
}

fn words_of(i: &[i64]) -> ProgrammableWords {
    let [a2, b2, c, i0, p0, f] = [5, 6, 7, 8, 9, 10].map(|k| i128::from(i[k]));
    ProgrammableWords {
        split: bit(i[3]),
        words: PreconditionedWords {
            a2,
            b2,
            c,
            i0,
            p0,
            f,
        },
        used: [0, 1, 2, 3].map(|lane| i[4] >> lane & 1 == 1),
    }
}

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
    Description::new(pictures, move || {
        let mut golden = Clocked {
            width: format.quadratic,
            ..Clocked::default()
        };
        move |i: &[i64]| golden.clock(i)
    })
}

/// The golden processor, whose commands take their clocks one by one.
#[derive(Default)]
struct Clocked {
    width: u32,
    words: [i128; WORDS],
    pe: Option<MemoryPe2>,
    /// Were words loaded since? Pixels go on as they were, until a field or a picture begins.
    is_old: bool,
    /// Did a line begin? What the registers hold before is not stated.
    is_known: bool,
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
                self.is_old = true;
            }
            value = self.obey(i);
        }
        let flag = |flag: bool| Some(i64::from(flag));
        vec![flag(self.busy == 0), flag(value.is_some()), value.flatten()]
    }

    /// Is there a pixel, and what is stated of it?
    fn obey(&mut self, i: &[i64]) -> Option<Option<i64>> {
        if bit(i[port::FIELD]) {
            let is_second = |pe: &MemoryPe2| !self.is_old && pe.memory_words() > WORDS;
            if !self.pe.as_ref().is_some_and(is_second) {
                self.begin(MemoryPe2::interlaced);
            }
            self.run(|pe| pe.field_start(i[port::ODD] as u32));
        } else if bit(i[port::PICTURE]) {
            self.begin(MemoryPe2::progressive);
        } else if bit(i[port::LINE]) {
            self.run(MemoryPe2::line_start);
            self.is_known = self.pe.is_some() && !self.is_old;
        } else if bit(i[port::PIXEL]) {
            let value = self.pe.as_mut().map(|pe| pe.pixel() as i64);
            return Some(value.filter(|_| self.is_known));
        }
        None
    }

    /// Draws the words that are loaded.
    fn begin(&mut self, of: fn(&Quadratic, u32) -> MemoryPe2) {
        self.pe = Some(of(&self.polynomial(), self.width));
        (self.is_old, self.is_known) = (false, false);
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

fn command(at: usize) -> Inputs {
    let mut inputs = vec![0; port::COUNT];
    inputs[at] = 1;
    inputs
}

/// A picture: its words; whether it has two fields, and whether the odd one is first, its columns and lines, and clocks
/// of rest after a command that takes time; pixels between the start of a field and its first line, where they are two
/// one beside each word too, and by how much the order of the words is turned when they are loaded.
type Picture = (Vec<i64>, ([bool; 2], usize, usize, usize), (usize, usize));

/// Loaded pictures; the raster waits for `ready`, or a clock longer. A busy processor is asked for anything.
fn pictures(subject: &Subject, clocks: usize) -> Stimuli {
    let words = proptest::collection::vec(word(&subject.inputs[port::DATA]), WORDS);
    let shape = (any::<[bool; 2]>(), 1usize..9, 1usize..4, 0usize..3);
    let odd = (0usize..3, 0usize..9);
    let noise = each(subject.inputs.iter().map(word).collect(), clocks);
    // A picture takes thirty clocks at least.
    let pictures = proptest::collection::vec((words, shape, odd), clocks / 30 + 1);
    mapped((pictures, noise), move |(pictures, noise)| {
        let mut drawn = Drawn(vec![]);
        (pictures.into_iter()).for_each(|picture| drawn.picture(picture));
        let each = drawn.0.into_iter().zip(noise);
        each.map(|((inputs, is_busy), noise)| if is_busy { noise } else { inputs })
            .collect()
    })
}

/// The clocks of pictures, and whether the processor is busy.
struct Drawn(Vec<(Inputs, bool)>);

impl Drawn {
    fn picture(&mut self, (words, (kind, width, height, pause), (early, turn)): Picture) {
        let kept = [3, 4, 5];
        let all = (0..WORDS).chain(kept).enumerate();
        for (address, word) in all.cycle().skip(turn).take(WORDS + kept.len()) {
            // The line before goes on beside the new words.
            if early > 1 {
                self.command(command(port::PIXEL), 1, pause);
            }
            let mut inputs = command(port::LOAD);
            inputs[port::ADDRESS] = address as i64;
            // Second differences are even: they are twice a coefficient.
            let mask = if word < 2 { !1 } else { !0 };
            inputs[port::DATA] = words[word] & mask;
            self.command(inputs, 1, 0);
        }
        let fields = match kind {
            [true, first] => vec![Some(first), Some(!first)],
            [false, _] => vec![None],
        };
        for field in fields {
            let (at, restore) = match field {
                Some(_) => (port::FIELD, 6),
                None => (port::PICTURE, 1),
            };
            let mut start = command(at);
            start[port::ODD] = field.unwrap_or_default().into();
            self.command(start, restore, pause);
            for _ in 0..early {
                self.command(command(port::PIXEL), 1, 0);
            }
            for line in 0..height {
                let is_long = field.is_some_and(|is_odd| is_odd || line > 0);
                let clocks = if is_long { 27 } else { 15 };
                self.command(command(port::LINE), clocks, pause);
                for _ in 0..width {
                    self.command(command(port::PIXEL), 1, 0);
                }
            }
        }
    }

    /// A command that takes so many clocks, and clocks of rest behind it.
    fn command(&mut self, inputs: Inputs, clocks: usize, pause: usize) {
        let rest = vec![0; port::COUNT];
        self.0.push((inputs, false));
        let busy = std::iter::repeat_n((rest.clone(), true), clocks - 1);
        self.0
            .extend(busy.chain(std::iter::repeat_n((rest, false), pause)));
    }
}
