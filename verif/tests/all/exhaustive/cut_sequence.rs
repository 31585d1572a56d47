//! Up to four planes in every order, with every order and tie of the depths, through the golden model and the emitted
//! Verilog.
//!
//! **Ranks suffice.** A cut compares plane depths with the two depths of the interval, which are those it began with or
//! plane depths taken over, and with nothing else; the sign of a perpendicular plane is a case of its own. Two sets of
//! depths with the same weak ordering therefore pass through the same branches, so one set for each weak ordering of
//! `zf <= zb` and the depths of the front and back planes is complete. The one constant is the mark of an absent
//! object, the far end. No depth lies beyond it, so a front plane leaves the mark as it is, and a back plane leaves it
//! or sets it again: absent stays absent. Each ordering is laid out twice, with and without its last depth at the far
//! end.

use super::cut_single::KINDS;
use super::{account, compile};
use imogene_golden::format::Format;
use imogene_golden::unit::cut_plane::{PlaneKind, cut};
use imogene_golden::unit::depth_interval::Interval;
use imogene_verif::engine::verilator::VerilatedUnit;
use rayon::prelude::*;
use std::time::Instant;

const PLANES: usize = 4;
const DEPTH_WORD: u32 = 16;

#[derive(Clone, Copy, Debug)]
struct Plane {
    kind: PlaneKind,
    zp: i64,
    number: u8,
}

/// What a plane may be: with a depth among the others, or without.
#[derive(Clone, Copy, PartialEq)]
enum Choice {
    Front,
    Back,
    None,
    Misses,
    Keeps,
}

const CHOICES: [Choice; 5] = {
    use Choice::*;
    [Front, Back, None, Misses, Keeps]
};

/// Weak orderings of `count` values as ranks: each rank up to the greatest is taken by one value at least.
fn weak_orderings(count: usize) -> Vec<Vec<usize>> {
    let all = (0..count.pow(count as u32)).map(|code| {
        let rank = |place: usize| code / count.pow(place as u32) % count;
        (0..count).map(rank).collect::<Vec<_>>()
    });
    all.filter(|ranks| {
        let greatest = ranks.iter().max().copied().unwrap_or(0);
        (0..greatest).all(|rank| ranks.contains(&rank))
    })
    .collect()
}

/// All orders of some items.
pub(crate) fn permutations(items: &[usize]) -> Vec<Vec<usize>> {
    if items.is_empty() {
        return vec![vec![]];
    }
    let mut found = Vec::new();
    for (place, first) in items.iter().enumerate() {
        let rest = [&items[..place], &items[place + 1..]].concat();
        for order in permutations(&rest) {
            found.push([&[*first], &order[..]].concat());
        }
    }
    found
}

/// What is left, from the definitions alone, planes in the order of the list.
///
/// A solid is the intersection of its interval with half-lines; a face is the first in order that reached the final
/// depth. A surface is the set of its two faces, from which planes remove members.
fn oracle(start: Interval, planes: &[Plane], surface: bool, far: i64) -> Interval {
    let absent = Interval {
        zf: far,
        zb: far,
        nf: 0,
        nb: 0,
    };
    let of_kind = |kind: PlaneKind| planes.iter().filter(move |p| p.kind == kind);
    if of_kind(PlaneKind::Perpendicular).any(|p| p.zp < 0) {
        return absent;
    }
    let nearest = of_kind(PlaneKind::Front).map(|p| p.zp).max();
    let farthest = of_kind(PlaneKind::Back).map(|p| p.zp).min();
    if surface {
        let keeps = |z: i64| nearest.is_none_or(|n| z >= n) && farthest.is_none_or(|f| z <= f);
        let (zf, zb, nf, nb) = match (keeps(start.zf), keeps(start.zb)) {
            (true, true) => return start,
            (true, false) => (start.zf, start.zf, start.nf, start.nf),
            (false, true) => (start.zb, start.zb, start.nb, start.nb),
            (false, false) => return absent,
        };
        return Interval { zf, zb, nf, nb };
    }
    let zf = nearest.map_or(start.zf, |n| n.max(start.zf));
    let zb = farthest.map_or(start.zb, |f| f.min(start.zb));
    if zf > zb {
        return absent;
    }
    let face = |kind: PlaneKind, z: i64, before: i64, number: u8| {
        if z == before {
            return number;
        }
        let mut planes = of_kind(kind);
        planes.find(|p| p.zp == z).map_or(number, |p| p.number)
    };
    let nf = face(PlaneKind::Front, zf, start.zf, start.nf);
    let nb = face(PlaneKind::Back, zb, start.zb, start.nb);
    Interval { zf, zb, nf, nb }
}

/// The same cut in the hardware.
fn cut_in_hardware(
    unit: &mut VerilatedUnit,
    start: Interval,
    plane: Plane,
    surface: bool,
) -> Interval {
    let bits = |z: i64| z as u64 & (u64::MAX >> (64 - DEPTH_WORD));
    let value = |bits: u64| i64::from(bits as u16 as i16);
    let given = [
        KINDS.iter().position(|k| *k == plane.kind).expect("a kind") as u64,
        u64::from(surface),
        u64::from(plane.number),
        bits(plane.zp),
        bits(start.zf),
        u64::from(start.nf),
        bits(start.zb),
        u64::from(start.nb),
    ];
    let mut found = [0; 4];
    // Latency 2.
    for _ in 0..2 {
        unit.clock_words(&given, &mut found);
    }
    Interval {
        zf: value(found[0]),
        nf: found[1] as u8,
        zb: value(found[2]),
        nb: found[3] as u8,
    }
}

/// Depths for ranks: steps of different size, the last at `top`.
fn depths(ranks: &[usize], top: i64) -> Vec<i64> {
    let greatest = ranks.iter().max().copied().unwrap_or(0) as i64;
    let below = ranks.iter().map(|rank| greatest - *rank as i64);
    below.map(|below| top - below * (3 + below)).collect()
}

/// Every permutation of one set of planes; returns the permutations checked.
fn check(
    unit: &mut VerilatedUnit,
    start: Interval,
    planes: &[Plane],
    orders: &[Vec<usize>],
    format: &Format,
) -> u64 {
    for surface in [false, true] {
        let mut first: Option<(i64, i64)> = None;
        for order in orders {
            let ordered: Vec<Plane> = order.iter().map(|k| planes[*k]).collect();
            let expected = oracle(start, &ordered, surface, format.z_max());
            let (mut golden, mut found) = (start, start);
            for plane in &ordered {
                golden = cut(golden, plane.kind, plane.zp, plane.number, surface, format);
                found = cut_in_hardware(unit, found, *plane, surface);
            }
            let case = || format!("{ordered:?} of {start:?}, surface {surface}");
            assert_eq!(golden, expected, "golden, {}", case());
            assert_eq!(found, expected, "hardware, {}", case());
            let depths = (found.zf, found.zb);
            assert_eq!(*first.get_or_insert(depths), depths, "order, {}", case());
        }
    }
    2 * orders.len() as u64
}

/// The planes of the choices, those with a depth at `depths` in turn.
fn planes(choices: &[Choice], depths: &[i64]) -> Vec<Plane> {
    let mut own = depths.iter();
    let plane = |(choice, number): (&Choice, u8)| {
        let (kind, zp) = match choice {
            Choice::Front => (PlaneKind::Front, *own.next().expect("a depth")),
            Choice::Back => (PlaneKind::Back, *own.next().expect("a depth")),
            Choice::None => (PlaneKind::None, -1),
            Choice::Misses => (PlaneKind::Perpendicular, -1),
            Choice::Keeps => (PlaneKind::Perpendicular, 0),
        };
        Plane { kind, zp, number }
    };
    choices.iter().zip(2..).map(plane).collect()
}

/// Every ordering of the depths for one choice of planes; returns the sets and the permutations checked.
fn check_choice(
    unit: &mut VerilatedUnit,
    choices: &[Choice],
    orders: &[Vec<usize>],
    format: &Format,
) -> (u64, u64) {
    let has_depth = |c: &&Choice| matches!(c, Choice::Front | Choice::Back);
    let count = choices.iter().filter(has_depth).count();
    let (mut cases, mut runs) = (0, 0);
    let orderings = weak_orderings(count + 2);
    for ranks in orderings.iter().filter(|ranks| ranks[0] <= ranks[1]) {
        for top in [format.z_max(), 5] {
            let z = depths(ranks, top);
            let is_absent = z[0] == format.z_max();
            let start = Interval {
                zf: z[0],
                zb: z[1],
                nf: 0,
                nb: u8::from(!is_absent),
            };
            let planes = planes(choices, &z[2..]);
            runs += check(unit, start, &planes, orders, format);
            cases += 1;
        }
    }
    (cases, runs)
}

#[test]
fn every_order_and_tie_of_four_planes() {
    let started = Instant::now();
    let format = Format::new(DEPTH_WORD).expect("a format");
    let orders = permutations(&[0, 1, 2, 3]);
    let (model, _) = compile("cut_plane", DEPTH_WORD);
    let codes = 0..CHOICES.len().pow(PLANES as u32);
    let (cases, runs) = codes
        .into_par_iter()
        .map(|code| {
            let digit = |plane: usize| code / CHOICES.len().pow(plane as u32) % CHOICES.len();
            let choices: Vec<Choice> = (0..PLANES).map(|plane| CHOICES[digit(plane)]).collect();
            check_choice(&mut model.instance(), &choices, &orders, &format)
        })
        .reduce(|| (0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
    assert_eq!(cases, 2 * expected_cases());
    assert_eq!(runs, cases * 2 * 24);
    account("cut_plane, permutations of four planes", runs, started);
}

/// Sets of planes and orderings, counted without listing them: of `m` values there are `F(m)` weak orderings (Fubini
/// numbers 1, 1, 3, 13, 75, 541, 4683); with `zf <= zb` those where both are equal, `F(m - 1)`, and half of the others.
fn expected_cases() -> u64 {
    const FUBINI: [u64; 7] = [1, 1, 3, 13, 75, 541, 4683];
    const BINOMIAL: [u64; 5] = [1, 4, 6, 4, 1];
    (0..=PLANES)
        .map(|j| {
            let orderings = (FUBINI[j + 2] + FUBINI[j + 1]) / 2;
            BINOMIAL[j] * 2u64.pow(j as u32) * 3u64.pow((PLANES - j) as u32) * orderings
        })
        .sum()
}
