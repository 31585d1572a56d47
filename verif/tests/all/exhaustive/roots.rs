//! Exact roots: the emitted Verilog in Verilator, root and remainder of each radicand.
//!
//! The oracle takes no square root: radicands ascend, and `n` is counted up where the next square is reached, so that
//! `n^2 <= radicand < (n + 1)^2` holds by construction. Now and then num-bigint confirms it.

use super::{account, compile};
use crate::is_full_run;
use imogene_contract::Unit;
use imogene_verif::engine::verilator::Model;
use num_bigint::BigUint;
use rayon::prelude::*;
use std::time::Instant;

/// Parts of a run, worked on by all cores.
const PARTS: u64 = 64;
/// num-bigint is asked for every so manieth radicand; a prime, so that it meets all places of a square.
const SPOT: u64 = 10_007;

const PIPELINED: [Unit; 2] = [Unit::SquareRoot, Unit::SquareRootNonRestoring];

/// A radicand, its root and its remainder.
type Vector = [u64; 3];

/// All radicands from `first` to before `end`.
fn every(first: u64, end: u64) -> impl Iterator<Item = Vector> {
    let mut root = 0u64;
    while (root + 1) * (root + 1) <= first {
        root += 1;
    }
    (first..end).map(move |radicand| {
        if radicand == (root + 1) * (root + 1) {
            root += 1;
        }
        [radicand, root, radicand - root * root]
    })
}

/// The radicands about every square: `n^2 - 1`, `n^2` and `n^2 + 2n`, the first and last with root `n` and the last
/// before them.
fn boundaries(first: u64, end: u64) -> impl Iterator<Item = Vector> {
    (first..end).flat_map(|n| {
        let before = n.checked_sub(1).map(|less| [n * n - 1, less, 2 * less]);
        let ends = [[n * n, n, 0], [n * n + 2 * n, n, 2 * n]];
        before.into_iter().chain(ends)
    })
}

fn confirm(vector: Vector) {
    let root = BigUint::from(vector[0]).sqrt();
    assert_eq!(BigUint::from(vector[1]), root, "the oracle itself");
    let remainder = BigUint::from(vector[0]) - &root * &root;
    assert_eq!(BigUint::from(vector[2]), remainder, "the oracle itself");
}

/// Streams vectors through a pipeline, one a clock; returns how many results were compared.
fn stream(model: &Model, latency: usize, vectors: impl Iterator<Item = Vector>) -> u64 {
    let mut unit = model.instance();
    // A ring of the vectors in the pipeline; the edge that takes a radicand in is the first of its latency.
    let mut waiting: Vec<Option<Vector>> = vec![None; latency];
    let (mut place, mut given, mut compared) = (0, 0u64, 0u64);
    let mut found = [0; 2];
    let mut clock = |vector: Option<Vector>| {
        unit.clock_words(&[vector.map_or(0, |v| v[0])], &mut found);
        waiting[place] = vector;
        place = if place + 1 == latency { 0 } else { place + 1 };
        if let Some(due) = waiting[place] {
            assert_eq!(found, due[1..], "radicand {}", due[0]);
            compared += 1;
        }
    };
    for vector in vectors {
        if given.is_multiple_of(SPOT) {
            confirm(vector);
        }
        given += 1;
        clock(Some(vector));
    }
    // The last results leave while the pipeline is fed with nothing.
    for _ in 1..latency {
        clock(None);
    }
    assert_eq!(compared, given);
    compared
}

/// Gives the unit one radicand in K clocks; returns how many results were compared.
fn iterate(model: &Model, digits: usize, vectors: impl Iterator<Item = Vector>) -> u64 {
    let mut unit = model.instance();
    let mut compared = 0;
    let mut found = [0; 4];
    let mask = u64::MAX >> (64 - 2 * digits);
    for vector in vectors {
        if u64::is_multiple_of(compared, SPOT) {
            confirm(vector);
        }
        unit.clock_words(&[1, vector[0]], &mut found);
        for _ in 1..digits {
            // A start during the work, with another radicand, is to be ignored.
            assert_eq!(found[..2], [1, 0], "busy with radicand {}", vector[0]);
            unit.clock_words(&[1, !vector[0] & mask], &mut found);
        }
        let expected = [0, 1, vector[1], vector[2]];
        assert_eq!(found, expected, "radicand {}", vector[0]);
        compared += 1;
    }
    compared
}

/// Splits `0..end` over all cores and adds up the counts.
fn in_parts(end: u64, run: impl Fn(u64, u64) -> u64 + Sync) -> u64 {
    let bound = |part: u64| (u128::from(end) * u128::from(part) / u128::from(PARTS)) as u64;
    (0..PARTS)
        .into_par_iter()
        .map(|part| run(bound(part), bound(part + 1)))
        .sum()
}

/// Boundary vectors of `digits` digits in `unit`: three for each root, but none before 0.
fn check_boundaries(unit: Unit, digits: usize) {
    let (model, latency) = compile(unit.name(), digits as u32);
    let started = Instant::now();
    let count = in_parts(1 << digits, |first, end| match unit {
        Unit::SquareRootIterative => iterate(&model, digits, boundaries(first, end)),
        _ => stream(&model, latency, boundaries(first, end)),
    });
    assert_eq!(count, 3 * (1 << digits) - 1);
    let name = format!("{}, boundaries of {digits} digits", unit.name());
    account(&name, count, started);
}

#[test]
fn every_boundary_of_16_digits() {
    for unit in PIPELINED {
        check_boundaries(unit, 16);
    }
    check_boundaries(Unit::SquareRootIterative, 16);
}

/// With 24 digits: 50 million vectors in the full run, those of 20 digits otherwise.
#[test]
fn every_boundary_of_the_base_format() {
    let digits = if is_full_run() { 24 } else { 20 };
    for unit in PIPELINED {
        check_boundaries(unit, digits);
    }
    if is_full_run() {
        check_boundaries(Unit::SquareRootIterative, digits);
    }
}

/// All 2^32 radicands in the full run, the first and the last 2^20 otherwise.
#[test]
fn every_radicand_of_32_bits() {
    for unit in PIPELINED {
        let (model, latency) = compile(unit.name(), 16);
        let started = Instant::now();
        let run = |first, end| stream(&model, latency, every(first, end));
        let count = if is_full_run() {
            in_parts(1 << 32, run)
        } else {
            run(0, 1 << 20) + run((1 << 32) - (1 << 20), 1 << 32)
        };
        assert_eq!(count, if is_full_run() { 1 << 32 } else { 1 << 21 });
        let name = format!("{}, 32-bit radicands", unit.name());
        account(&name, count, started);
    }
}

/// The comparison is alive: an expected remainder with one wrong bit is reported with its radicand.
#[test]
fn a_wrong_remainder_is_found() {
    let (model, latency) = compile("square_root", 16);
    let wrong = |[of, root, rest]: Vector| [of, root, rest ^ u64::from(of == 120)];
    let wrong = || boundaries(1, 20).map(wrong);
    let outcome = std::panic::catch_unwind(|| stream(&model, latency, wrong()));
    let message = outcome.expect_err("radicand 120 is expected wrongly");
    let message = message.downcast_ref::<String>().expect("a message");
    assert!(message.contains("radicand 120"), "{message}");
}
