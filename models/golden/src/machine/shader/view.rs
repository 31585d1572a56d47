//! What all lights share at one pixel, the line of sight, the normal and the attenuation; and one light there.

use super::curves::{Curves, dot, normalised};
use super::words::{LightWords, Pixel, ShaderWords};

/// Line of sight and normal at a pixel, shifted to full words.
pub(super) struct Sight {
    /// Pixel coordinates from the middle of the picture, in half pixels.
    pub place: [i64; 2],
    /// Depth as a fraction of the way to the far end, 31 bits after the point.
    pub depth: i64,
    /// Along the line of sight, away from the viewer.
    pub ray: [i64; 3],
    /// The normal.
    pub normal: [i64; 3],
    /// The normal looks away from the viewer and is to be turned.
    pub turned: bool,
    /// Normal times line of sight, cut.
    pub across: i64,
    /// Square of the normal, cut.
    pub square: i64,
    /// `log2` of the square of the line of sight.
    pub ray_log: i64,
    /// `log2` of the square of the normal.
    pub normal_log: i64,
    /// Loss by attenuation.
    pub attenuation: i64,
}

impl Sight {
    pub fn new(words: &ShaderWords, curves: &Curves, pixel: &Pixel) -> Sight {
        let place = place(words, pixel);
        let (ray, ray_places) = normalised(ray(words, place), 18);
        let (normal, _) = normalised(pixel.normal.map(i64::from), 16);
        let across = dot(normal, ray);
        let square = dot(normal, normal);
        let ray_log = curves.log2(dot(ray, ray));
        let depth = pixel.depth << (32 - words.depth);
        let attenuation = match words.attenuation {
            None => 0,
            Some(offset) => {
                let far = !depth & ((1 << 31) - 1) | depth & (1 << 31);
                let far = far >> (32 - words.depth) << (32 - words.depth);
                let point = curves.loss_fraction();
                let offset = i64::from(offset) << point >> 22;
                let distance = ray_log - (i64::from(ray_places) << point);
                curves.attenuation(distance - 2 * curves.log2(far) + offset)
            }
        };
        Sight {
            place,
            depth,
            ray,
            normal,
            turned: across > 0,
            across: across >> curves.widths.dropped(),
            square: square >> (32 - curves.widths.square),
            ray_log,
            normal_log: curves.log2(square),
            attenuation,
        }
    }
}

/// Half pixels from the middle of the picture, 13 bits.
pub(super) fn place(words: &ShaderWords, pixel: &Pixel) -> [i64; 2] {
    let from_middle = |at: i64, size: u16| {
        let place = 2 * at - i64::from(size);
        place << 51 >> 51
    };
    let (x, y) = (i64::from(pixel.x), i64::from(pixel.y));
    let y = if words.is_field { 2 * y } else { y };
    [from_middle(x, words.size[0]), from_middle(y, words.size[1])]
}

pub(super) fn ray(words: &ShaderWords, place: [i64; 2]) -> [i64; 3] {
    let distance = i64::from(words.distance);
    if words.perspective {
        let [x, y] = place.map(|v| (v << 5) >> words.view_shift);
        [x, y, distance]
    } else {
        [0, 0, distance]
    }
}

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
