//! Lit-sphere shading: a colour of a table by the direction of the normal (`docs/architecture.md`, section 8.4).

use super::curves::{Curve, dot};
use super::tables::SphereTables;
use super::view;
use super::words::{Pixel, ShaderWords};
use imogene_contract::shading::NEAREST_DROPPED;
use std::sync::LazyLock;

/// `1 / (1 + t)`, 16 bits after the point.
static RECIPROCAL: LazyLock<Curve> =
    LazyLock::new(|| Curve::new(|t| 1.0 / (1.0 + t), 4, 1.0 / 16.0, 14, 16));

impl SphereTables {
    /// Red, green, blue of a pixel that shows an object.
    pub fn colour(&self, words: &ShaderWords, pixel: &Pixel) -> [u8; 3] {
        let reaching = usize::from(pixel.flags) & ((1 << self.lights) - 1);
        let table = usize::from(pixel.material) << self.lights | reaching;
        let own = table << (2 * self.places) & (self.entries.len() - 1);
        if self.nearest {
            let [column, line] = nearest(words, pixel, self.places);
            return self.entries[own + (line << self.places) + column].map(|level| level as u8);
        }
        let [column, line] = coordinates(words, pixel).map(|at| at * ((1 << self.places) - 1));
        let [across, down] = [column, line].map(|at| at >> 9 & 127);
        let (more, less) = (across.max(down), across.min(down));
        let entry = |right: i64, below: i64| {
            let [column, line] = [(column >> 16) + right, (line >> 16) + below];
            self.entries[own + ((line as usize) << self.places) + column as usize].map(i64::from)
        };
        let near = entry(0, 0);
        let middle = if across >= down {
            entry(1, 0)
        } else {
            entry(0, 1)
        };
        let far = entry(1, 1);
        std::array::from_fn(|k| {
            let rise = more * (middle[k] - near[k]) + less * (far[k] - middle[k]);
            ((near[k] * 128 + rise + 256) >> 9) as u8
        })
    }
}

/// The sum and the difference of x and y of the normal that looks towards the viewer along a line of sight, and its
/// length on the map.
fn direction(pixel: &Pixel, ray: [i64; 3]) -> ([i64; 2], i64) {
    let normal = pixel.normal.map(i64::from);
    let is_turned = dot(normal, ray) > 0;
    let [x, y, z] = if is_turned {
        normal.map(|part| -part)
    } else {
        normal
    };
    ([x + y, x - y], x.abs() + y.abs() + (-z).max(0))
}

/// Column and line of the entry in whose square the direction of the normal is.
pub fn nearest(words: &ShaderWords, pixel: &Pixel, places: u32) -> [usize; 2] {
    let ray = match words.perspective {
        true => view::ray(words, view::place(words, pixel)).map(|part| part >> NEAREST_DROPPED),
        false => [0, 0, 1],
    };
    let (numbers, length) = direction(pixel, ray);
    let last = (1 << places) - 1;
    numbers.map(|number| match length {
        0 => last,
        _ => last.min((((number + length) << places) / (2 * length)) as usize),
    })
}

/// The direction of the normal on the map, both coordinates with 16 bits.
pub fn coordinates(words: &ShaderWords, pixel: &Pixel) -> [i64; 2] {
    let ray = view::ray(words, view::place(words, pixel));
    let (numbers, length) = direction(pixel, ray);
    // Its first one of 17 bits; nothing is without length but what has no direction.
    let places = 16 - length.max(1).ilog2();
    let part = RECIPROCAL.value((((length << places) & 0xffff) << 2) as u64);
    numbers.map(|number| {
        let moved = (((number << places) * part) >> 17) + (1 << 15);
        moved.clamp(0, 0xffff)
    })
}
