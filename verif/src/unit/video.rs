//! The rasters of zones and of a screen, what stands between a pipeline and a stream, and between a stream and a
//! screen, and what changes the pixels of a picture: filter, overlay, accumulator.

use super::description::{Description, behind_valid, bit, late};
use crate::signal::Delay;
use crate::stimulus::{each, mapped};
use crate::subject::{Inputs, Stimuli, Subject};
use imogene_contract::video::{LEAD, MERGED, MERGED_WORDS, VideoMode};
use imogene_contract::words::COORDINATE;
use imogene_golden::machine::accumulator::{self, Accumulator, PassPixel};
use imogene_golden::machine::frame_store::{Arriving, FrameStore};
use imogene_golden::machine::line_merger::LineMerger;
use imogene_golden::machine::overlay::{Covered, Overlay};
use imogene_golden::machine::pixel_fifo::PixelFifo;
use imogene_golden::machine::post_filter::{FilterPixel, Kernel, PostFilter};
use imogene_golden::machine::raster::RasterControl;
use imogene_golden::machine::video_timing::{Shown, VideoTiming};
use proptest::collection::vec as list;
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
    mapped(list(run, clocks), move |runs| {
        let each = runs.into_iter();
        each.flat_map(|(flag, length)| std::iter::repeat_n(flag, length))
            .take(clocks)
            .collect()
    })
}

/// A pipeline of any legal latency that obeys `room`, and a receiver that stalls.
fn pipelines(_: &Subject, clocks: usize) -> Stimuli {
    let words = list((0i64..1 << 24, 0i64..=1), clocks);
    mapped(
        (0..=LEAD, runs(clocks), runs(clocks), words),
        |(flight, wanted, ready, words)| pipeline(flight, &wanted, &ready, &words),
    )
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

/// Gives a merger what stands on its ports.
fn merge(merger: &mut LineMerger, i: &[i64]) {
    let (valid, pixels, told) = (bit(i[0]), &i[1..=MERGED], &i[1 + MERGED..]);
    let pixels: Vec<u32> = pixels.iter().map(|&pixel| pixel as u32).collect();
    let coming = valid.then_some((&pixels[..], bit(told[0]), bit(told[1])));
    merger.clock(coming, bit(told[2]));
}

pub(super) fn line_merger() -> Description {
    Description::new(modules, || {
        let mut merger = LineMerger::new(MERGED);
        move |i: &[i64]| {
            merge(&mut merger, i);
            let leaving = merger.leaving().map(|leaving| {
                let ends = [leaving.first, leaving.last].map(i64::from);
                let pixels = leaving.pixels.iter().map(|&pixel| i64::from(pixel));
                let told: Vec<i64> = pixels.chain(ends).collect();
                <[i64; MERGED + 2]>::try_from(told).expect("a pixel for each module")
            });
            [
                vec![Some(merger.is_ready().into())],
                behind_valid(Some(leaving)),
            ]
            .concat()
        }
    })
}

/// Frames of two lines of each module, of modules that stall as the merger and its receiver want.
fn modules(_: &Subject, clocks: usize) -> Stimuli {
    let pixels = list(list(0i64..1 << 24, MERGED), clocks);
    let drawn = (runs(clocks), runs(clocks), pixels);
    mapped(drawn, |(wanted, ready, pixels)| {
        let mut merger = LineMerger::new(MERGED);
        let width = MERGED * MERGED_WORDS;
        let mut place = 0;
        let each = wanted.into_iter().zip(ready).zip(pixels);
        let each = each.map(|((valid, ready), pixels)| {
            let (first, last) = (place == 0, place % width == width - 1);
            let taken = valid && merger.is_ready();
            let told = [first, last, ready].map(i64::from);
            let inputs = [&[valid.into()][..], &pixels, &told].concat();
            merge(&mut merger, &inputs);
            place = (place + usize::from(taken)) % (2 * width);
            inputs
        });
        each.collect()
    })
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
            let flags = [out.ready, out.colour.is_some(), out.swapped];
            let [ready, shown, swapped] = flags.map(|flag| Some(flag.into()));
            vec![ready, shown, part(16), part(8), part(0), swapped]
        }
    })
}

/// Frames of a few pixels in any order, in pictures of any shape, while pixels are read and retraces come at any time.
fn frames(_: &Subject, clocks: usize) -> Stimuli {
    let pixels = FRAME_PIXELS as i64;
    // All the pixels there are, or so few that they come again.
    let full = (0u32..12, 0..pixels).prop_map(move |(bit, below): (u32, i64)| {
        let power = 1i64 << bit;
        let width = power | below & (power - 1);
        (width, pixels / width)
    });
    let shape = prop_oneof![Just((3, 2)), Just((1, 4)), full];
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
            list(one, clocks)
        })
        .boxed()
}

pub(super) fn raster_control() -> Description {
    Description::new(any_zones, || {
        let mut raster = RasterControl::default();
        move |i: &[i64]| {
            match raster.clock(bit(i[0]), i[1] as u16, i[2] as u16) {
                Some(p) => {
                    let [start, line, last] = [p.start, p.line, p.last].map(i64::from);
                    let values = [1, start, line, p.x.into(), p.y.into(), last];
                    values.map(Some).to_vec()
                }
                // Without a pixel only the flags are stated.
                None => vec![Some(0), Some(0), Some(0), None, None, Some(0)],
            }
        }
    })
    .reached_in(3 << COORDINATE)
}

/// Requests at random times, small zones so that many end, now and then a long line or a high column.
fn any_zones(_: &Subject, clocks: usize) -> Stimuli {
    let go = prop_oneof![2 => Just(0i64), 1 => Just(1)];
    let sides = prop_oneof![
        24 => (1i64..6, 1i64..6),
        2 => (1i64..40, 1i64..40),
        1 => (1i64..1 << COORDINATE, 1i64..3),
        1 => (1i64..3, 1i64..1 << COORDINATE),
    ];
    let each = (go, sides).prop_map(|(go, (width, height))| vec![go, width, height]);
    list(each, clocks).boxed()
}

pub(super) fn video_timing(mode: usize) -> Description {
    let mode = VideoMode::ALL[mode];
    let frame = mode.clocks() as usize;
    let mostly_enabled = |_: &Subject, clocks| {
        let enable = prop_oneof![15 => Just(1i64), 1 => Just(0)];
        each(vec![enable.boxed()], clocks)
    };
    Description::new(mostly_enabled, move || {
        let mut timing = VideoTiming::new(mode, LEAD as u64);
        move |i: &[i64]| {
            let at = timing.clock(bit(i[0]));
            let mut values = shown(&at.now);
            values.extend([at.hsync, at.vsync, at.frame_start].map(i64::from));
            values.extend(shown(&at.ahead));
            values.into_iter().map(Some).collect()
        }
    })
    // Two frames, of which some clocks are without `enable`.
    .reached_in(frame * 9 / 4)
}

fn shown(pixel: &Shown) -> Vec<i64> {
    let flags = [pixel.active, pixel.start, pixel.line].map(i64::from);
    [&flags[..], &[pixel.x, pixel.y].map(i64::from)].concat()
}

fn colour(words: &[i64]) -> [u8; 3] {
    [words[0] as u8, words[1] as u8, words[2] as u8]
}

/// Levels that often are those of an end.
fn level() -> BoxedStrategy<i64> {
    prop_oneof![2 => 0i64..256, 1 => Just(0), 1 => Just(255), 1 => 253i64..256, 1 => 0i64..3]
        .boxed()
}

pub(super) fn post_filter() -> Description {
    Description::new(pictures, || {
        let mut filter = PostFilter::default();
        move |i: &[i64]| {
            let pixel = bit(i[1]).then(|| FilterPixel {
                x: i[2] as u16,
                y: i[3] as u16,
                line_end: bit(i[4]),
                last: bit(i[5]),
                colour: colour(&i[6..]),
            });
            let out = filter.clock(Kernel::from_word(i[0]), pixel);
            behind_valid(Some(out.map(|p| {
                let [r, g, b] = p.colour.map(i64::from);
                let ends = [p.line_end, p.last].map(i64::from);
                [p.x.into(), p.y.into(), ends[0], ends[1], r, g, b]
            })))
        }
    })
    .reached_in(LARGE)
}

/// Clocks of as many lines of one pixel as there can be, with their pauses.
const LARGE: usize = 4 << COORDINATE;

/// A picture of random colours: columns, lines, a random kernel, random pauses, noise.
type Picture = (usize, usize, i64, Vec<usize>, Vec<Inputs>);

/// Appends the clocks of a picture; what stands on the ports in a pause is noise.
fn write((width, height, kernel, pauses, noise): &Picture, clocks: &mut Vec<Inputs>) {
    let mut noise = noise.iter().cycle();
    let mut next = || noise.next().expect("a cycle has no end").clone();
    let mut pauses = pauses.iter().cycle();
    let mut pause = || *pauses.next().expect("a cycle has no end");
    for y in 0..*height {
        for x in 0..*width {
            let mut inputs = next();
            let line_end = x + 1 == *width;
            let last = line_end && y + 1 == *height;
            if x == 0 && y == 0 {
                inputs[0] = *kernel;
            }
            inputs[1..6].copy_from_slice(&[1, x as i64, y as i64, line_end.into(), last.into()]);
            clocks.push(inputs);
            let after_line = usize::from(line_end) * 3usize.saturating_sub(*width).max(1);
            let idle = pause() + after_line + if last { width + 2 } else { 0 };
            clocks.extend((0..idle).map(|_| {
                let mut inputs = next();
                inputs[1] = 0;
                inputs
            }));
        }
    }
}

/// Small pictures one after the other; in a long stimulus now and then first one as high or as wide as can be.
fn pictures(_: &Subject, clocks: usize) -> Stimuli {
    let up_to = |most: i64| (0..=most).boxed();
    let flags = [up_to(3), up_to(2), up_to(1), up_to(1)];
    let noise = [vec![up_to(3), Just(0).boxed()], flags.to_vec()].concat();
    let noise = [noise, vec![level(), level(), level()]].concat();
    let idle = prop_oneof![5 => Just(0usize), 1 => 1usize..4];
    let (pauses, noise) = (list(idle, 41), list(noise, 97));
    let picture = (1usize..8, 1usize..6, 0i64..4, pauses, noise);
    let large = prop_oneof![
        2 => Just(None),
        1 => Just(Some((1, (1 << COORDINATE) - 1))),
        1 => Just(Some((1 << (COORDINATE - 1), 2))),
    ];
    let drawn = (large, list(picture, clocks / 12 + 1));
    mapped(drawn, move |(large, mut pictures)| {
        if let Some(size) = large.filter(|_| clocks >= LARGE) {
            (pictures[0].0, pictures[0].1) = size;
        }
        let mut list = Vec::new();
        pictures.iter().for_each(|one| write(one, &mut list));
        list.truncate(clocks);
        list
    })
}

/// Words of the plane of the catalogue.
const PLANE_WORDS: usize = 1 << 10;

pub(super) fn overlay() -> Description {
    Description::new(planes, || {
        let mut overlay = Overlay::new(PLANE_WORDS);
        move |i: &[i64]| {
            let write = bit(i[0]).then_some((i[1] as usize, i[2] as u32));
            let over = [i[4] >> 16, i[4] >> 8, i[4]];
            let pixel = bit(i[6]).then(|| Covered {
                place: (i[8] * i[5] + i[7]) as usize,
                colour: colour(&i[9..]),
            });
            let shown = bit(i[3]).then(|| colour(&over));
            let over = overlay.clock(write, shown, pixel);
            behind_valid(Some(over.map(|colour| colour.map(i64::from))))
        }
    })
}

/// Words written and pixels read at a few places near the ends of the plane and of the coordinates, so that they meet.
fn planes(_: &Subject, clocks: usize) -> Stimuli {
    let address = prop_oneof![3 => 0i64..3, 1 => 1021i64..1024];
    let write = (0i64..=1, address, 0i64..1 << 32);
    let shown = (prop_oneof![1 => Just(0i64), 5 => Just(1)], 0i64..1 << 24);
    let near = (1i64..64, 0i64..64, 0i64..2);
    let far = (4000i64..4096, 4000i64..4096, 4000i64..4096);
    let pixel = (
        prop_oneof![1 => Just(0i64), 5 => Just(1)],
        prop_oneof![5 => near, 1 => far],
        [level(), level(), level()],
    );
    let one = (write, shown, pixel).prop_map(
        |((write, address, data), (enable, over), (valid, (width, x, y), colour))| {
            let inputs = [write, address, data, enable, over, width, valid, x, y];
            [&inputs[..], &colour].concat()
        },
    );
    list(one, clocks).boxed()
}

/// Pixels of the accumulator of the catalogue.
const SUMS: usize = 1 << 12;

pub(super) fn accumulator() -> Description {
    Description::new(passes, || {
        let mut sums = Accumulator::new(SUMS);
        let mut late = late(accumulator::LATENCY);
        move |i: &[i64]| {
            let pixel = PassPixel {
                address: i[2] as usize,
                first: bit(i[3]),
                last: bit(i[4]),
                colour: colour(&i[5..]),
            };
            let passes = if bit(i[0]) { 16 } else { 4 };
            let mean = bit(i[1]).then(|| sums.add(&pixel, passes)).flatten();
            let found = late.push(mean.map(|mean| (i[2], mean.map(i64::from))));
            let found = found.flatten();
            behind_valid(Some(found.map(|(at, [r, g, b])| [at, r, g, b])))
        }
    })
}

/// Passes over a few pixels in any order, each pixel at its own pass; the last pass as often as it can be, now and then
/// before all have come. How many there are is told with the last one alone.
fn passes(_: &Subject, clocks: usize) -> Stimuli {
    let place = prop_oneof![4 => 0i64..3, 1 => 4094i64..4096];
    let one = (
        prop_oneof![1 => Just(0i64), 9 => Just(1)],
        place,
        [15u32, 7].map(|seldom| prop_oneof![seldom => Just(false), 1 => Just(true)]),
        any::<bool>(),
        [level(), level(), level()],
    );
    mapped((any::<bool>(), list(one, clocks)), |(fine, list)| {
        let most = if fine { 16 } else { 4 };
        let mut done = std::collections::BTreeMap::<i64, u32>::new();
        let mut before = [None; 3];
        let each = list
            .into_iter()
            .map(|(valid, place, [again, early], other, colour)| {
                // A pixel comes again after 4 clocks at the earliest.
                let valid = valid == 1 && !before.contains(&Some(place));
                before = [before[1], before[2], valid.then_some(place)];
                let passes = done.entry(place).or_default();
                let first = *passes == most || again;
                if valid {
                    *passes = if first { 1 } else { *passes + 1 };
                }
                let last = early || *passes == most;
                let fine = if last { fine } else { other };
                let [fine, valid, first, last] = [fine, valid, first, last].map(i64::from);
                [&[fine, valid, place, first, last][..], &colour].concat()
            });
        each.collect()
    })
}
