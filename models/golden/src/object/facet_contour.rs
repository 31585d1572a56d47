//! The baseline in software: a facet drawn by following its contour from line to line (source: Nyiri, 5.1; Chaillou,
//! IV.2.2, prefers the half-planes).
//!
//! As the source has it, the left and the right end of the span move by `-b / a` from line to line, and the increment
//! is switched at a corner. Here in integers: the quotient and the remainder of `-b / a` are added, with a carry, so
//! that the ends are exact on every line. Depth and normal are carried along the left end by the same steps, and along
//! the span by one addition each.
//!
//! The program starts from the words of the facet processor and draws the same pixels with the same words, as long as
//! the sides fit their words on the screen box, which the preparation proves.
//!
//! *Where the increment is switched.* On whole lines the ends of two left sides i and j are the ceilings of `e_i <=
//! e_j`, read from constants that were rounded to whole pixels without changing a sign. Were the order of the ceilings
//! the other way round, so would be that of the ends; so the greater end always has the greater ceiling, and the line
//! at which j passes i, one division, is one at which the contour may be switched.

use super::facet::{FACE_FACET, FacetWords};
use super::paraboloid::plane_guard;
use super::quadric::ObjectPixel;
use crate::format::Format;
use crate::unit::normal::LINEAR_WIDTH;
use crate::unit::pe1::Linear;
use num_integer::Integer;
use serde::Serialize;
use std::ops::AddAssign;

/// What a facet costs in software.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Operations {
    /// Facets.
    pub facets: u64,
    /// Lines that are visited.
    pub lines: u64,
    /// Pixels of the spans.
    pub pixels: u64,
    /// Additions and subtractions at the pixels: depth, three of the normal, column.
    pub pixel_additions: u64,
    /// Additions and subtractions at the lines: both ends with their remainders and carries, depth and normal of the
    /// first pixel.
    pub line_additions: u64,
    /// Comparisons: the end of the span and both ends of the depth word at a pixel; carries, corners and an empty span
    /// at a line.
    pub tests: u64,
    /// Multiplications, of the set-up and of spans that begin left of the box.
    pub multiplications: u64,
    /// Divisions, of the set-up.
    pub divisions: u64,
}

impl AddAssign for Operations {
    fn add_assign(&mut self, other: Operations) {
        self.facets += other.facets;
        self.lines += other.lines;
        self.pixels += other.pixels;
        self.pixel_additions += other.pixel_additions;
        self.line_additions += other.line_additions;
        self.tests += other.tests;
        self.multiplications += other.multiplications;
        self.divisions += other.divisions;
    }
}

/// One end of the spans along one side of the facet, as seen from the left; the right end is that of the mirrored side.
#[derive(Clone, Copy, Debug)]
struct Follower {
    /// Column before the first one of the span.
    before: i64,
    /// Steps of `1 / a` from there to the side, 0 to a - 1.
    rest: i64,
    a: i64,
    step: i64,
    rest_step: i64,
}

impl Follower {
    /// The side `a x + b y + c >= 0` with a > 0 at line `y`: the span begins at `ceil(-(b y + c) / a)`.
    fn start(side: &Linear, y: i64) -> Follower {
        let (before, rest) = (-(side.b * i128::from(y) + side.c) - 1).div_mod_floor(&side.a);
        let (step, rest_step) = (-side.b).div_mod_floor(&side.a);
        Follower {
            before: before as i64,
            rest: rest as i64,
            a: side.a as i64,
            step: step as i64,
            rest_step: rest_step as i64,
        }
    }

    /// The next line; true if the remainder was carried.
    #[inline]
    fn line_step(&mut self) -> bool {
        self.before += self.step;
        self.rest += self.rest_step;
        let carry = self.rest >= self.a;
        if carry {
            self.rest -= self.a;
            self.before += 1;
        }
        carry
    }
}

/// The sides that bound one end of the spans from the first line on, and the line at which each begins to.
#[derive(Clone, Debug)]
struct Chain {
    sides: Vec<(i64, Linear)>,
    next: usize,
    divisions: u64,
}

impl Chain {
    /// The chain of sides with a > 0: the greatest end on every line from 0 on. Its slopes grow from side to side.
    fn new(mut sides: Vec<Linear>) -> Chain {
        // -b / a ascending.
        sides.sort_by(|p, q| (q.b * p.a).cmp(&(p.b * q.a)));
        let mut chain: Vec<(i64, Linear)> = vec![];
        let mut divisions = 0;
        for side in sides {
            let mut from = 0;
            while let Some((since, last)) = chain.last() {
                divisions += 1;
                from = passes(last, &side);
                if from > *since {
                    break;
                }
                chain.pop();
                from = 0;
            }
            chain.push((from, side));
        }
        Chain {
            sides: chain,
            next: 0,
            divisions,
        }
    }

    /// The follower that begins at line `y`, if one does.
    #[inline]
    fn follower_from(&mut self, y: i64) -> Option<Follower> {
        let (from, side) = self.sides.get(self.next)?;
        (*from == y).then(|| {
            self.next += 1;
            Follower::start(side, y)
        })
    }
}

/// The first line from 0 on at which the end of `later`, whose slope is not less, is not before that of `sooner`.
fn passes(sooner: &Linear, later: &Linear) -> i64 {
    let slope = later.a * sooner.b - sooner.a * later.b;
    let lead = later.c * sooner.a - sooner.c * later.a;
    let line = match (slope, lead) {
        (0, lead) if lead <= 0 => 0,
        (0, _) => i128::from(i64::MAX),
        _ => Integer::div_ceil(&lead, &slope),
    };
    line.clamp(0, i64::MAX.into()) as i64
}

/// A first-degree value in the top bits of a word, which then wraps by itself.
#[derive(Clone, Copy, Debug)]
struct Carried {
    per_pixel: i64,
    per_line: i64,
    at_origin: i64,
}

impl Carried {
    fn new(words: &Linear, width: u32) -> Carried {
        let top = |v: i128| (v << (i64::BITS - width)) as i64;
        Carried {
            per_pixel: top(words.a),
            per_line: top(words.b),
            at_origin: top(words.c),
        }
    }

    fn at(&self, x: i64, y: i64) -> i64 {
        let line = self.at_origin.wrapping_add(self.per_line.wrapping_mul(y));
        line.wrapping_add(self.per_pixel.wrapping_mul(x))
    }

    /// What a step to the next line adds if the span begins `columns` further to the right there.
    fn along(&self, columns: i64) -> i64 {
        self.per_line
            .wrapping_add(self.per_pixel.wrapping_mul(columns))
    }
}

/// Depth, then the three components of the normal.
const VALUES: usize = 4;
/// Depth, normal and column.
const PIXEL_ADDITIONS: u64 = VALUES as u64 + 1;
/// End of the span, near and far end of the depth word.
const PIXEL_TESTS: u64 = 3;
/// Two additions for each end, one for each value.
const LINE_ADDITIONS: u64 = 4 + VALUES as u64;
/// A carry and a corner for each end, end of the box, empty span, both sides of the box.
const LINE_TESTS: u64 = 8;

/// One span of the facet, relative to the screen box: columns `first` to `last`, both ends included, and the values at
/// `first`.
struct Span {
    y: i64,
    first: i64,
    last: i64,
    values: [i64; VALUES],
}

/// The sides of a facet sorted into its left and right contour, and its increments.
#[derive(Clone, Debug)]
pub struct FacetContour {
    left: Chain,
    right: Chain,
    first: (i64, i64),
    width: i64,
    /// Lines of the box that no side along a line takes away.
    lines: std::ops::Range<i64>,
    values: [Carried; VALUES],
    depth_shift: u32,
    ends: [i64; 2],
}

/// The contour being followed.
#[derive(Default)]
struct Walk {
    left: Option<Follower>,
    right: Option<Follower>,
    /// The values at the pixel after `left.before`, and what they grow by from line to line, without and with a carry.
    values: [i64; VALUES],
    growth: [[i64; VALUES]; 2],
}

impl FacetContour {
    /// Sets up the facet of these words, as the facet processor is loaded with them.
    pub fn new(words: &FacetWords, format: &Format) -> FacetContour {
        let window = words.screen_box;
        let [width, height] = window.size();
        let mut lines = 0..height;
        let (mut left, mut right) = (vec![], vec![]);
        for side in &words.edges {
            // True values at the first pixel of the box, whatever the words were before they were cut to their width.
            let side = Linear {
                c: side.wrapped_at(window.x0, window.y0, format.plane),
                ..side.wrapped(format.plane)
            };
            match side.a {
                0 => clip(&mut lines, &side),
                1.. => left.push(side),
                _ => right.push(Linear { a: -side.a, ..side }),
            }
        }
        let moved = |words: &Linear| words.from_zone(window.x0, window.y0);
        let normal = |n: &Linear| Carried::new(&moved(n), LINEAR_WIDTH);
        let [nx, ny, nz] = words.normal.each_ref().map(normal);
        FacetContour {
            left: Chain::new(left),
            right: Chain::new(right),
            first: (window.x0, window.y0),
            width,
            lines,
            values: [Carried::new(&moved(&words.depth), format.plane), nx, ny, nz],
            depth_shift: i64::BITS - format.plane + plane_guard(format),
            ends: [format.z_low(), format.z_max()],
        }
    }

    /// Calls `sink(x, y, pixel)` for every pixel at which the facet is present, line by line, left to right.
    pub fn for_each_pixel(&self, mut sink: impl FnMut(i64, i64, ObjectPixel)) {
        let [near, far] = self.ends;
        let steps = self.values.map(|v| v.per_pixel);
        let draw = |span: Span| {
            let mut values = span.values;
            for x in span.first..=span.last {
                let z = values[0] >> self.depth_shift;
                if z >= near && z < far {
                    let [_, nx, ny, nz] = values.map(|v| (v >> 48) as i16);
                    let pixel = ObjectPixel {
                        zf: z,
                        zb: z,
                        number: FACE_FACET,
                        normal: [nx, ny, nz],
                    };
                    sink(self.first.0 + x, self.first.1 + span.y, pixel);
                }
                for (value, step) in values.iter_mut().zip(steps) {
                    *value = value.wrapping_add(step);
                }
            }
        };
        self.walk(|_, _, _| (), draw);
    }

    /// What the facet costs: [`Self::for_each_pixel`] counted, without the set-up of its words.
    pub fn operations(&self) -> Operations {
        let mut count = Operations {
            facets: 1,
            divisions: self.left.divisions + self.right.divisions,
            ..Operations::default()
        };
        // Each division that looks for a corner divides a difference of two products by another.
        count.multiplications += 4 * count.divisions;
        let mut pixels = 0;
        self.walk(
            |carries, corners, clipped| {
                count.lines += 1;
                count.line_additions += LINE_ADDITIONS + 2 * carries;
                count.tests += LINE_TESTS;
                // Start and step of the end; values and their growth.
                count.divisions += 2 * corners;
                count.multiplications += (1 + 3 * VALUES as u64) * corners + clipped;
            },
            |span| pixels += (span.last - span.first + 1) as u64,
        );
        count.pixels = pixels;
        count.pixel_additions = PIXEL_ADDITIONS * pixels;
        count.tests += PIXEL_TESTS * pixels;
        count
    }

    /// Follows the contour; `line` gets the carries, the new sides and the multiplications of each line.
    #[inline]
    fn walk(&self, mut line: impl FnMut(u64, u64, u64), mut span: impl FnMut(Span)) {
        let (mut left, mut right) = (self.left.clone(), self.right.clone());
        let mut at = Walk::default();
        for y in 0..self.lines.end {
            let carries = at.line_step();
            let corners = self.turn(&mut at, y, &mut left, &mut right);
            let (Some(l), Some(r)) = (at.left, at.right) else {
                // A facet has an area, so both ends have a side; an empty box has no line.
                return;
            };
            let hidden = (-(l.before + 1)).max(0);
            line(carries, corners, if hidden > 0 { VALUES as u64 } else { 0 });
            let first = l.before + 1 + hidden;
            let last = (-(r.before + 1)).min(self.width - 1);
            if y >= self.lines.start && first <= last {
                let mut values = at.values;
                if hidden > 0 {
                    for (value, carried) in values.iter_mut().zip(&self.values) {
                        *value = value.wrapping_add(carried.per_pixel.wrapping_mul(hidden));
                    }
                }
                span(Span {
                    y,
                    first,
                    last,
                    values,
                });
            }
        }
    }

    /// Switches to the sides that begin at this line; how many did.
    fn turn(&self, at: &mut Walk, y: i64, left: &mut Chain, right: &mut Chain) -> u64 {
        let mut corners = 0;
        if let Some(follower) = left.follower_from(y) {
            at.values = self.values.map(|v| v.at(follower.before + 1, y));
            let growth = |carry: i64| self.values.map(|v| v.along(follower.step + carry));
            at.growth = [growth(0), growth(1)];
            at.left = Some(follower);
            corners += 1;
        }
        if let Some(follower) = right.follower_from(y) {
            at.right = Some(follower);
            corners += 1;
        }
        corners
    }
}

impl Walk {
    #[inline]
    fn line_step(&mut self) -> u64 {
        let mut carries = 0;
        if let Some(left) = &mut self.left {
            let carry = left.line_step();
            let growth = self.growth[usize::from(carry)];
            for (value, step) in self.values.iter_mut().zip(growth) {
                *value = value.wrapping_add(step);
            }
            carries += u64::from(carry);
        }
        if let Some(right) = &mut self.right {
            carries += u64::from(right.line_step());
        }
        carries
    }
}

/// Takes away the lines at which `b y + c` is negative.
fn clip(lines: &mut std::ops::Range<i64>, side: &Linear) {
    let bound = |v: i128| v.clamp(-1, 1 << 40) as i64;
    match side.b {
        0 if side.c >= 0 => (),
        0 => lines.end = lines.start,
        1.. => lines.start = lines.start.max(bound(Integer::div_ceil(&-side.c, &side.b))),
        _ => {
            let last = bound(Integer::div_floor(&side.c, &-side.b));
            lines.end = lines.end.min(last + 1);
        }
    }
}
