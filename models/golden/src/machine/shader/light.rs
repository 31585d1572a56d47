//! One light at one pixel.

use super::curves::{Curves, dot, normalised};
use super::view::Sight;
use super::words::LightWords;

/// The vector to a light and its products with normal and line of sight.
pub(super) struct Light<'a> {
    sight: &'a Sight,
    /// Exactly whether the light stands on the viewer's side of the surface.
    pub is_lit: bool,
    /// Normal times vector to the light, cut.
    along: i64,
    /// Line of sight times vector to the light, cut.
    back: i64,
    /// `log2` of the square of the vector to the light.
    light_log: i64,
}

impl Light<'_> {
    pub fn new<'a>(words: &LightWords, sight: &'a Sight, curves: &Curves) -> Light<'a> {
        let widths = &curves.widths;
        let (vector, _) = normalised(towards(words, sight), 30);
        let kept = vector.map(|v| v >> (30 - widths.mantissa));
        let across = dot(sight.normal, vector);
        let (up, less) = (18 - widths.mantissa, widths.dropped());
        let square = dot(kept, kept);
        Light {
            sight,
            is_lit: if sight.turned { across < 0 } else { across > 0 },
            along: dot(sight.normal, kept) << up >> less,
            back: dot(sight.ray, kept) << up >> (less + 2),
            light_log: curves.log2(square << (2 * up)),
        }
    }

    /// The cosine between normal and light, with attenuation.
    pub fn diffuse(&self, curves: &Curves) -> i64 {
        let sign = if self.sight.turned { -1 } else { 1 };
        let along = sign * self.along;
        if along <= 0 {
            return 0;
        }
        let cut = i64::from(2 * curves.widths.dropped()) << curves.widths.logarithm;
        let loss = self.sight.normal_log + self.light_log - 2 * curves.log2(along) - cut;
        curves.factor(loss.max(0) + self.sight.attenuation)
    }

    /// The power of the cosine between mirrored light and viewer, with attenuation.
    pub fn specular(&self, curves: &Curves, exponent: u8) -> i64 {
        let widths = &curves.widths;
        let sight = self.sight;
        let places = 32 - widths.square;
        let aligned = (sight.square * self.back) << places >> (widths.dropped() - 2);
        let difference = aligned - 2 * self.along * sight.across;
        let less = 52 - widths.difference;
        let kept = difference >> less;
        if kept <= 0 {
            return 0;
        }
        let cut = i64::from(2 * (less + 2 * widths.dropped())) << widths.logarithm;
        let lengths = 2 * sight.normal_log + self.light_log + sight.ray_log;
        let loss = (lengths - 2 * curves.log2(kept) - cut).clamp(0, curves.most());
        curves.factor(loss * i64::from(exponent) + sight.attenuation)
    }
}

/// The vector to the light in units of its words.
fn towards(words: &LightWords, sight: &Sight) -> [i64; 3] {
    let place = |v: i64| if words.point { v << words.shift } else { 0 };
    let [x, y] = sight.place.map(place);
    let place = [x, y, 0];
    std::array::from_fn(|k| {
        let slope = (i64::from(words.slope[k]) * sight.depth) >> 31;
        i64::from(words.base[k]) - place[k] - slope
    })
}
