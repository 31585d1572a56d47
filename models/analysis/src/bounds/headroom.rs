//! Headroom: silhouette and depth errors of a scene in a format, and the guard bits of f2 that it needs, or could do
//! without.
//!
//! A *silhouette error* is a pixel of an object's box at which the sign of the rounded f2 is not that of the exact one.
//! They are counted at every pixel of every object's box, hidden or not, against signs in big integers. With g guard
//! bits (below zero: bits dropped) the rounding error at a pixel (u, v) away from the anchor is at most `(u^2 + v^2 +
//! |u v| + |u| + |v| + 1) / 2^(g + 1)`, so a pixel whose true `|f2|` is greater has the right sign with g bits and with
//! any more. The least g for which this holds at every pixel is *derived*; it is sufficient. Counting down from it
//! until errors appear gives the least that is *confirmed*.

use crate::exact::ray::second_degree;
use imogene_algebra::rational::{integer, power_of_two, to_f64};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::depth_interval::Class;
use imogene_prepare::forms::{LinearForm, QuadraticForm};
use imogene_prepare::rounding::round_quadratic;
use imogene_prepare::{PreparedQuadric, PreparedScene};
use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use rayon::prelude::*;
use serde::Serialize;

/// Fewest guard bits that are tried: this many bits of f2 dropped leave no picture of any format.
pub const FEWEST: i32 = -64;

/// Errors and needs of a scene in a format without guard bits.
#[derive(Clone, Debug, Serialize)]
pub struct Headroom {
    /// Pixels per line.
    pub width: u32,
    /// Lines.
    pub height: u32,
    /// Depth word.
    pub depth_word: u32,
    /// Pixels of all boxes.
    pub pixels: u64,
    /// Pixels at which the rounded f2 has the wrong sign, without guard bits.
    pub silhouette_errors: u64,
    /// Pixels at which the true f2 is exactly zero: on the silhouette, present by definition. No number of guard bits
    /// is derived for them.
    pub ties: u64,
    /// Greatest error of a near or far depth within the depth range, in depth words, without guard bits.
    pub depth_max_lsb: f64,
    /// Root of the mean square of these errors.
    pub depth_rms_lsb: f64,
    /// Depths that entered.
    pub depths: u64,
    /// Guard bits of f2 that are proven to leave no error where f2 is not zero; below zero, bits that can be dropped.
    pub derived: i32,
    /// Fewest guard bits of f2 from which on, up to the derived number, no error is counted; none if ties are rounded
    /// away even with the derived number.
    pub confirmed: Option<i32>,
    /// Errors counted with one bit less; none without a silhouette on the screen, whatever is dropped.
    pub errors_with_one_less: u64,
}

/// Errors and needs of several scenes at one size in one format.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Pixels per line.
    pub width: u32,
    /// Lines.
    pub height: u32,
    /// Depth word.
    pub depth_word: u32,
    /// Pixels of all boxes.
    pub pixels: u64,
    /// Pixels at which the rounded f2 has the wrong sign, without guard bits.
    pub silhouette_errors: u64,
    /// Scenes with any such pixel.
    pub scenes_with_errors: usize,
    /// Greatest depth error, in depth words, without guard bits.
    pub depth_max_lsb: f64,
    /// Root of the mean square of all depth errors.
    pub depth_rms_lsb: f64,
    /// Guard bits of f2 that are proven to be enough for every scene.
    pub derived: i32,
    /// Fewest guard bits of f2 from which on no scene has an error; none if one has ties that are rounded away.
    pub confirmed: Option<i32>,
    /// Errors of all scenes that need that number, with one bit less.
    pub errors_with_one_less: u64,
}

/// Sums up the rows of each size and format, in the order in which these first appear.
pub fn summaries(rows: &[Headroom]) -> Vec<Summary> {
    let key = |h: &Headroom| (h.width, h.height, h.depth_word);
    let mut groups: Vec<Vec<&Headroom>> = vec![];
    for row in rows {
        match groups.iter_mut().find(|group| key(group[0]) == key(row)) {
            Some(group) => group.push(row),
            None => groups.push(vec![row]),
        }
    }
    groups.iter().map(|group| summary(group)).collect()
}

fn summary(rows: &[&Headroom]) -> Summary {
    let depths: u64 = rows.iter().map(|h| h.depths).sum();
    let squared = |h: &&Headroom| h.depth_rms_lsb.powi(2) * h.depths as f64;
    let squares: f64 = rows.iter().map(squared).sum();
    // `None` if any scene has nothing.
    let needs: Option<Vec<i32>> = rows.iter().map(|h| h.confirmed).collect();
    let confirmed = needs.and_then(|bits| bits.into_iter().max());
    let limiting = rows.iter().filter(|h| h.confirmed == confirmed);
    Summary {
        width: rows[0].width,
        height: rows[0].height,
        depth_word: rows[0].depth_word,
        pixels: rows.iter().map(|h| h.pixels).sum(),
        silhouette_errors: rows.iter().map(|h| h.silhouette_errors).sum(),
        scenes_with_errors: rows.iter().filter(|h| h.silhouette_errors > 0).count(),
        depth_max_lsb: rows.iter().map(|h| h.depth_max_lsb).fold(0.0, f64::max),
        depth_rms_lsb: (squares / depths.max(1) as f64).sqrt(),
        derived: rows.iter().map(|h| h.derived).max().expect("a row"),
        confirmed,
        errors_with_one_less: limiting.map(|h| h.errors_with_one_less).sum(),
    }
}

/// Counts errors and needs; `prepared` must have no guard bits.
pub fn headroom(prepared: &PreparedScene) -> Headroom {
    let objects = prepared.quadrics().map(|(_, object)| object);
    let on_screen = objects.filter(|o| !o.words.screen_box.is_empty());
    let subjects = on_screen.map(|object| {
        let at = |x, y| ScreenBox::of([x, x], [y, y]);
        let bound = |x, y| object.anchor.quadratic_bound(&at(x, y));
        let signs = true_signs(&object.exact.f2, &object.words.screen_box, bound);
        Subject { object, signs }
    });
    let objects: Vec<Subject> = subjects.collect();
    let risk = objects.iter().map(|o| o.signs.risk).fold(0.0, f64::max);
    let derived = bits_above(risk);
    let count = |guards: i32| objects.iter().map(|o| o.errors(guards)).sum::<u64>();
    let (mut confirmed, mut errors_with_one_less) = (None, 0);
    for guards in (FEWEST..=derived).rev() {
        errors_with_one_less = count(guards);
        if errors_with_one_less > 0 {
            break;
        }
        confirmed = Some(guards);
    }
    let boxes = objects.iter().map(|o| &o.object.words.screen_box);
    let depths = |o: &Subject| depth_errors(o.object, &o.signs.present, &prepared.format);
    let depths = DepthErrors::of_all(objects.iter().map(depths));
    Headroom {
        width: prepared.width,
        height: prepared.height,
        depth_word: prepared.format.depth,
        pixels: boxes.map(|window| window.pixels()).sum(),
        silhouette_errors: count(0),
        ties: objects.iter().map(|o| o.signs.ties).sum(),
        depth_max_lsb: depths.most,
        depth_rms_lsb: (depths.squares / depths.count.max(1) as f64).sqrt(),
        depths: depths.count,
        derived,
        confirmed,
        errors_with_one_less,
    }
}

/// The least magnitude of the true f2 at a pixel of the object's screen box, rounded down; zero if it is zero at one.
/// Endless if the box is empty.
pub(super) fn least_f2(object: &PreparedQuadric) -> f64 {
    let signs = true_signs(&object.exact.f2, &object.words.screen_box, |_, _| 1.0);
    if signs.ties > 0 {
        return 0.0;
    }
    signs.risk.recip() * (1.0 - 1e-9)
}

/// The guard bits that a risk asks for: the least g with `risk < 2^g`, a last bit of it counted as one more.
pub fn bits_above(risk: f64) -> i32 {
    let is_above = |bits: &i32| f64::from(*bits).exp2() > risk * (1.0 + 1e-9);
    (FEWEST..).find(is_above).expect("a finite risk")
}

struct Subject<'a> {
    object: &'a PreparedQuadric,
    signs: TrueSigns,
}

impl Subject<'_> {
    /// Pixels at which f2 rounded with this many guard bits, below zero with bits dropped, has the wrong sign.
    fn errors(&self, guards: i32) -> u64 {
        let unit = power_of_two(guards.unsigned_abs());
        let unit = if guards < 0 { unit.recip() } else { unit };
        let scaled = self.object.exact.f2.scaled(&unit);
        let rounded = round_quadratic(&scaled, self.object.anchor);
        let rounded = rounded.expect("prepared words leave room");
        let window = &self.object.words.screen_box;
        lines(window, &self.signs.present)
            .map(|(y, line)| {
                let at = |x: i64| rounded.wrapped_at(x, y, 127);
                let mut value = at(window.x0);
                let mut step = at(window.x0 + 1) - value;
                let mut errors = 0;
                for &present in line {
                    errors += u64::from((value >= 0) != present);
                    value += step;
                    step += 2 * rounded.a;
                }
                errors
            })
            .sum()
    }
}

fn lines<'a>(
    window: &ScreenBox,
    present: &'a [bool],
) -> impl IndexedParallelIterator<Item = (i64, &'a [bool])> + use<'a> {
    let (width, first) = ((window.x1 - window.x0 + 1) as usize, window.y0);
    let lines = present.par_chunks(width).enumerate();
    lines.map(move |(row, line)| (first + row as i64, line))
}

/// What is true of f2 on a box; no format and no rounding has a part in it but the scale.
#[derive(Default)]
struct TrueSigns {
    /// For each pixel, row by row: f2 >= 0.
    present: Vec<bool>,
    ties: u64,
    /// Greatest ratio, over the other pixels, of the error that rounding can have there to the magnitude of f2.
    risk: f64,
}

/// Evaluates f2 at every pixel. `reach` gives its greatest rounding error at a pixel, in last bits.
fn true_signs(
    exact: &QuadraticForm,
    window: &ScreenBox,
    reach: impl Fn(i64, i64) -> f64 + Sync,
) -> TrueSigns {
    let (form, denominator) = exact.whole();
    let unit = denominator.to_f64().expect("a finite or infinite float");
    let line = |y: i64| {
        let mut line = TrueSigns::default();
        // Forward differences along the line.
        let at = |x: i64| second_degree(form, x, y);
        let mut value = at(window.x0);
        let mut step = at(window.x0 + 1) - &value;
        let second: BigInt = &form[0] * 2;
        for x in window.x0..=window.x1 {
            line.present.push(!value.is_negative());
            if value.sign() == Sign::NoSign {
                line.ties += 1;
            } else {
                let size = magnitude(&value, denominator, unit);
                line.risk = line.risk.max(reach(x, y) / size);
            }
            value += &step;
            step += &second;
        }
        line
    };
    let lines: Vec<TrueSigns> = (window.y0..=window.y1).into_par_iter().map(line).collect();
    TrueSigns {
        ties: lines.iter().map(|l| l.ties).sum(),
        risk: lines.iter().map(|l| l.risk).fold(0.0, f64::max),
        present: lines.into_iter().flat_map(|l| l.present).collect(),
    }
}

/// |value / denominator|, also where one of them is beyond `f64`.
fn magnitude(value: &BigInt, denominator: &BigInt, unit: f64) -> f64 {
    let float = value.to_f64().expect("a finite or infinite float").abs();
    if float.is_finite() && unit.is_finite() {
        return float / unit;
    }
    to_f64(&BigRational::new_raw(value.abs(), denominator.clone()))
}

/// Depth errors in depth words: the greatest, the sum of their squares, and how many.
#[derive(Clone, Copy, Debug, Default)]
struct DepthErrors {
    most: f64,
    squares: f64,
    count: u64,
}

impl DepthErrors {
    fn add(&mut self, error: f64) {
        self.most = self.most.max(error.abs());
        self.squares += error * error;
        self.count += 1;
    }

    fn of_all(parts: impl Iterator<Item = DepthErrors>) -> DepthErrors {
        parts.fold(DepthErrors::default(), |all, part| DepthErrors {
            most: all.most.max(part.most),
            squares: all.squares + part.squares,
            count: all.count + part.count,
        })
    }
}

/// What the rounding of the coefficients adds to f1 and f2 at a pixel, from the exact residuals about the anchor.
fn residuals(object: &PreparedQuadric) -> impl Fn(i64, i64) -> (f64, f64) + use<> {
    let (words, exact, anchor) = (&object.words, &object.exact, object.anchor);
    let (x, y) = (integer(anchor.x), integer(anchor.y));
    let f1 = LinearForm::of_words(&words.f1).minus(&exact.f1);
    let f2 = QuadraticForm::of_words(&words.f2).minus(&exact.f2);
    let (f1, f2) = (f1.about(&x, &y), f2.about(&x, &y));
    let [p, q, r] = f1.factors().each_ref().map(to_f64);
    let [a, b, c, d, e, f] = f2.factors().each_ref().map(to_f64);
    move |x, y| {
        let (u, v) = ((x - anchor.x) as f64, (y - anchor.y) as f64);
        let quadratic = (a * u + c * v + d) * u + (b * v + e) * v + f;
        (p * u + q * v + r, quadratic)
    }
}

/// Errors of both roots within the depth range, at the pixels where computed and true f2 are not negative; `present`
/// says where the true one is.
fn depth_errors(object: &PreparedQuadric, present: &[bool], format: &Format) -> DepthErrors {
    let words = &object.words;
    if words.class == Class::Prism {
        return DepthErrors::default();
    }
    let residuals = residuals(object);
    let is_visible = |depth: i64| depth >= format.z_low() && depth < format.z_max();
    let line = |(y, line): (i64, &[bool])| {
        let mut found = DepthErrors::default();
        let columns = (words.screen_box.x0..).zip(line);
        for (x, _) in columns.filter(|(_, present)| **present) {
            let (f1, f2) = (words.f1_at(x, y, format), words.f2_at(x, y, format));
            if f2 < 0 {
                continue;
            }
            let root = format.root_of(f2);
            let (linear, quadratic) = residuals(x, y);
            let true_root = (f2 as f64 - quadratic).max(0.0).sqrt();
            // true root - root, without cancellation
            let below = (f2 - root * root) as f64 - quadratic;
            let root_error = match below == 0.0 {
                true => 0.0,
                false => below / (true_root + root as f64),
            };
            if is_visible(f1 - root) {
                found.add(linear + root_error);
            }
            if is_visible(f1 + root) {
                found.add(linear - root_error);
            }
        }
        found
    };
    let lines: Vec<DepthErrors> = lines(&words.screen_box, present).map(line).collect();
    // Added in order, so that the sum is the same in every run.
    DepthErrors::of_all(lines.into_iter())
}
