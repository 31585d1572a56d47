//! The formula of shading on integer words, in floating point.
//!
//! Normal, line of sight and vector to the light are integers of at most 48 bits together, so the signs that decide are
//! exact.

use imogene_algebra::vector::{Vector, dot, unit};
use imogene_golden::machine::shader::{LightWords, MaterialWords, Pixel, ShaderWords};

/// Levels of red, green, blue before they are clamped and rounded. The pixel shows an object.
pub fn levels(words: &ShaderWords, pixel: &Pixel) -> Vector {
    let none = MaterialWords::default();
    let material = words.materials.get(usize::from(pixel.material));
    let material = material.unwrap_or(&none);
    let ray = ray(words, pixel);
    let fall = attenuation(words, pixel, ray);
    let viewer = unit(ray).map(|v| -v);
    let mut normal = pixel.normal.map(f64::from);
    if dot(normal, ray) > 0.0 {
        normal = normal.map(|v| -v);
    }
    let mut sum = material.ambient.map(|v| f64::from(v) / 256.0);
    for light in &words.lights {
        let to_light = towards(light, words, pixel);
        if pixel.flags >> light.source & 1 == 0 || dot(normal, to_light) <= 0.0 {
            continue;
        }
        let (n, l) = (unit(normal), unit(to_light));
        let lambert = dot(n, l);
        let mirrored = 2.0 * lambert * dot(n, viewer) - dot(l, viewer);
        let highlight = mirrored.max(0.0).powi(i32::from(material.exponent));
        for (k, level) in sum.iter_mut().enumerate() {
            let diffuse = f64::from(material.diffuse[k]) / 65536.0 * lambert;
            let specular = f64::from(material.specular) / 65536.0 * highlight;
            *level += fall * f64::from(light.colour[k]) / 32.0 * (diffuse + specular);
        }
    }
    sum
}

/// From the middle of the picture, in half pixels.
pub(super) fn place(words: &ShaderWords, pixel: &Pixel) -> [i64; 2] {
    [
        2 * i64::from(pixel.x) - i64::from(words.size[0]),
        2 * i64::from(pixel.y) - i64::from(words.size[1]),
    ]
}

pub(super) fn ray(words: &ShaderWords, pixel: &Pixel) -> Vector {
    let distance = f64::from(words.distance);
    if !words.perspective {
        return [0.0, 0.0, distance];
    }
    let [x, y] = place(words, pixel).map(|v| (v * 32).div_euclid(1 << words.view_shift) as f64);
    [x, y, distance]
}

/// The vector to a light, in whole units of its words.
fn towards(light: &LightWords, words: &ShaderWords, pixel: &Pixel) -> Vector {
    let [x, y] = place(words, pixel);
    let full = 1i64 << (words.depth - 1);
    std::array::from_fn(|k| {
        let beside = if light.point {
            [x, y, 0][k] << light.shift
        } else {
            0
        };
        let deep = (i64::from(light.slope[k]) * pixel.depth).div_euclid(full);
        (i64::from(light.base[k]) - beside - deep) as f64
    })
}

/// `k / (d + k)`: the distance is the length of the ray to the screen, divided by what is left of the way to the far
/// end.
fn attenuation(words: &ShaderWords, pixel: &Pixel, ray: Vector) -> f64 {
    let Some(offset) = words.attenuation else {
        return 1.0;
    };
    let far = (1i64 << (words.depth - 1)) - 1 - pixel.depth;
    let far = (far << (32 - words.depth)) as f64;
    let unit = (f64::from(offset) / f64::from(1u32 << 22)).exp2();
    1.0 / (1.0 + dot(ray, ray).sqrt() / far * unit)
}
