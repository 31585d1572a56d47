//! What is stated of a unit, and what golden models have in common.

use super::words::Ports;
use crate::signal::Delay;
use crate::stimulus::{hold, mapped, raster};
use crate::subject::{Golden, Inputs, Stimuli, Stimulus, Subject};
use imogene_golden::format::Format;
use std::iter;

/// Golden model and stimulus of a unit; ports and hardware are those of its circuit.
pub(super) struct Description {
    /// Takes the inputs and gives the outputs in the order of the ports.
    pub(super) golden: Box<dyn Fn() -> Golden + Sync>,
    pub(super) stimulus: Stimulus,
    /// Clocks of a stimulus that reaches every state.
    pub(super) longest: usize,
}

impl Description {
    /// A golden model that `start` makes afresh, as a function of the inputs of a clock.
    pub(super) fn new<G: FnMut(&[i64]) -> Vec<Option<i64>> + Send + 'static>(
        stimulus: impl Fn(&Subject, usize) -> Stimuli + Sync + 'static,
        start: impl Fn() -> G + Sync + 'static,
    ) -> Description {
        Description {
            golden: Box::new(move || Box::new(start())),
            stimulus: Box::new(stimulus),
            longest: 0,
        }
    }

    /// Outputs of the inputs of a clock alone, so many clocks later.
    pub(super) fn pipeline<const N: usize>(
        stimulus: impl Fn(&Subject, usize) -> Stimuli + Sync + 'static,
        latency: u32,
        outputs: impl Fn(&[i64]) -> [i64; N] + Clone + Send + Sync + 'static,
    ) -> Description {
        Description::new(stimulus, move || {
            let (mut late, outputs) = (late(latency as usize), outputs.clone());
            move |i: &[i64]| stated(late.push(outputs(i)))
        })
    }

    /// With so many clocks from each clock of a stimulus to the next, on which nothing begins: flags come first.
    pub(super) fn apart(self, clocks: u32) -> Description {
        if clocks == 1 {
            return self;
        }
        let clocks = clocks as usize;
        let spread = move |list: Vec<Inputs>| {
            let waits = |inputs: Inputs| {
                let idle = [&[0; FLAGS], &inputs[FLAGS..]].concat();
                iter::once(inputs).chain(iter::repeat_n(idle, clocks - 1))
            };
            list.into_iter().flat_map(waits).collect()
        };
        let close = self.stimulus;
        let stimulus = move |subject: &Subject, count: usize| {
            mapped(close(subject, count.div_ceil(clocks)), spread)
        };
        Description {
            stimulus: Box::new(stimulus),
            ..self
        }
    }

    /// With states that only a stimulus of so many clocks reaches.
    pub(super) fn reached_in(self, longest: usize) -> Description {
        Description { longest, ..self }
    }
}

/// A port value as a bit.
pub(super) fn bit(value: i64) -> bool {
    value != 0
}

/// All outputs of a result, or none of them before there is one.
pub(super) fn stated<const N: usize>(result: Option<[i64; N]>) -> Vec<Option<i64>> {
    result.map_or(vec![None; N], |values| values.map(Some).to_vec())
}

/// Whether there is a result, and the result; nothing of either before the first clock whose result is known.
pub(super) fn behind_valid<const N: usize>(found: Option<Option<[i64; N]>>) -> Vec<Option<i64>> {
    let is_there = found.map(|result| i64::from(result.is_some()));
    [vec![is_there], stated(found.flatten())].concat()
}

/// What a golden model with a fixed latency states: results come out `latency` edges after their inputs went in.
pub(super) fn late<T>(latency: usize) -> Delay<T> {
    Delay::new(latency - 1)
}

/// A golden processor that the first three ports drive over a zone, on a clock with a pixel; none before a zone.
pub(super) fn scan<'a, P>(
    zone: &'a mut Option<P>,
    flags: &[i64],
    start: impl FnOnce() -> P,
    line_step: impl FnOnce(&mut P),
) -> Option<&'a mut P> {
    if !bit(flags[0]) {
        return None;
    }
    if bit(flags[1]) {
        *zone = Some(start());
    } else if bit(flags[2]) {
        zone.as_mut().map(line_step);
    }
    zone.as_mut()
}

/// The value of the last pixel of a processor that the flags drive.
pub(super) fn last_pixel<P>(
    start: impl Fn(&[i64]) -> P,
    line_step: fn(&mut P),
    pixel: impl Fn(&mut P) -> i64,
) -> impl FnMut(&[i64]) -> Option<i64> {
    let (mut zone, mut value) = (None, None);
    move |i| {
        if bit(i[0]) {
            value = scan(&mut zone, i, || start(i), line_step).map(&pixel);
        }
        value
    }
}

/// A [`raster`] with words that change with the start of a zone alone.
pub(super) fn zones(subject: &Subject, clocks: usize) -> Stimuli {
    let words = 3..subject.inputs.len();
    let held = move |mut list: Vec<Inputs>| {
        hold(&mut list, words.clone(), 0);
        list
    };
    mapped(raster(subject, clocks), held)
}

const FLAGS: usize = 3;

/// Ports before the first word: the flags, then the column and the line.
pub(super) const WORDS: usize = 5;

/// A processor with `N` outputs behind `out_valid`, `latency` clocks after the flags. `read` reads the words of a zone
/// from the ports over `words` of the same shape; `pixel` gives the outputs at a pixel of the zone, from what the ports
/// show `entry` clocks after the flags.
pub(super) fn zone<W: Clone + Send + Sync + 'static, const N: usize>(
    stimulus: impl Fn(&Subject, usize) -> Stimuli + Sync + 'static,
    format: Format,
    [entry, latency]: [u32; 2],
    words: W,
    read: fn(&mut Ports, &mut W),
    pixel: fn(&W, [i64; 2], &Format, &[i64]) -> [i64; N],
) -> Description {
    Description::new(stimulus, move || {
        let mut words = words.clone();
        let mut entered = Delay::new(entry as usize);
        let mut late = late((latency - entry) as usize);
        let mut zone = None;
        move |i: &[i64]| {
            let Some(raster) = entered.push([i[0], i[1], i[2], i[3], i[4]]) else {
                return behind_valid::<N>(None);
            };
            let [flags @ .., x, y] = raster;
            let start = || {
                let mut ports = Ports::of(Some(&i[WORDS..]), &format);
                ports.origin = [x, y];
                read(&mut ports, &mut words);
                (words.clone(), [0; 2])
            };
            let line_step = |(_, at): &mut (W, [i64; 2])| *at = [0, at[1] + 1];
            let seen = scan(&mut zone, &flags, start, line_step).map(|(words, at)| {
                let outputs = pixel(words, *at, &format, i);
                at[0] += 1;
                outputs
            });
            behind_valid(late.push(seen))
        }
    })
}
