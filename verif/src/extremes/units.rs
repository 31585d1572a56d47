//! Extremes of single units: the words themselves at their ends.

use super::processors::DEPTHS;
use super::{Extreme, driven};
use crate::signal::Signal;
use crate::subject::{Inputs, Subject};
use imogene_contract::Unit;

#[rustfmt::skip]
pub const CASES: &[Extreme] = &[
    driven("17.3", "f2-at-the-ends-of-its-word", Unit::QuadricPe, f2_ends,
        "f2 = 0, 1, 2^47 - 1: inside, with the roots 0, 1 and 11863283; f2 = -1, -2^47: outside. Presence is the sign bit, so that zero is inside."),
    driven("17.10", "smallest-radicands", Unit::SquareRootLinear, smallest_radicands,
        "Radicands 0 to 15 in the piecewise linear root: the floors of short words take over from the percentages; hardware and golden model floor at the same places."),
    driven("17.10", "radicands-at-powers-of-four", Unit::SquareRootQuadratic, powers_of_four,
        "4^m - 1, 4^m, 4^m + 1 and the same of 2 * 4^m, up to the top bit: the places where the pair of octaves of an approximation changes."),
    driven("17.10", "squares-and-their-neighbours", Unit::SquareRoot, squares,
        "n^2 - 1, n^2, n^2 + 2n at both ends of the root and at every power of two: the only places where floor(sqrt) can step wrongly."),
    driven("17.6", "plane-ties", Unit::CutPlane, plane_ties,
        "zp = zf, zp = zb, zf = zb, all three equal, at both ends of the word, for every kind of plane: the tests are closed, so a face in the plane stays."),
    driven("17.5", "plane-slope-of-one", Unit::PlaneDepth, plane_slopes,
        "A plane of slope 0, +1 and -1 of the last place: depth steps by exactly one word a pixel through zero."),
    driven("17.5", "plane-past-its-word", Unit::PlaneDepth, plane_past_its_word,
        "A plane whose depth runs over both ends of the depth word: it is clamped one below the near end and at the far end, its sign kept, so that it removes all or nothing instead of wrapping."),
    driven("17.12", "lines-after-the-last", Unit::Pe2, lines_after_the_last,
        "Line steps after the last line of a zone go on with the polynomial modulo 2^48: nothing but a start loads anew."),
    driven("17.15", "normal-without-length", Unit::NormalUnit, normal_words,
        "K = 0 and g = 0 on every component, at every root: the normal is (0, 0, 0), an apex; with the greatest negative words the sum wraps as stated and nothing else happens."),
    driven("17.4", "roots-past-the-depth-word", Unit::QuadricCut, past_the_depth_word,
        "f1 - r and f1 + r at and beside both ends of the depth word in all four classes: clamped where a solid reaches past an end, absent where all of it lies beyond."),
];

/// The least and greatest words of a signed port, and those about zero.
pub(super) fn ends(signal: &Signal) -> [i64; 7] {
    let half = 1i64 << (signal.width - 1);
    [-half, -half + 1, -1, 0, 1, half - 2, half - 1]
}

/// Every combination of a value of each list, the last list fastest.
pub(super) fn every<const N: usize>(lists: [&[i64]; N]) -> impl Iterator<Item = [i64; N]> {
    let count: usize = lists.iter().map(|list| list.len()).product();
    (0..count).map(move |mut rest| {
        let mut one = [0; N];
        for (value, list) in one.iter_mut().zip(lists).rev() {
            *value = list[rest % list.len()];
            rest /= list.len();
        }
        one
    })
}

/// Inputs with some ports set and the others zero.
pub(super) fn inputs(subject: &Subject, set: &[(&str, i64)]) -> Inputs {
    let value = |signal: &Signal| {
        let found = set.iter().find(|(name, _)| *name == signal.name);
        found.map_or(0, |&(_, value)| value)
    };
    let is_port = |name: &str| subject.inputs.iter().any(|signal| signal.name == name);
    debug_assert!(set.iter().all(|(name, _)| is_port(name)));
    subject.inputs.iter().map(value).collect()
}

/// Clocks that carry nothing, until the last result is out.
fn flushed(subject: &Subject, mut stimulus: Vec<Inputs>) -> Vec<Inputs> {
    stimulus.extend(std::iter::repeat_n(inputs(subject, &[]), 40));
    stimulus
}

fn f2_ends(subject: &Subject) -> Vec<Inputs> {
    // The f1 processor starts later than the f2 processor, so each start is followed by a pause.
    let starts = [0, 1, (1 << 47) - 1, -1, -(1 << 47)].map(|f2| {
        let start = [("valid", 1), ("start", 1), ("f2_f", f2)];
        let mut clocks = vec![inputs(subject, &[("f2_f", f2)]); 41];
        clocks[0] = inputs(subject, &start);
        clocks
    });
    starts.concat()
}

fn radicands(subject: &Subject, values: impl Iterator<Item = u64>) -> Vec<Inputs> {
    let one = |value: u64| inputs(subject, &[("radicand", value as i64)]);
    flushed(subject, values.map(one).collect())
}

fn smallest_radicands(subject: &Subject) -> Vec<Inputs> {
    radicands(subject, 0..16)
}

/// The powers of two of so many places, and what is beside them.
fn powers(places: u32) -> impl Iterator<Item = u64> {
    let powers = (0..places).map(|place| 1u64 << place);
    powers.flat_map(|power| [power - 1, power, power + 1])
}

fn powers_of_four(subject: &Subject) -> Vec<Inputs> {
    radicands(subject, powers(48).chain([(1 << 48) - 1]))
}

fn squares(subject: &Subject) -> Vec<Inputs> {
    let last = (1u64 << 24) - 1;
    let around = |n: u64| [(n * n).saturating_sub(1), n * n, n * n + 2 * n];
    let roots = powers(24).chain([last - 1, last]);
    radicands(subject, roots.flat_map(around))
}

fn plane_ties(subject: &Subject) -> Vec<Inputs> {
    let words = ends(&subject.inputs[3]);
    let all = every([&[0, 1, 2, 3], &[0, 1], &words, &words, &words]);
    let ordered = all.filter(|[_, _, zf, zb, _]| zb >= zf);
    let one = |[kind, surface, zf, zb, zp]: [i64; 5]| {
        let set = [
            ("kind", kind),
            ("surface", surface),
            ("number", 5),
            ("zp", zp),
            ("zf", zf),
            ("zb", zb),
            ("nb", 1),
        ];
        inputs(subject, &set)
    };
    ordered.map(one).collect()
}

/// One line of `pixels` pixels of a plane.
fn plane_line(subject: &Subject, a: i64, c: i64, pixels: usize) -> Vec<Inputs> {
    let mut line = vec![inputs(subject, &[("valid", 1), ("a", a), ("c", c)]); pixels];
    line[0] = inputs(subject, &[("valid", 1), ("start", 1), ("a", a), ("c", c)]);
    line
}

fn plane_slopes(subject: &Subject) -> Vec<Inputs> {
    let lines = [(0, 0), (1, -20), (-1, 20)];
    let lines = lines.map(|(a, c)| plane_line(subject, a, c, 41));
    flushed(subject, lines.concat())
}

fn plane_past_its_word(subject: &Subject) -> Vec<Inputs> {
    let far = 1i64 << 23;
    let through = (far - 1) / 40;
    let lines = [
        (1, far - 20),
        (-1, 20 - far),
        (through, -2 * far),
        (-through, 2 * far),
        (0, (1 << 35) - 1),
        (0, -(1 << 35)),
    ];
    let lines = lines.map(|(a, c)| plane_line(subject, a, c, 200));
    flushed(subject, lines.concat())
}

fn lines_after_the_last(subject: &Subject) -> Vec<Inputs> {
    let words = [
        ("a2", 6),
        ("b2", -10),
        ("c", 7),
        ("p0", 1 << 40),
        ("i0", -(1 << 45)),
        ("f", (1 << 47) - 5),
    ];
    let with = |flags: &[(&str, i64)]| inputs(subject, &[flags, &words].concat());
    let mut line = vec![with(&[("valid", 1)]); 4];
    line[0] = with(&[("valid", 1), ("line", 1)]);
    let first = with(&[("valid", 1), ("start", 1)]);
    [vec![first], vec![line; 64].concat()].concat()
}

fn normal_words(subject: &Subject) -> Vec<Inputs> {
    let words = [
        (0, 0),
        (0, -(1 << 15)),
        (-(1 << 23), 0),
        (-(1 << 23), -(1 << 15)),
        ((1 << 23) - 1, -(1 << 15)),
    ];
    let all = every([&[0, 1, 2, 3, 4], &[0, 1, (1 << 24) - 1], &[0, 1, 2, 15]]);
    let one = |[pair, root, number]: [i64; 3]| {
        let (g, k) = words[pair as usize];
        let set = [
            ("valid", 1),
            ("start", 1),
            ("number", number),
            ("root", root),
            ("gx_c", g),
            ("gy_c", g),
            ("gz_c", g),
            ("kx", k),
            ("ky", k),
            ("kz", k),
        ];
        inputs(subject, &set)
    };
    flushed(subject, all.map(one).collect())
}

fn past_the_depth_word(subject: &Subject) -> Vec<Inputs> {
    let sums = [[-(1 << 25)], [(1 << 25) - 1]];
    let depths = [&sums[0], &DEPTHS[..10], &sums[1]].concat();
    let all = every([&[0, 1, 2, 3], &depths, &depths, &[0, 1]]);
    let ordered = all.filter(|[_, near, far, _]| near <= far);
    let one = |[class, near, far, inside]: [i64; 4]| {
        let set = [
            ("near_sum", near),
            ("far_sum", far),
            ("is_inside", inside),
            ("in_box", 1),
            ("object_class", class),
            // The limits of no plane.
            ("front", -(1 << 23)),
            ("back", (1 << 23) - 1),
        ];
        inputs(subject, &set)
    };
    flushed(subject, ordered.map(one).collect())
}
