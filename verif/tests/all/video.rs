//! The units of the graphics module behind the decider, over whole frames: what the clock by clock comparison of
//! `units.rs` does not say by itself.

use super::{request, unit};
use imogene_circuits::video::{Queue, pixel_fifo, video_timing};
use imogene_contract::video::{Span, VideoMode};
use imogene_golden::machine::post_filter::Kernel;
use imogene_golden::machine::video_timing as golden;
use imogene_hdl::{Bits, Value};
use imogene_verif::engine::circuit::Circuit;
use imogene_verif::random;
use imogene_verif::subject::Hardware;
use imogene_verif::unit::subject;

/// A reproducible source of numbers.
pub(crate) struct Numbers(pub u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }
}

/// The values after a clock, by port; all are defined in the built-in engine.
fn clock(hardware: &mut dyn Hardware, inputs: &[i64]) -> Vec<i64> {
    let values = crate::clock(hardware, inputs);
    values.into_iter().map(|v| v.expect("a value")).collect()
}

#[test]
fn every_video_unit_is_its_golden_model() {
    let names = "video_timing pixel_fifo frame_store post_filter overlay accumulator";
    for name in names.split(' ') {
        let (report, _) = random::run(&unit(name, 24), 20_000, 5, false);
        let first = &report.first_mismatches;
        assert_eq!(report.mismatches, 0, "{name}: {first:?}");
        assert!(report.pixels > 1000, "{name}");
    }
}

/// Two frames of 160 x 120 and one of 640 x 480, with pauses.
#[test]
fn whole_frames_of_video() {
    for (mode, frames) in [(0, 2), (1, 1)] {
        let request = request("video_timing", 24, &[("mode", mode as u32)]);
        let subject = subject(&request).expect("a mode of the catalogue");
        let mut numbers = Numbers(mode as u64);
        let clocks = VideoMode::ALL[mode].clocks() * frames * 16 / 15 + 1000;
        let enabled = (0..clocks).map(|_| vec![i64::from(numbers.below(16) > 0)]);
        let report = subject.run_each(enabled, |_| ());
        assert_eq!(report.mismatches, 0, "{:?}", report.first_mismatches);
    }
}

/// A lead of nothing, within a line, of a line and more: the request is what is shown that much later, over all
/// blankings.
#[test]
fn leads_of_any_length() {
    let mode = VideoMode {
        line: Span::new(5, 1, 1, 0),
        frame: Span::new(4, 0, 2, 1),
        hsync_high: true,
        vsync_high: false,
    };
    for lead in 0..mode.retrace() as usize {
        let mut unit = Circuit::of(|| video_timing("top", Bits::input(1), &mode, lead as u64));
        let mut timing = golden::VideoTiming::new(mode, lead as u64);
        for at in 0..150 {
            unit.clock(&[1]);
            let expected = timing.clock(true);
            let place = format!("lead {lead}, clock {at}");
            let mut value = |name: &str| unit.value(name) as u64;
            let names = [
                ["de", "start", "line", "x", "y"],
                ["need", "go", "need_line", "need_x", "need_y"],
            ];
            for (names, shown) in names.iter().zip([&expected.now, &expected.ahead]) {
                let flags = [shown.active, shown.start, shown.line].map(u64::from);
                let stated = [flags[0], flags[1], flags[2], shown.x.into(), shown.y.into()];
                assert_eq!(names.map(&mut value), stated, "{place}");
            }
            let syncs = ["hsync", "vsync", "frame_start"].map(&mut value);
            let stated = [expected.hsync, expected.vsync, expected.frame_start];
            assert_eq!(syncs, stated.map(u64::from), "{place}");
        }
    }
}

#[test]
#[should_panic(expected = "accepted are fewer than the 336 of the vertical blanking")]
fn a_lead_longer_than_the_blanking_is_refused() {
    Circuit::of(|| video_timing("top", Bits::input(1), &VideoMode::SMALL, 336));
}

#[test]
#[should_panic(expected = "accepted are 65 at least")]
fn a_queue_shorter_than_the_pipeline_is_refused() {
    Circuit::of(|| pixel_fifo("top", Queue::input(8), 6, 60));
}

/// A pipeline of `flight` clocks before the queue, which starts a pixel on every clock with `room` that `wants` one;
/// gives pushed and taken words.
fn stream(
    flight: usize,
    clocks: usize,
    mut wants: impl FnMut(usize) -> bool,
    mut ready: impl FnMut(usize) -> bool,
) -> (Vec<i64>, Vec<i64>) {
    let mut hardware = (unit("pixel_fifo", 24).hardware)(1);
    let (mut pushed, mut taken) = (Vec::new(), Vec::new());
    let mut flying = vec![false; clocks + flight + 1];
    let mut out = vec![1, 0, 0, 0];
    for at in 0..clocks {
        let started = out[0] == 1 && wants(at);
        flying[at + flight] = started;
        let (push, word) = (flying[at], (at * 2_654_435_761) as i64 & 0xff_ffff);
        let ready = ready(at);
        if push {
            pushed.push(word);
        }
        if out[1] == 1 && ready {
            taken.push(out[2]);
        }
        let before = out.clone();
        let inputs = [started, push].map(i64::from);
        let inputs = [inputs[0], inputs[1], word, word & 1, ready.into()];
        out = clock(hardware.as_mut(), &inputs);
        if before[1] == 1 && !ready {
            assert_eq!(out[1..], before[1..], "what is not taken stays");
        }
        let is_of_word = out[1] == 0 || out[3] == out[2] & 1;
        assert!(is_of_word, "last goes with its word");
        assert!(pushed.len() - taken.len() <= 64, "a queue of 64");
    }
    (pushed, taken)
}

#[test]
fn no_pixel_is_lost_repeated_or_moved() {
    let mut numbers = Numbers(1);
    for flight in [0, 1, 5, 39, 40, 59] {
        for stalls in [1, 2, 9, 200] {
            let (mut stalled, mut left) = (false, 0);
            let mut wants = Numbers(numbers.next());
            let wants = |_| wants.below(8) > 0;
            let ready = |_| {
                if left == 0 {
                    (stalled, left) = (!stalled, 1 + numbers.below(stalls));
                }
                left -= 1;
                !stalled
            };
            let (pushed, taken) = stream(flight, 3000, wants, ready);
            assert!(taken.len() > 500 && pushed.len() - taken.len() <= 64);
            assert_eq!(taken, pushed[..taken.len()], "{flight} {stalls}");
        }
    }
}

/// 2^6 >= flight + 5: one pixel per clock for ever, if nobody stalls; and whatever waits comes out.
#[test]
fn a_receiver_that_never_stalls_gets_a_pixel_per_clock() {
    for flight in [0, 17, 40, 59] {
        let (pushed, taken) = stream(flight, 2000, |at| at < 1900, |_| true);
        assert_eq!(pushed.len(), 1900);
        assert_eq!(taken, pushed);
    }
    let (pushed, _) = stream(60, 2000, |_| true, |_| true);
    assert_eq!(pushed.len(), 2000 - 60);
    let (pushed, _) = stream(61, 2000, |_| true, |_| true);
    assert!(pushed.len() < 2000 - 61, "too long a pipeline starves");
}

/// Two pictures by turns from a writer that stalls and is late: every frame on the screen is one of them, whole, and
/// none is skipped.
#[test]
fn frames_are_shown_whole() {
    const WIDTH: usize = 7;
    const HEIGHT: usize = 5;
    const PIXELS: usize = WIDTH * HEIGHT;
    let colour = |frame: usize, place: usize| {
        let word = frame * 0x40_1003 + place * 0x1_0107;
        word as i64 & 0xff_ffff
    };
    let mut numbers = Numbers(3);
    let mut hardware = (unit("frame_store", 24).hardware)(1);
    let mode = VideoMode {
        line: Span::new(WIDTH as u64, 1, 1, 1),
        frame: Span::new(HEIGHT as u64, 0, 1, 0),
        hsync_high: true,
        vsync_high: true,
    };
    let mut timing = golden::VideoTiming::new(mode, 3);
    let (mut frame, mut sent, mut is_ready, mut pause) = (1, 0, true, 0);
    let (mut seen, mut screen) = (Vec::new(), Vec::new());
    for _ in 0..60_000 {
        let at = timing.clock(true);
        let arrives = pause == 0 && numbers.below(4) > 0;
        pause -= usize::from(pause > 0);
        // Columns first, to show that the order does not matter.
        let place = sent % HEIGHT * WIDTH + sent / HEIGHT;
        let last = sent + 1 == PIXELS;
        let inputs = [
            arrives.into(),
            colour(frame, place),
            ((place / WIDTH) << 12 | (place % WIDTH)) as i64,
            last.into(),
            WIDTH as i64,
            at.frame_start.into(),
            at.ahead.active.into(),
            at.ahead.x.into(),
            at.ahead.y.into(),
        ];
        if arrives && is_ready {
            sent += 1;
            if last {
                (frame, sent) = (frame + 1, 0);
                pause = numbers.below(150) as usize;
            }
        }
        let out = clock(hardware.as_mut(), &inputs);
        is_ready = out[0] == 1;
        if out[1] == 1 {
            screen.push(out[2] << 16 | out[3] << 8 | out[4]);
            if screen.len() == PIXELS {
                seen.push(std::mem::take(&mut screen));
            }
        }
    }
    assert!(seen.len() > 900 && frame > 200);
    let mut number = 0;
    let mut repeated = 0;
    for picture in &seen {
        let of = |frame: usize| -> Vec<i64> {
            let pixel = |p: usize| if frame == 0 { 0 } else { colour(frame, p) };
            (0..PIXELS).map(pixel).collect()
        };
        if of(number + 1) == *picture {
            number += 1;
        } else {
            assert_eq!(of(number), *picture, "frame {number}");
            repeated += 1;
        }
    }
    assert!(number + 2 >= frame - 1, "{number} of {frame} were shown");
    assert!(repeated > 100, "the writer is late often enough");
}

/// Whole random pictures against the direct convolution in two dimensions.
#[test]
fn filtered_pictures_are_the_convolution() {
    let mut numbers = Numbers(9);
    let mut hardware = (unit("post_filter", 24).hardware)(1);
    let shapes = [(1, 1), (1, 5), (2, 2), (5, 1), (9, 7), (33, 20), (2048, 3)];
    for (width, height) in shapes {
        for kernel in 0..4 {
            let mut level = || match numbers.below(4) {
                0 => 0,
                1 => 255,
                _ => numbers.below(256) as u8,
            };
            let lines: Vec<Vec<[u8; 3]>> = (0..height)
                .map(|_| (0..width).map(|_| [level(), level(), level()]).collect())
                .collect();
            let mut found = Vec::new();
            let mut take = |out: Vec<i64>| {
                if out[0] == 1 {
                    assert_eq!(out[3] == 1, out[1] as usize + 1 == width);
                    assert_eq!(out[4] == 1, found.len() + 1 == width * height);
                    found.push((out[1], out[2], [out[5] as u8, out[6] as u8, out[7] as u8]));
                }
            };
            for (y, line) in lines.iter().enumerate() {
                for (x, colour) in line.iter().enumerate() {
                    let ends = [x + 1 == width, x + 1 == width && y + 1 == height];
                    let mut inputs = vec![kernel, 1, x as i64, y as i64];
                    inputs.extend(ends.map(i64::from));
                    inputs.extend(colour.map(i64::from));
                    take(clock(hardware.as_mut(), &inputs));
                }
                // A line of one pixel has a longer pause behind it.
                for _ in 0..3usize.saturating_sub(width).max(1) {
                    take(clock(hardware.as_mut(), &[0; 9]));
                }
            }
            // What is left of the shortest pause after a picture, and what the pipeline holds.
            for _ in 0..width + 7 {
                take(clock(hardware.as_mut(), &[0; 9]));
            }
            let smooth = Kernel::from_word(kernel).picture(&lines);
            let expected: Vec<_> = (0..height)
                .flat_map(|y| (0..width).map(move |x| (x as i64, y as i64)))
                .map(|(x, y)| (x, y, smooth[y as usize][x as usize]))
                .collect();
            assert!(found == expected, "{width} x {height}, kernel {kernel}");
        }
    }
}

/// Every sum of a pass count has the rounded mean: each step of 0 to 255 in 16 passes.
#[test]
fn means_are_exact() {
    let mut hardware = (unit("accumulator", 24).hardware)(1);
    for (fine, passes) in [(0, 4), (1, 16)] {
        for sum in 0..=passes * 255 {
            // Levels as even as they can be, in two places by turns and two pauses, so that a place comes again after 4
            // clocks.
            let level = |pass: i64| (sum + pass) / passes;
            let mut means = Vec::new();
            let mut take = |inputs: [i64; 8]| {
                let out = clock(hardware.as_mut(), &inputs);
                means.extend((out[0] == 1).then(|| out[1..].to_vec()));
            };
            let pause = [fine, 0, 0, 0, 0, 0, 0, 0];
            for pass in 0..passes {
                let flags = [i64::from(pass == 0), i64::from(pass + 1 == passes)];
                for (place, value) in [(7, level(pass)), (8, 255 - level(pass))] {
                    take([fine, 1, place, flags[0], flags[1], value, 0, 255]);
                }
                take(pause);
                take(pause);
            }
            (0..3).for_each(|_| take(pause));
            let mean = |sum: i64| (sum + passes / 2).div_euclid(passes);
            let of = |place, sum| vec![place, mean(sum), 0, 255];
            let expected = [of(7, sum), of(8, passes * 255 - sum)];
            assert_eq!(means, expected, "{sum} of {passes}");
        }
    }
}
