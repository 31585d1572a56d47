//! How far the silhouette is displaced at one of its points, from the slope of f2 there.
//!
//! Let q be the computed second-degree expression, `|q - f2| <= e2`, g the length of the gradient of q at a point where
//! q = 0, and H the greatest magnitude of an eigenvalue of its second derivatives. At a distance t along the gradient,
//! `|q|` is at least `g t - H t^2 / 2`, with the sign of the side. At
//!
//! ```text
//! t = 2 e2 / (g + sqrt(g^2 - 2 H e2))
//! ```
//!
//! that is e2, so f2 is not negative on one side and not positive on the other: the true silhouette is crossed within
//! t, provided that `g^2 >= 2 H e2` and that these t pixels lie in the box on which e2 holds.

use imogene_golden::unit::pe2::Quadratic;

/// Relative allowance for the few operations in `f64`.
const FLOAT_MARGIN: f64 = 64.0 * f64::EPSILON;

/// Greatest displacement, in pixels, of the silhouette at a point of it where the gradient of `q` is `gradient`;
/// `None` if the slope is too small to tell. `error` is e2, in the units of `q`.
pub fn displacement_at(q: &Quadratic, gradient: [f64; 2], error: f64) -> Option<f64> {
    let slope = gradient[0].hypot(gradient[1]) * (1.0 - FLOAT_MARGIN);
    let curved = 2.0 * greatest_curvature(q) * error;
    // What is left must be certainly positive.
    let left = slope * slope - curved * (1.0 + FLOAT_MARGIN);
    (slope > 0.0 && left >= 0.0).then(|| {
        let left = (left - slope * slope * FLOAT_MARGIN).max(0.0);
        2.0 * error / (slope + left.sqrt()) * (1.0 + FLOAT_MARGIN)
    })
}

/// Greatest magnitude of an eigenvalue of the second derivatives of `q`, rounded up.
pub fn greatest_curvature(q: &Quadratic) -> f64 {
    let (sum, difference) = ((q.a + q.b) as f64, (q.a - q.b) as f64);
    (sum.abs() + difference.hypot(q.c as f64)) * (1.0 + FLOAT_MARGIN)
}
