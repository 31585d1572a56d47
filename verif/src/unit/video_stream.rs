//! What stands between a pipeline and a stream, and between a stream and a screen.

use super::description::{Description, behind_valid, bit};
use crate::signal::Delay;
use crate::subject::{Inputs, Subject};
use imogene_contract::video::LEAD;
use imogene_golden::machine::frame_store::{Arriving, FrameStore};
use imogene_golden::machine::pixel_fifo::PixelFifo;
use proptest::prelude::*;

/// Places of the queue of the catalogue.
pub const FIFO_PLACES: usize = 64;

pub(super) fn pixel_fifo() -> Description {
    Description::new(pipelines, || {
        let mut fifo = PixelFifo::new(FIFO_PLACES);
        move |i: &[i64]| {
            let push = bit(i[1]).then_some((i[2] as u32, bit(i[3])));
            let out = fifo.clock(bit(i[0]), push, bit(i[4]));
            let word = out.word.map(|(data, last)| [data.into(), last.into()]);
            [vec![Some(out.room.into())], behind_valid(Some(word))].concat()
        }
    })
}

/// A flag that stays for a while: most often for a few clocks, now and then until the queue is full or empty.
fn runs(clocks: usize) -> BoxedStrategy<Vec<bool>> {
    let length = prop_oneof![6 => 1usize..5, 1 => 60usize..140];
    let run = (any::<bool>(), length);
    proptest::collection::vec(run, clocks)
        .prop_map(move |runs| {
            let each = runs.into_iter();
            each.flat_map(|(flag, length)| std::iter::repeat_n(flag, length))
                .take(clocks)
                .collect()
        })
        .boxed()
}

/// A pipeline of any legal latency that obeys `room`, and a receiver that stalls.
fn pipelines(_: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let words = proptest::collection::vec((0i64..1 << 24, 0i64..=1), clocks);
    (0..=LEAD, runs(clocks), runs(clocks), words)
        .prop_map(|(flight, wanted, ready, words)| pipeline(flight, &wanted, &ready, &words))
        .boxed()
}

/// The stimulus of a pipeline of `flight` clocks that starts a pixel wherever it is wanted and there is room.
pub fn pipeline(
    flight: usize,
    wanted: &[bool],
    ready: &[bool],
    words: &[(i64, i64)],
) -> Vec<Inputs> {
    let mut fifo = PixelFifo::new(FIFO_PLACES);
    let mut flying = Delay::new(flight);
    let each = wanted.iter().zip(ready).zip(words);
    each.map(|((wanted, ready), (data, last))| {
        let started = *wanted && fifo.output().room;
        let push = flying.push(started).unwrap_or(false);
        fifo.clock(started, push.then_some((0, false)), *ready);
        vec![started.into(), push.into(), *data, *last, (*ready).into()]
    })
    .collect()
}

/// Pixels of a frame of the catalogue's store.
const FRAME_PIXELS: usize = 1 << 12;

pub(super) fn frame_store() -> Description {
    Description::new(frames, || {
        let mut store = FrameStore::new(FRAME_PIXELS);
        move |i: &[i64]| {
            let place = |x: i64, y: i64| (y * i[4] + x) as usize;
            let arriving = bit(i[0]).then(|| Arriving {
                place: place(i[2] & 0xfff, i[2] >> 12),
                colour: i[1] as u32,
                last: bit(i[3]),
            });
            let asked = bit(i[6]).then(|| place(i[7], i[8]));
            let out = store.clock(arriving, bit(i[5]), asked);
            let part = |shift: u32| out.colour.map(|c| i64::from(c >> shift & 0xff));
            vec![
                Some(out.ready.into()),
                Some(out.colour.is_some().into()),
                part(16),
                part(8),
                part(0),
                Some(out.swapped.into()),
            ]
        }
    })
}

/// Frames of a few pixels in any order, in pictures of any shape, while pixels are read and retraces come at any time.
fn frames(_: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let shape = prop_oneof![
        Just((3i64, 2i64)),
        Just((1, 4)),
        Just((64, 64)),
        Just((4095, 1)),
        Just((8, 511))
    ];
    shape
        .prop_flat_map(move |(width, height)| {
            let spot = (0i64..3, 0i64..3).prop_map(move |(x, y)| {
                // Corners and the middle, so that places are written and read again.
                let at = |step: i64, count: i64| (count - 1) * step / 2;
                (at(x, width), at(y, height))
            });
            let flag =
                |often: u32, seldom: u32| prop_oneof![often => Just(0i64), seldom => Just(1)];
            let arriving = (flag(1, 2), 0i64..1 << 24, spot.clone(), flag(7, 1));
            let one = (arriving, flag(6, 1), 0i64..=1, spot).prop_map(
                move |((valid, data, from, last), retrace, need, at)| {
                    let user = from.1 << 12 | from.0;
                    vec![valid, data, user, last, width, retrace, need, at.0, at.1]
                },
            );
            proptest::collection::vec(one, clocks)
        })
        .boxed()
}
