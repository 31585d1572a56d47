//! What all lights share at one pixel: the line of sight, the normal, the attenuation.

use super::curves::{Curves, dot, normalised};
use super::words::{Pixel, ShaderWords};

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
