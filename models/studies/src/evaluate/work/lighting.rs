//! The light at a corner, by Phong's formula (source: 1.2.4, Tables 5.2 and 5.3).

use super::transform::normalised;
use crate::evaluate::count::{Counted, number};
use imogene_algebra::vector::dot;

/// Where a source or the viewer is.
#[derive(Clone, Copy, Debug)]
pub enum Place {
    /// So far away that its direction, of length 1, is the same everywhere.
    Far([Counted; 3]),
    /// At a point.
    Near([Counted; 3]),
}

impl Place {
    fn seen_from(&self, point: [Counted; 3]) -> [Counted; 3] {
        match *self {
            Place::Far(direction) => direction,
            Place::Near(place) => normalised(std::array::from_fn(|axis| place[axis] - point[axis])),
        }
    }
}

/// Products of material and source, formed once for an object: red, green, blue of each.
#[derive(Clone, Copy, Debug)]
pub struct Colours {
    /// Of the ambient light.
    pub ambient: [Counted; 3],
    /// Diffuse.
    pub diffuse: [Counted; 3],
    /// Specular.
    pub specular: [Counted; 3],
    /// Whole exponent, at least 1.
    pub exponent: u32,
}

/// A power with a whole exponent, at least 1, by squaring.
pub fn power(base: Counted, exponent: u32) -> Counted {
    let mut result = base;
    for bit in (0..exponent.ilog2()).rev() {
        result = result * result;
        if exponent >> bit & 1 == 1 {
            result = result * base;
        }
    }
    result
}

fn clamped(value: Counted) -> Counted {
    value.or_greater(number(0.0))
}

/// `ka Ia + kd I (N.L) + ks I (O.R)^n` for red, green and blue, `R = 2 (N.L) N - L`; a negative cosine is 0.
pub fn light(
    point: [Counted; 3],
    normal: [Counted; 3],
    source: &Place,
    viewer: &Place,
    colours: &Colours,
) -> [Counted; 3] {
    let n = normalised(normal);
    let l = source.seen_from(point);
    let cosine = clamped(dot(n, l));
    let twice = cosine.doubled();
    let mirrored: [Counted; 3] = std::array::from_fn(|axis| twice * n[axis] - l[axis]);
    let glance = clamped(dot(viewer.seen_from(point), mirrored));
    let shine = power(glance, colours.exponent);
    std::array::from_fn(|k| {
        colours.ambient[k] + colours.diffuse[k] * cosine + colours.specular[k] * shine
    })
}
