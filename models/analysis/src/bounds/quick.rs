//! Whether a check would fail, in a small part of the time of drawing: no bounds, and only the pixels that rounding
//! can leave open.
//!
//! On a line of the picture f2 is of second degree in the column, so the columns at which it is within its error of
//! zero follow from its roots. Mostly there are none; an object whose outline is steep everywhere is passed over
//! whole.

use super::accumulators::plane_bits;
use super::contour::{displacement, steep_everywhere};
use super::jury::Jury;
use super::outline::Presence;
use super::report::adrift_problem;
use super::verdict::decide;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_prepare::{PreparedQuadric, PreparedScene};
use imogene_scene::FramedScene;
use rayon::prelude::*;
use serde::Serialize;
use std::sync::OnceLock;

/// Columns by which an interval is widened, for roots in `f64`; every pixel in it is decided in integers.
const SPARE: f64 = 1e-3;

/// An object for which a check fails.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Failing {
    /// Name in the scene.
    pub object: String,
    /// Why.
    pub reason: String,
}

/// The objects of quadric and patch processors for which a check of the scene fails; `prepared` must come from `scene`.
///
/// Objects of other processors are compared with the truth at every pixel by [`super::check`] alone.
pub fn failing(scene: &FramedScene, prepared: &PreparedScene) -> Vec<Failing> {
    let jury = OnceLock::new();
    let jury = || jury.get_or_init(|| Jury::new(scene, prepared));
    let found = prepared.objects.par_iter().filter_map(|object| {
        let object = object.quadric()?;
        let reason = wraps(object, &prepared.format).or_else(|| {
            let (window, presence) = open_part(object, prepared)?;
            let adrift = jury().adrift(window, presence);
            let is_far = || displacement(object, &prepared.format).pixels >= 1.0;
            adrift_problem(&adrift).filter(|_| is_far())
        });
        Some(Failing {
            object: object.name.clone(),
            reason: reason?,
        })
    });
    found.collect()
}

fn wraps(object: &PreparedQuadric, format: &Format) -> Option<String> {
    let planes = plane_bits(&object.words);
    let fits = object.needed.sum <= format.sum
        && object.needed.quadratic <= format.quadratic
        && planes.iter().all(|&bits| bits <= format.plane);
    (!fits).then(|| "a word does not fit and wraps".to_owned())
}

/// The box around the open pixels of an object, and what it is at each pixel of that.
/// `None` if too few pixels are open for a square of four.
fn open_part(
    object: &PreparedQuadric,
    prepared: &PreparedScene,
) -> Option<(ScreenBox, Vec<Presence>)> {
    let format = &prepared.format;
    let window = object.words.screen_box;
    if window.is_empty() || steep_everywhere(object, format) {
        return None;
    }
    let at = |x, y| Presence::of(&decide(object, format, x, y));
    let mut around = ScreenBox::EMPTY;
    let mut pixels = 0;
    for y in window.y0..=window.y1 {
        for [first, last] in near_zero(object, format, y) {
            for x in (first..=last).filter(|&x| at(x, y) == Presence::Open) {
                pixels += 1;
                around = around.around(&ScreenBox::of([x, x], [y, y]));
            }
        }
    }
    if pixels <= 3 {
        return None;
    }
    // One more on each side, where the neighbours are.
    let ScreenBox { x0, x1, y0, y1 } = around;
    let window = ScreenBox::of([x0 - 1, x1 + 1], [y0 - 1, y1 + 1]);
    let window = window.in_zone(0, 0, prepared.width.into(), prepared.height.into());
    Some((window, window.each().map(|(x, y)| at(x, y)).collect()))
}

/// Intervals of columns, first and last, that hold all pixels of line `y` with f2 within its error of zero.
pub fn near_zero(object: &PreparedQuadric, format: &Format, y: i64) -> Vec<[i64; 2]> {
    let words = &object.words;
    let ScreenBox { x0, x1, .. } = words.screen_box;
    // About the middle of the box, so that no digits are lost.
    let middle = (x0 + x1).div_euclid(2);
    let along = words.f2.from_zone(middle, y);
    let [a, b, c] = [along.a, along.d, along.f].map(|v| v as f64);
    let unit = f64::from(1u32 << format.guard_quadratic);
    let error = (object.bounds.f2 + 1.0) * unit;
    let (first, last) = ((x0 - middle) as f64, (x1 - middle) as f64);
    let mut ends = [real_roots(a, b, c + error), real_roots(a, b, c - error)].concat();
    ends.retain(|u| (first..last).contains(u));
    ends.extend([first, last]);
    ends.sort_by(f64::total_cmp);
    let scale = (a.abs() * last.max(-first) + b.abs()) * last.max(-first) + c.abs();
    let near = |u: f64| ((a * u + b) * u + c).abs() <= error + 1e-12 * scale;
    let columns = |[low, high]: [f64; 2]| {
        let low = (low - SPARE).ceil() as i64 + middle;
        let high = (high + SPARE).floor() as i64 + middle;
        (low <= high).then_some([low.max(x0), high.min(x1)])
    };
    let gaps = ends.windows(2).map(|gap| [gap[0], gap[1]]);
    let gaps = gaps.filter(|[low, high]| near(0.5 * (low + high)));
    // A root by itself, where the band is narrower than two roots can tell.
    let alone = ends.iter().map(|&u| [u, u]);
    gaps.chain(alone).filter_map(columns).collect()
}

/// The real roots of `a u^2 + b u + c`; a pair that is barely complex counts as double.
fn real_roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    let discriminant = b * b - 4.0 * a * c;
    let spare = 1e-9 * (b * b + (4.0 * a * c).abs());
    if discriminant < -spare {
        return [f64::NAN; 2];
    }
    let sum = -0.5 * (b + discriminant.max(0.0).sqrt().copysign(b));
    [sum / a, c / sum]
}
