//! The source's elementary processors: interlaced and programmable.

use crate::common::*;
use imogene_golden::object::words::Words;
use imogene_golden::unit::interlaced::MemoryPe2;
use imogene_golden::unit::lattice::Lattice;
use imogene_golden::unit::pe1::Pe1;
use imogene_golden::unit::pe2::{Pe2, PreconditionedWords};
use imogene_golden::unit::programmable::*;

const WIDTH: usize = 9;
/// Clocks between two lines of a progressive picture: a line step, and three to the first pixel.
const PROGRESSIVE_LINE: u64 = 15;
/// Clocks between two lines of a field: the line step runs twice.
const INTERLACED_LINE: u64 = 27;
/// Clocks that restore, at the start of a field, the three words that lines change.
const RESTORE: u64 = 6;

/// Two words of `half` bits in one.
fn join(low: i128, high: i128, half: u32) -> i128 {
    let mask = (1 << half) - 1;
    wrap((high & mask) << half | (low & mask), 2 * half)
}

/// The words for up to four first-degree expressions of n bits; a lane without one is not asked.
fn split(lanes: &[Option<Linear>; LANES], half: u32) -> ProgrammableWords {
    let word = |low: usize, high: usize, part: fn(&Linear) -> i128| {
        let of = |lane: usize| lanes[lane].as_ref().map_or(0, part);
        join(of(low), of(high), half)
    };
    ProgrammableWords {
        split: true,
        words: PreconditionedWords {
            f: word(0, 1, |l| l.c),
            i0: word(0, 1, |l| l.b),
            b2: word(0, 1, |l| l.a),
            p0: word(2, 3, |l| l.c),
            c: word(2, 3, |l| l.b),
            a2: word(2, 3, |l| l.a),
        },
        used: lanes.each_ref().map(Option::is_some),
    }
}

fn line(pe: &mut MemoryPe2) -> Vec<i128> {
    pe.line_start();
    (0..WIDTH).map(|_| pe.pixel()).collect()
}

fn expected(q: &Quadratic, y: i64, width: u32) -> Vec<i128> {
    let value = |x| q.wrapped_at(x as i64, y, width);
    (0..WIDTH).map(value).collect()
}

/// The vectors of the restatement of the source, x and y from 1 there and from 0 here.
#[test]
fn memory_pe2_vectors_of_the_specification() {
    let q = Quadratic::new([2, 3, 1, -4, 5, 6]);
    let mut pe = MemoryPe2::progressive(&q.from_zone(1, 1), 48);
    assert_eq!(pe.memory_words(), 6);
    assert_eq!(line(&mut pe)[..4], [13, 16, 23, 34]);
    assert_eq!(line(&mut pe)[..4], [28, 32, 40, 52]);
    assert_eq!(line(&mut pe)[..4], [49, 54, 63, 76]);
    assert_eq!(pe.clocks(), 3 * (PROGRESSIVE_LINE + WIDTH as u64));
}

proptest! {
    /// Both fields, in any order and repeated, are the lines of the progressive picture, at the stated cost.
    #[test]
    fn fields_of_the_memory_pe2_interleave(
        q in any_quadratic(), width in 8u32..=64, fields in prop::collection::vec(0u32..2, 1..5), lines in 1i64..7
    ) {
        let mut pe = MemoryPe2::interlaced(&q, width);
        prop_assert_eq!(pe.memory_words(), 9);
        for field in fields {
            let before = pe.clocks();
            pe.field_start(field);
            for y in 0..lines {
                prop_assert_eq!(line(&mut pe), expected(&q, 2 * y + i64::from(field), width));
            }
            // The first line of field 0 is one step from the words.
            let steps = if field == 0 { PROGRESSIVE_LINE } else { INTERLACED_LINE };
            let rest = (lines as u64 - 1) * INTERLACED_LINE + lines as u64 * WIDTH as u64;
            prop_assert_eq!(pe.clocks() - before, RESTORE + steps + rest);
        }
        let mut pe = MemoryPe2::progressive(&q, width);
        for y in 0..lines {
            prop_assert_eq!(line(&mut pe), expected(&q, y, width));
        }
    }

    /// Groups of every n-th line, for the processors without a microprogram.
    #[test]
    fn words_of_every_nth_line_give_its_values(q in any_quadratic(), l in any_linear(), step in 1i64..5, width in 8u32..=64) {
        for first in 0..step {
            let mut pe2 = Pe2::object_start(&q.on(&Lattice::lines(step, first)), width);
            let mut pe1 = Pe1::object_start(&l.on(&Lattice::lines(step, first)), width);
            for y in 0..5 {
                if y > 0 {
                    pe2.line_step();
                    pe1.line_step();
                }
                for x in 0..5 {
                    prop_assert_eq!(pe2.pixel(), q.wrapped_at(x, step * y + first, width));
                    prop_assert_eq!(pe1.pixel(), l.wrapped_at(x, step * y + first, width));
                }
            }
        }
    }

    /// Two fields of a quadric with planes and normals, interleaved, are the progressive picture bit for bit.
    #[test]
    fn fields_of_a_quadric_interleave(
        f1 in any_linear(), planes in prop::collection::vec((any_linear(), prop::sample::select(&PlaneKind::ALL[..])), 0..4), g in [any_linear(), any_linear(), any_linear()],
        y0 in -2i64..14, y1 in -2i64..14
    ) {
        const SIDE: i64 = 12;
        let small = |l: Linear, bits: u32| Linear::new(wrap(l.a, bits), wrap(l.b, bits), wrap(l.c, bits + 4));
        let words = QuadricWords {
            class: Class::Side,
            screen_box: ScreenBox::of([1, 10], [y0, y1]),
            f1: small(f1, 8),
            f2: Quadratic::new([-150, -90, 31, 1800, 900, -3000]),
            normal: NormalWords { g, k: [300, -7000, 90], shift: 2 },
            planes: planes
                .iter()
                .map(|&(depth, kind)| PlaneWords::new(kind, small(depth, 8), [5, 6, 7]))
                .collect(),
        };
        let picture = |words: &QuadricWords, lines: i64| -> Vec<Vec<_>> {
            let line = |y: i64| (0..SIDE).map(move |x| words.at(x, y, &Format::BASE));
            (0..lines).map(|y| line(y).collect()).collect()
        };
        let whole = picture(&words, SIDE);
        for field in 0..2 {
            let half = picture(&words.on(&Lattice::lines(2, field)), SIDE / 2);
            for (y, line) in half.into_iter().enumerate() {
                prop_assert_eq!(line, whole[2 * y + field as usize].clone(), "line {} of field {}", y, field);
            }
        }
    }

    #[test]
    fn programmable_pe_is_a_pe2(q in any_quadratic(), half in 4u32..=32) {
        let width = 2 * half;
        let words = ProgrammableWords {
            split: false,
            words: q.preconditioned(width),
            used: [false; LANES],
        };
        let mut pe = Programmable::start(&words, half);
        each(&mut pe, |x, y, pixel| {
            let value = q.wrapped_at(x, y, width);
            prop_assert_eq!((pixel.value, pixel.inside), (value, value >= 0));
            Ok(())
        })?;
    }

    #[test]
    fn programmable_pe_is_four_pe1(
        lanes in [prop::option::of(any_linear()), prop::option::of(any_linear()), prop::option::of(any_linear()), prop::option::of(any_linear())],
        half in 4u32..=32
    ) {
        let mut pe = Programmable::start(&split(&lanes, half), half);
        each(&mut pe, |x, y, pixel| {
            let values: [i128; LANES] =
                std::array::from_fn(|i| lanes[i].map_or(0, |l| l.wrapped_at(x, y, half)));
            prop_assert_eq!(pixel.lanes, values);
            let absent = (0..LANES).any(|i| lanes[i].is_some() && values[i] < 0);
            prop_assert_eq!(pixel.inside, !absent);
            Ok(())
        })?;
    }
}

fn each(
    pe: &mut Programmable,
    mut check: impl FnMut(i64, i64, ProgrammablePixel) -> Result<(), TestCaseError>,
) -> Result<(), TestCaseError> {
    square(7).try_for_each(|(x, y)| {
        match (x, y) {
            (0, 0) => (),
            (0, _) => pe.next_line(),
            _ => pe.next_pixel(),
        }
        check(x, y, pe.pixel())
    })
}

/// Every pair of words of two halves of 3 bits: whole it is one adder, split it is two, and no carry crosses.
#[test]
fn split_adder_exhaustively() {
    for a in -32i128..32 {
        for b in -32i128..32 {
            assert_eq!(add(a, b, 3, false), wrap(a + b, 6));
            let halves = add(a, b, 3, true);
            assert_eq!(wrap(halves, 3), wrap(wrap(a, 3) + wrap(b, 3), 3));
            assert_eq!(halves >> 3, wrap((a >> 3) + (b >> 3), 3));
        }
    }
}

/// A lane that is not used says nothing; the mask of a facet is the AND of its edges.
#[test]
fn mask_of_a_triangle() {
    // x >= 2, y >= 1, x + y <= 7.
    let [left, top, right] =
        [[1, 0, -2], [0, 1, -1], [-1, -1, 7]].map(|[a, b, c]| Linear::new(a, b, c));
    let lanes = [Some(left), Some(top), None, Some(right)];
    let mut pe = Programmable::start(&split(&lanes, 24), 24);
    let mut inside = Vec::new();
    each(&mut pe, |x, y, pixel| {
        if pixel.inside {
            inside.push((x, y));
        }
        Ok(())
    })
    .unwrap();
    let expected = square(7).filter(|&(x, y)| x >= 2 && y >= 1 && x + y <= 7);
    assert_eq!(inside, expected.collect::<Vec<_>>());
}
