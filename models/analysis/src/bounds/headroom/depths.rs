//! Depth errors of an object's faces at every pixel of its box.

use imogene_algebra::rational::{integer, to_f64};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::depth_interval::Class;
use imogene_prepare::PreparedQuadric;
use imogene_prepare::forms::{LinearForm, QuadraticForm};
use imogene_prepare::rounding::Anchor;
use rayon::prelude::*;

/// Depth errors in depth words.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct DepthErrors {
    /// The greatest.
    pub most: f64,
    /// Sum of squares.
    pub squares: f64,
    /// How many.
    pub count: u64,
}

impl DepthErrors {
    fn add(&mut self, error: f64) {
        self.most = self.most.max(error.abs());
        self.squares += error * error;
        self.count += 1;
    }

    /// Those of both.
    pub fn merged(self, other: DepthErrors) -> DepthErrors {
        DepthErrors {
            most: self.most.max(other.most),
            squares: self.squares + other.squares,
            count: self.count + other.count,
        }
    }

    /// Root of the mean square.
    pub fn rms(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }
}

/// What the rounding of the coefficients adds, from the exact residuals, in coordinates about the anchor.
struct Residuals {
    anchor: Anchor,
    f1: [f64; 3],
    f2: [f64; 6],
}

impl Residuals {
    fn of(object: &PreparedQuadric) -> Residuals {
        let (words, exact, anchor) = (&object.words, &object.exact, object.anchor);
        let (x, y) = (integer(anchor.x), integer(anchor.y));
        let f1 = LinearForm::of_words(&words.f1)
            .minus(&exact.f1)
            .about(&x, &y);
        let f2 = QuadraticForm::of_words(&words.f2)
            .minus(&exact.f2)
            .about(&x, &y);
        Residuals {
            anchor,
            f1: [&f1.a, &f1.b, &f1.c].map(to_f64),
            f2: [&f2.a, &f2.b, &f2.c, &f2.d, &f2.e, &f2.f].map(to_f64),
        }
    }

    fn at(&self, x: i64, y: i64) -> (f64, f64) {
        let (u, v) = ((x - self.anchor.x) as f64, (y - self.anchor.y) as f64);
        let [a, b, c] = self.f1;
        let linear = a * u + b * v + c;
        let [a, b, c, d, e, f] = self.f2;
        (linear, (a * u + c * v + d) * u + (b * v + e) * v + f)
    }
}

/// Errors of both roots within the depth range, at the pixels where computed and true f2 are not negative; `present`
/// says where the true one is.
pub(super) fn errors(object: &PreparedQuadric, present: &[bool], format: &Format) -> DepthErrors {
    if object.words.class == Class::Prism {
        return DepthErrors::default();
    }
    let window: ScreenBox = object.words.screen_box;
    let residuals = Residuals::of(object);
    let width = (window.x1 - window.x0 + 1) as usize;
    let lines: Vec<DepthErrors> = present
        .par_chunks(width)
        .enumerate()
        .map(|(row, line)| {
            let y = window.y0 + row as i64;
            let mut found = DepthErrors::default();
            for (x, _) in (window.x0..).zip(line).filter(|(_, present)| **present) {
                add_pixel(object, &residuals, format, (x, y), &mut found);
            }
            found
        })
        .collect();
    // Added in order, so that the sum is the same in every run.
    lines
        .into_iter()
        .fold(DepthErrors::default(), DepthErrors::merged)
}

fn add_pixel(
    object: &PreparedQuadric,
    residuals: &Residuals,
    format: &Format,
    (x, y): (i64, i64),
    found: &mut DepthErrors,
) {
    let f1 = object.words.f1_at(x, y, format);
    let f2 = object.words.f2_at(x, y, format);
    if f2 < 0 {
        return;
    }
    let root = format.root_of(f2);
    let (linear, quadratic) = residuals.at(x, y);
    let true_root = (f2 as f64 - quadratic).max(0.0).sqrt();
    // true root - root, without cancellation
    let below = (f2 - root * root) as f64 - quadratic;
    let root_error = if below == 0.0 {
        0.0
    } else {
        below / (true_root + root as f64)
    };
    let visible = |depth: i64| depth >= format.z_low() && depth < format.z_max();
    if visible(f1 - root) {
        found.add(linear + root_error);
    }
    if visible(f1 + root) {
        found.add(linear - root_error);
    }
}
