//! PE1 and PE2 at small widths: every coefficient word on every pixel, against the golden models and the polynomial
//! itself.
//!
//! Modulo 2^n the polynomial repeats after 2^n columns and 2^n lines, and so do the registers; a zone of 2^n + 1
//! columns and lines is therefore stands for every pixel of every zone. One instance runs through all coefficients, so
//! that each zone starts from the registers another one left, in the middle of its raster now and then.

use super::account;
use crate::is_full_run;
use imogene_circuits::raster::{self, Flags, pe1, pe2};
use imogene_golden::unit::pe1::{Linear, Pe1 as GoldenPe1};
use imogene_golden::unit::pe2::{Pe2 as GoldenPe2, Quadratic};
use imogene_verif::engine::circuit::Circuit;
use rayon::prelude::*;
use std::ops::Range;
use std::time::Instant;

/// `value` modulo 2^width as two's complement.
fn wrapped(value: i64, width: usize) -> i64 {
    let unused = 64 - width;
    value.wrapping_shl(unused as u32) >> unused
}

/// All words of a width.
fn words(width: usize) -> Range<i64> {
    -(1 << (width - 1))..1 << (width - 1)
}

/// All even words of a width: second differences are twice a coefficient.
fn even_words(width: usize) -> impl Iterator<Item = i64> {
    words(width).step_by(2)
}

/// One clock: the flags `valid`, `start`, `line`, and the pixel if there is one.
type RasterClock = ([bool; 3], Option<(i64, i64)>);

/// Raster flags of a zone: columns, lines, and a clock without pixel before each line, at which every other flag is
/// set.
fn flags(columns: i64, lines: i64) -> Vec<RasterClock> {
    let mut list = Vec::new();
    for y in 0..lines {
        for x in 0..columns {
            list.push(([true, x == 0 && y == 0, x == 0 && y > 0], Some((x, y))));
        }
        list.push(([false, true, true], None));
    }
    list
}

/// A zone that is given up in its second line, then a whole one.
fn zones(columns: i64, lines: i64) -> Vec<RasterClock> {
    let mut list = flags(columns, 2);
    list.truncate(columns as usize + 2);
    list.extend(flags(columns, lines));
    list
}

/// Runs zones with these words, of which `begins` are read at the start of a zone only: elsewhere their complements
/// stand there. `golden` is given `start` and `line` of each pixel, `exact` its column and line. Returns the pixels
/// checked.
fn check<const N: usize>(
    unit: &mut Circuit,
    clocks: &[RasterClock],
    (words, begins): (&[i64], Range<usize>),
    mut golden: impl FnMut(bool, bool) -> i128,
    exact: impl Fn(i64, i64) -> i64,
) -> u64 {
    let mut pixels = 0;
    for ([valid, start, line], place) in clocks {
        let flip = |word: usize| match begins.contains(&word) && !(*valid && *start) {
            true => -1,
            false => 0,
        };
        let flags = [*valid, *start, *line].map(i64::from).into_iter();
        let inputs = flags.chain(words.iter().enumerate().map(|(at, word)| word ^ flip(at)));
        unit.clock(&inputs.collect::<Vec<i64>>());
        let Some((x, y)) = *place else { continue };
        let exact = wrapped(exact(x, y), N);
        assert_eq!(unit.output(0), exact, "{words:?} at ({x}, {y})");
        let golden = golden(*start, *line);
        assert_eq!(golden, i128::from(exact), "{words:?} at ({x}, {y})");
        pixels += 1;
    }
    pixels
}

/// The value of the next pixel of a golden processor, which begins a zone, a line, or neither.
fn driven<P>(
    start: impl Fn() -> P,
    line_step: fn(&mut P),
    pixel: fn(&mut P) -> i128,
) -> impl FnMut(bool, bool) -> i128 {
    let mut pe = start();
    move |starts, line| {
        match (starts, line) {
            (true, _) => pe = start(),
            (false, true) => line_step(&mut pe),
            _ => {}
        }
        pixel(&mut pe)
    }
}

/// Runs every zone of PE1 with these `a`; returns the pixels checked.
fn check_pe1<const N: usize>(a: i64, side: i64) -> u64 {
    let words_in = || raster::Linear::input(N as u32);
    let mut unit = Circuit::of(|| pe1("top", Flags::input(), words_in()));
    let clocks = zones(side, side);
    let pairs = words(N).flat_map(|b| words(N).map(move |c| (b, c)));
    let pixels = pairs.map(|(b, c)| {
        let words = Linear::new(a.into(), b.into(), c.into());
        let start = || GoldenPe1::object_start(&words, N as u32);
        let golden = driven(start, GoldenPe1::line_step, GoldenPe1::pixel);
        let exact = |x, y| a * x + b * y + c;
        check::<N>(&mut unit, &clocks, (&[a, b, c], 2..3), golden, exact)
    });
    pixels.sum()
}

/// Runs every zone of PE2 with these `a2` and `b2`; returns the pixels checked.
fn check_pe2<const N: usize>(a2: i64, b2: i64, side: i64) -> u64 {
    let words_in = || raster::Quadratic::input(N as u32);
    let mut unit = Circuit::of(|| pe2("top", Flags::input(), words_in()));
    let clocks = zones(side, side);
    let count = words(N).count();
    let pixels = (0..count.pow(4)).map(|code| {
        let digit = |place: u32| (code / count.pow(place) % count) as i64 + words(N).start;
        let (c, p0, i0, f) = (digit(0), digit(1), digit(2), digit(3));
        let (a, b) = (a2 / 2, b2 / 2);
        let (d, e) = (p0 - a, i0 - b);
        let words = Quadratic::new([a, b, c, d, e, f].map(i128::from));
        let start = || GoldenPe2::object_start(&words, N as u32);
        let golden = driven(start, GoldenPe2::line_step, GoldenPe2::pixel);
        let exact = |x, y| a * x * x + b * y * y + c * x * y + d * x + e * y + f;
        let words = [a2, b2, c, i0, p0, f];
        check::<N>(&mut unit, &clocks, (&words, 3..6), golden, exact)
    });
    pixels.sum()
}

/// Pixels of [`zones`]: one line and a pixel, then the whole.
fn pixels(side: u64) -> u64 {
    side + 1 + side * side
}

fn every_pe1<const N: usize>() {
    let started = Instant::now();
    let side = (1 << N) + 1;
    let list: Vec<i64> = words(N).collect();
    let count: u64 = list.par_iter().map(|a| check_pe1::<N>(*a, side)).sum();
    assert_eq!(count, (1 << (3 * N)) * pixels(side as u64));
    account(&format!("pe1 of {N} bits, pixels"), count, started);
}

fn every_pe2<const N: usize>(side: i64) {
    let started = Instant::now();
    let pairs: Vec<(i64, i64)> = even_words(N)
        .flat_map(|a2| even_words(N).map(move |b2| (a2, b2)))
        .collect();
    let run = |(a2, b2): &(i64, i64)| check_pe2::<N>(*a2, *b2, side);
    let count: u64 = pairs.par_iter().map(run).sum();
    assert_eq!(count, (1 << (6 * N - 2)) * pixels(side as u64));
    account(&format!("pe2 of {N} bits, pixels"), count, started);
}

#[test]
fn pe1_is_the_polynomial_for_all_words() {
    every_pe1::<2>();
    every_pe1::<3>();
    every_pe1::<4>();
    if is_full_run() {
        every_pe1::<5>();
    }
}

/// All pixels at 2 and 3 bits. At 4 bits, in the full run, four lines and columns, which use each increment at least
/// twice.
#[test]
fn pe2_is_the_polynomial_for_all_words() {
    every_pe2::<2>(5);
    every_pe2::<3>(9);
    if is_full_run() {
        every_pe2::<4>(4);
    }
}
