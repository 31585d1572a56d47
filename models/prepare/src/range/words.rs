//! In which range of the depth the words of a quadric hold what is computed.

use crate::context::Context;
use crate::perspective::ScreenQuadric;
use crate::screen_box::{Region, Search, screen_between};
use imogene_algebra::rational::to_f64;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use num_rational::BigRational;

/// Part of a word that the rounding of coefficients may take.
const MARGIN: f64 = 1e-4;

/// What the words of a format hold, in depths that fill the depth word.
pub(super) struct Limits {
    f1_and_root: f64,
    f2: f64,
    /// Most that a computed root is of the true one.
    root: f64,
}

impl Limits {
    pub fn of(format: &Format) -> Limits {
        let power = |bits: u32, of: u32| f64::exp2(f64::from(bits) - f64::from(of));
        Limits {
            f1_and_root: (1.0 - MARGIN) * power(format.sum, format.depth),
            f2: (1.0 - MARGIN) * power(format.quadratic + 1, 2 * format.depth),
            root: 1.0 + format.root_form.error().0,
        }
    }
}

/// A depth word over the greatest, as `shift + scale z` of a depth z that fills the word of another range.
#[derive(Clone, Copy)]
pub(super) struct Change {
    shift: f64,
    scale: f64,
}

impl Change {
    /// To the range whose ends are 2^level times farther.
    pub fn to_level(level: i32, context: &Context) -> Change {
        let factor = f64::exp2(f64::from(level));
        let (shift, scale) = match context.perspective {
            true => (1.0 - factor, factor),
            false => (0.0, factor.recip()),
        };
        Change { shift, scale }
    }

    /// The ends of the range, as depths in pixels of the other.
    pub fn ends(&self, context: &Context) -> [f64; 2] {
        let full = to_f64(&context.full_depth);
        [-1.0, 1.0].map(|word| full * (word - self.shift) / self.scale)
    }
}

/// What the depth of a quadric computes on its box, in depths that fill the word.
pub(super) struct Computed {
    f1: (f64, f64),
    /// Greatest magnitude, and greatest value, of f2.
    f2: (f64, f64),
}

impl Computed {
    /// The expressions of a quadric on a box.
    pub fn on(quadric: &ScreenQuadric, window: &ScreenBox, context: &Context) -> Computed {
        let full = to_f64(&context.full_depth);
        let over = |value: &BigRational| to_f64(value) / full;
        let f1 = context.to_pixels_linear(&quadric.f1());
        let (least, greatest) = f1.range_on(window);
        let f1 = (over(&least), over(&greatest));
        let f2 = context.to_pixels_quadratic(&quadric.f2());
        let (least, greatest) = f2.range_on(window);
        let [least, greatest] = [least, greatest].map(|value| over(&value) / full);
        Computed {
            f1,
            f2: (least.abs().max(greatest.abs()), greatest),
        }
    }

    /// Do f2 and f1 + r stay in their words when depth changes so.
    pub fn fits(&self, Change { shift, scale }: Change, limits: &Limits) -> bool {
        let (low, high) = (shift + scale * self.f1.0, shift + scale * self.f1.1);
        let root = limits.root * scale * self.f2.1.max(0.0).sqrt();
        scale * scale * self.f2.0 < limits.f2
            && low.abs().max(high.abs()) + root < limits.f1_and_root
    }
}

/// The range in which f2 and f1 + r of an object would stay in their words, as a clause of a refusal; nothing if none
/// would do.
pub(crate) fn remedy(quadric: &ScreenQuadric, region: &Region, context: &Context) -> Box<str> {
    let limits = Limits::of(&context.format);
    let towards = if context.perspective { -1 } else { 1 };
    let fits = |level: &i32| {
        let change = Change::to_level(*level, context);
        // More of it is seen in a wider range.
        let cell = screen_between(context.width, context.height, change.ends(context));
        let window = region.box_within(cell, context.width, context.height, Search::COARSE);
        Computed::on(quadric, &window, context).fits(change, &limits)
    };
    let Some(level) = (1..60).map(|steps| towards * steps).find(fits) else {
        return Box::default();
    };
    let range = context.range.scaled(level);
    let near = to_f64(&range.near);
    let clause = match &range.far {
        None => format!("; `near = {near}` in the camera would do"),
        Some(far) => format!(
            "; `near = {near}` and `far = {}` in the camera, in the place of `half_depth`, would do",
            to_f64(far)
        ),
    };
    clause.into()
}
