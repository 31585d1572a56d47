//! A camera that sees a whole set of balls.

use crate::kit::short;
use imogene_algebra::vector::{cross, length, minus};
use imogene_scene::{Body, Camera, ImageSize, fitting_from};

/// Distance of the viewer: the depth word is finest when the scene is not deeper than a third of it.
pub const DISTANCE_IN_RADII: f64 = 6.0;
pub const IMAGE: ImageSize = ImageSize {
    width: 960,
    height: 720,
};
/// Steps towards the middle of the smallest sphere.
const STEPS: usize = 200;

/// A ball: middle and radius.
pub type Ball = ([f64; 3], f64);

/// A sphere around all balls, near the smallest: at each step its middle is drawn towards the ball that reaches
/// farthest, by a share that falls as 1/n (M. Badoiu, K. Clarkson, "Smaller core-sets for balls", 2003).
pub fn bounding_sphere(balls: &[Ball]) -> Ball {
    let (low, high) = bounding_box(balls);
    let mut middle: [f64; 3] = std::array::from_fn(|k| 0.5 * (low[k] + high[k]));
    let mut best = (middle, f64::INFINITY);
    for step in 0..=STEPS {
        let (index, reach) = farthest(balls, middle);
        if reach < best.1 {
            best = (middle, reach);
        }
        let share = 1.0 / (step as f64 + 2.0);
        for (m, p) in middle.iter_mut().zip(balls[index].0) {
            *m += share * (p - *m);
        }
    }
    best
}

/// The ball that reaches farthest from a point, and how far.
fn farthest(balls: &[Ball], from: [f64; 3]) -> (usize, f64) {
    let reach = |(place, radius): &Ball| length(minus(place, from)) + radius;
    let reaches = balls.iter().map(reach).enumerate();
    let farthest = reaches.max_by(|(_, a), (_, b)| a.total_cmp(b));
    farthest.expect("at least one ball")
}

/// Least and greatest coordinates of all balls.
pub fn bounding_box(balls: &[Ball]) -> ([f64; 3], [f64; 3]) {
    let along = |sign: f64, axis: usize| {
        let ends = balls.iter().map(|(p, r)| sign * p[axis] + r);
        sign * ends.fold(f64::NEG_INFINITY, f64::max)
    };
    let ends = |sign: f64| [0, 1, 2].map(|axis| along(sign, axis));
    (ends(-1.0), ends(1.0))
}

/// A camera of which the balls fill the picture, and the directions to the right, upwards and towards the viewer. It
/// looks along the shortest side of the bounding box with the longest across: along axes, so that its frame is exact.
pub fn frame(balls: &[Ball]) -> (Camera, [[f64; 3]; 3]) {
    let (middle, radius) = bounding_sphere(balls);
    let (low, high) = bounding_box(balls);
    let mut order = [0, 1, 2];
    // Stable: of equal sides the viewer stands on z and y is upwards.
    order.sort_by(|a, b| (high[*b] - low[*b]).total_cmp(&(high[*a] - low[*a])));
    let unit = |axis: usize| std::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 });
    let (up, towards): ([f64; 3], [f64; 3]) = (unit(order[1]), unit(order[2]));
    let right = cross(up, towards);
    let distance = five_digits_up(DISTANCE_IN_RADII * radius);
    let about_middle = |(place, radius): &Ball| Body::ball(minus(place, middle), *radius);
    let bodies: Vec<Body> = balls.iter().map(about_middle).collect();
    let shape = f64::from(IMAGE.width) / f64::from(IMAGE.height);
    let ([x, y], tangent) = fitting_from(&bodies, &[right, up, towards], distance, shape);
    // The sum turns -0 into 0.
    let short = |value: f64| short(value) + 0.0;
    let target: [f64; 3] = std::array::from_fn(|k| short(middle[k] + x * right[k] + y * up[k]));
    let eye = std::array::from_fn(|k| short(target[k] + distance * towards[k]));
    let height = five_digits_up(2.0 * tangent * distance);
    let camera = Camera::perspective([eye, target, up], distance, height);
    (camera, [right, up, towards])
}

/// The number rounded upwards to five significant digits: short in the file, and small as a fraction.
fn five_digits_up(value: f64) -> f64 {
    let exponent = value.log10().floor() as i32 - 4;
    // Dividing by a power of ten gives the nearest number to the decimal; multiplying by its inverse would not.
    let unit = 10f64.powi(exponent.abs());
    match exponent < 0 {
        true => (value * unit).ceil() / unit,
        false => (value / unit).ceil() * unit,
    }
}
