//! Random stimulus biased to where arithmetic breaks: the ends of the word, powers of two, ties.

use crate::signal::Signal;
use crate::subject::{Inputs, Stimuli, Subject};
use proptest::prelude::*;
use proptest::sample::select;
use std::fmt::Debug;

/// A word of a signal: half uniform, half at or next to an edge or a power of two.
pub fn word(signal: &Signal) -> BoxedStrategy<i64> {
    let signal = signal.clone();
    let width = signal.width;
    if width == 1 {
        return (0i64..=1).boxed();
    }
    let uniform = any::<u64>();
    let power = (0..width, -2i64..=2, any::<bool>()).prop_map(|(bit, offset, negate)| {
        let value = (1u64 << bit).wrapping_add(offset as u64);
        if negate { value.wrapping_neg() } else { value }
    });
    let scaled = (any::<u64>(), 0..width);
    let scaled = scaled.prop_map(move |(value, shift)| value >> (64 - width + shift));
    let bits = prop_oneof![2 => uniform, 2 => power, 1 => scaled];
    mapped(bits, move |bits| signal.value(bits))
}

/// What a function makes of drawn values.
pub fn mapped<S: Strategy + 'static, T: Debug>(
    of: S,
    how: impl Fn(S::Value) -> T + 'static,
) -> BoxedStrategy<T> {
    of.prop_map(how).boxed()
}

/// Independent values, one for each port, anew on every clock.
pub fn each(ports: Vec<BoxedStrategy<i64>>, clocks: usize) -> Stimuli {
    proptest::collection::vec(ports, clocks).boxed()
}

/// Raster flags `valid`, `start`, `line`: gaps, lines down to one pixel, restarts. The first clock starts a zone.
pub fn flags() -> BoxedStrategy<[i64; 3]> {
    prop_oneof![
        12 => Just([1, 0, 0]),
        3 => Just([1, 0, 1]),
        2 => Just([0, 0, 0]),
        1 => Just([0, 1, 1]),
        1 => Just([1, 1, 0]),
    ]
    .boxed()
}

/// Flags on the first three ports, words on the others.
pub fn raster(subject: &Subject, clocks: usize) -> Stimuli {
    let rest: Vec<_> = subject.inputs[3..].iter().map(word).collect();
    mapped(proptest::collection::vec((flags(), rest), clocks), |list| {
        let one = |(flags, rest): ([i64; 3], Inputs)| [&flags[..], &rest].concat();
        let mut list: Vec<Inputs> = list.into_iter().map(one).collect();
        list[0][..3].copy_from_slice(&[1, 1, 0]);
        list
    })
}

/// Clocks with a pixel between two in which words change, where that takes a pause.
const STRETCH: usize = 24;

/// Words on some ports change with the start of a zone alone, after a pause of so many clocks, which this makes.
pub fn hold(list: &mut [Inputs], words: std::ops::Range<usize>, pause: usize) {
    let mut held = list[0][words.clone()].to_vec();
    for (clock, inputs) in list.iter_mut().enumerate() {
        // The first stretch begins with the first clock.
        let place = (clock + pause) % (pause + STRETCH);
        if place < pause {
            inputs[0] = 0;
        } else if pause > 0 && place == pause {
            inputs[..3].copy_from_slice(&[1, 1, 0]);
        }
        let may_change = pause == 0 || place == pause;
        if may_change && inputs[..2] == [1, 1] {
            held.copy_from_slice(&inputs[words.clone()]);
        } else {
            inputs[words.clone()].copy_from_slice(&held);
        }
    }
}

/// Radicands: uniform, of every length, and at the places where the floor root steps.
pub fn radicand(signal: &Signal) -> BoxedStrategy<i64> {
    let (any_word, signal) = (word(signal), signal.clone());
    let root_mask = u64::MAX >> (64 - signal.width / 2);
    let place = select(vec![-1i64, 0, 1, 2]);
    let boundary = (any::<u64>(), 0..signal.width / 2, place);
    let boundary = boundary.prop_map(move |(root, shift, place)| {
        let n = (root & root_mask) >> shift;
        let square = n.wrapping_mul(n);
        signal.value(match place {
            2 => square.wrapping_add(n.wrapping_mul(2)),
            offset => square.wrapping_add(offset as u64),
        })
    });
    prop_oneof![2 => boundary, 1 => any_word].boxed()
}

/// Depths that meet: a few levels around the ends of the depth word and zero, so that ties are common.
pub fn depth(width: u32) -> BoxedStrategy<i64> {
    let far = (1i64 << (width - 1)) - 1;
    let levels = (-far - 1..=-far + 1).chain(-2..=3).chain(far - 1..=far);
    let level = select(levels.collect::<Vec<i64>>());
    let any_word = word(&Signal::new("depth", width, true));
    prop_oneof![3 => level, 1 => any_word].boxed()
}

/// Ordered depths zf <= zb of an interval as units receive it: within the near and far end.
pub fn interval(width: u32) -> BoxedStrategy<(i64, i64)> {
    let low = -((1i64 << (width - 1)) - 1);
    mapped((depth(width), depth(width)), move |(a, b)| {
        (a.min(b).max(low), a.max(b).max(low))
    })
}
