//! Random words and pixels, biased to where shading is hard: grazing light, lobes at their steepest, short and
//! axis-parallel vectors, near and far points.

use super::exact::{place, ray};
use crate::trial::random::Random;
use imogene_algebra::vector::{Vector, dot};
use imogene_golden::machine::shader::{LightWords, MaterialWords, Pixel, ShaderWords};

/// Loaded words and one pixel.
#[derive(Clone, Debug)]
pub struct Case {
    /// The words.
    pub words: ShaderWords,
    /// The pixel.
    pub pixel: Pixel,
}

impl Case {
    pub(super) fn draw(random: &mut Random) -> Case {
        let depth = [16, 20, 24, 28, 32][random.below(5) as usize];
        Case::of_format(depth, random)
    }

    fn of_format(depth: u32, random: &mut Random) -> Case {
        let size = [(); 2].map(|()| {
            let bits = 1 + random.below(12);
            1 + random.below(1 << bits) as u16
        });
        let mut words = ShaderWords {
            depth,
            size,
            is_field: false,
            perspective: !random.one_in(5),
            view_shift: random.below(8) as u8,
            distance: 1 + random.magnitude(131_070.0, 12) as u32,
            attenuation: random.one_in(3).then(|| random.between(0, 30 << 22) as i32),
            offset_when_on: 0,
            background: [0; 3],
            sphere: None,
            lights: vec![],
            materials: vec![material(random)],
        };
        let mut pixel = Pixel {
            x: random.below(u64::from(size[0])) as u16,
            y: random.below(u64::from(size[1])) as u16,
            depth: draw_depth(depth, random),
            material: 0,
            normal: [0; 3],
            flags: random.bits() as u16 | random.bits() as u16,
        };
        let ray = ray(&words, &pixel);
        let normal = draw_normal(ray, random);
        pixel.normal = normal.map(|v| v.round() as i16);
        let lights = 1 + random.below(4).min(random.below(4));
        for source in 0..lights {
            let mut light = draw_light(ray, pixel.normal.map(f64::from), random);
            if random.one_in(3) {
                at_a_point(&mut light, &words, &pixel, random);
            }
            light.source = source as u8;
            words.lights.push(light);
        }
        Case { words, pixel }
    }

    /// A case near this one.
    pub(super) fn near(&self, random: &mut Random) -> Case {
        let mut case = self.clone();
        let step = |random: &mut Random| random.between(-3, 3) << random.below(8);
        for _ in 0..=random.below(3) {
            let light = random.below(case.words.lights.len() as u64) as usize;
            let light = &mut case.words.lights[light];
            let k = random.below(3) as usize;
            match random.below(8) {
                0 | 1 => {
                    let v = i64::from(case.pixel.normal[k]) + step(random);
                    case.pixel.normal[k] = v.clamp(-32768, 32767) as i16;
                }
                kind @ 2..=4 => {
                    let words = match kind {
                        4 => &mut light.slope,
                        _ => &mut light.base,
                    };
                    words[k] = bounded(i64::from(words[k]) + (step(random) << random.below(16)));
                }
                5 => {
                    let v = i64::from(case.words.materials[0].exponent) + step(random) / 16;
                    case.words.materials[0].exponent = v.clamp(1, 200) as u8;
                }
                6 => {
                    let v = i64::from(case.words.distance) + step(random);
                    case.words.distance = v.clamp(1, 131_071) as u32;
                }
                _ => light.colour[k] = random.below(81_601) as u32,
            }
        }
        case
    }
}

/// Words for a processor with so many lights and pixels that are hard for them, all from a seed.
pub fn sequence(seed: u64, depth: u32, lights: usize, pixels: usize) -> (ShaderWords, Vec<Pixel>) {
    let mut random = Random::of_case(seed, 0);
    let case = Case::of_format(depth, &mut random);
    let mut words = case.words;
    while words.lights.len() < lights {
        let more = Case::of_format(depth, &mut random);
        words.lights.extend(more.words.lights);
    }
    words.lights.truncate(lights);
    // Vectors to lights as short and as long as their words allow.
    for light in &mut words.lights {
        let most = (1 << 27) - 1;
        match random.below(6) {
            0 | 1 => light.base = light.base.map(|part| part >> random.below(27)),
            2 => light.slope = [0; 3],
            3 => {
                light.base = [(); 3].map(|()| [most, !most][random.below(2) as usize]);
                light.slope = light.base.map(|part| !part);
            }
            _ => (),
        }
    }
    words.materials = (0..5).map(|_| material(&mut random)).collect();
    words.background = [(); 3].map(|()| random.bits() as u8);
    // A viewer so far away that coordinates are shifted by all places there are; a distance of one bit.
    if random.one_in(4) {
        words.view_shift += 8;
    }
    if random.one_in(4) {
        words.distance = 1 << random.below(17);
    }
    if random.one_in(4) {
        words.size[random.below(2) as usize] = 4096;
    }
    // As far from the middle as there is.
    if random.one_in(12) {
        words.size = [4096; 2];
        words.perspective = true;
        words.view_shift = 0;
    }
    if random.one_in(2) {
        words.attenuation = Some(balanced(&words, &case.pixel, &mut random));
    }
    let far = (1i64 << (depth - 1)) - 1;
    let mut pixel = |_| {
        let mut pixel = case.pixel;
        let kind = random.below(3);
        if kind == 0 {
            pixel.x = random.below(4096) as u16;
            pixel.y = random.below(4096) as u16;
            pixel.depth = draw_depth(depth, &mut random);
            let ray = ray(&words, &pixel);
            pixel.normal = draw_normal(ray, &mut random).map(|v| v.round() as i16);
        } else {
            if kind == 1 {
                pixel.depth = draw_depth(depth, &mut random);
            }
            let k = random.below(3) as usize;
            let step = random.between(-3, 3) << random.below(8);
            pixel.normal[k] = (i64::from(pixel.normal[k]) + step).clamp(-32768, 32767) as i16;
        }
        match random.below(20) {
            0 | 1 => pixel.depth = far,
            2 => pixel.depth = far ^ 1 << random.below(u64::from(depth) - 1),
            // Towards the viewer or away, so that a product has one bit, or at a right angle to parallel lines.
            3 => {
                let z = [-1, 0, 1][random.below(3) as usize] << random.below(15);
                let [x, y, _] = pixel.normal;
                pixel.normal = match words.perspective {
                    true => [0, 0, z],
                    false => [x, y, z],
                };
            }
            // In the corner of the screen, so that the sum of two products has one bit, and the length too.
            4 => {
                let x = -1 << random.below(16);
                (pixel.x, pixel.y) = (0, 0);
                pixel.normal = [x, [0, x][random.below(2) as usize], 0];
            }
            // As short as it can be.
            5 => pixel.normal = [(); 3].map(|()| random.between(-3, 3) as i16),
            _ => (),
        }
        pixel.material = random.below(5) as u8;
        pixel.flags |= random.bits() as u16;
        pixel
    };
    let pixels = (0..pixels).map(&mut pixel).collect();
    (words, pixels)
}

fn bounded(value: i64) -> i32 {
    value.clamp(-(1 << 27), (1 << 27) - 1) as i32
}

/// The word of an attenuation that leaves half of the light at a pixel, or up to four octaves less or more.
fn balanced(words: &ShaderWords, pixel: &Pixel, random: &mut Random) -> i32 {
    let full = (1i64 << (words.depth - 1)) as f64;
    let far = (full - 1.0 - pixel.depth as f64).max(1.0) / full;
    let ray = ray(words, pixel);
    let octaves = 31.0 + far.log2() - dot(ray, ray).log2() / 2.0 + 4.0 * random.signed();
    (octaves * f64::from(1 << 22)) as i32
}

fn draw_depth(depth: u32, random: &mut Random) -> i64 {
    let far = (1i64 << (depth - 1)) - 1;
    match random.below(4) {
        0 => random.between(-far, far - 1),
        1 => far - 1 - random.magnitude(far as f64, depth - 1) as i64,
        2 => -far + random.magnitude(far as f64, depth - 1) as i64,
        _ => [0, -far, far - 1, 1, -1][random.below(5) as usize],
    }
}

fn material(random: &mut Random) -> MaterialWords {
    let share = |random: &mut Random| match random.below(3) {
        0 => 65535,
        1 => 0,
        _ => random.below(65536) as u16,
    };
    MaterialWords {
        ambient: [(); 3].map(|()| {
            let less = random.below(12);
            random.below(65536 >> less) as u16
        }),
        diffuse: [(); 3].map(|()| share(random)),
        specular: if random.one_in(4) {
            share(random)
        } else {
            65535
        },
        exponent: match random.below(3) {
            0 => 200,
            1 => 1 + random.below(4) as u8,
            _ => 1 + random.below(200) as u8,
        },
    }
}

fn direction(random: &mut Random) -> Vector {
    let sign = |random: &mut Random| if random.one_in(2) { 1.0 } else { -1.0 };
    match random.below(4) {
        0 => {
            let mut v = [0.0; 3];
            v[random.below(3) as usize] = sign(random);
            v
        }
        1 => [(); 3].map(|()| random.magnitude(1.0, 20) * sign(random)),
        _ => [(); 3].map(|()| random.signed()),
    }
}

/// A vector with its longest component at `length`.
fn scaled(v: Vector, length: f64) -> Vector {
    match v.iter().fold(0.0, |m: f64, x| m.max(x.abs())) {
        0.0 => v,
        most => v.map(|x| x / most * length),
    }
}

/// A vector turned by a random part of at most `most`, all magnitudes down to `most / 2^bits` alike.
fn near(v: Vector, (most, bits): (f64, u32), random: &mut Random) -> Vector {
    let part = random.magnitude(most, bits);
    let other = scaled(direction(random), part);
    let v = scaled(v, 1.0);
    std::array::from_fn(|k| v[k] + other[k])
}

/// The part of a vector at a right angle to an axis, of whose length this is the square.
fn across(v: Vector, axis: Vector, square: f64) -> Vector {
    let along = dot(v, axis) / square;
    std::array::from_fn(|k| v[k] - along * axis[k])
}

fn draw_normal(ray: Vector, random: &mut Random) -> Vector {
    let d = direction(random);
    let normal = match random.below(4) {
        // At a right angle to the line of sight, or nearly.
        0 => near(across(d, ray, dot(ray, ray)), (0.1, 20), random),
        1 => near(ray, (1.0, 20), random),
        _ => d,
    };
    scaled(normal, draw_length(32767.0, 15, random))
}

/// The greatest length, or a random one in one case of four.
fn draw_length(most: f64, bits: u32, random: &mut Random) -> f64 {
    match random.one_in(4) {
        true => random.magnitude(most, bits),
        false => most,
    }
}

fn draw_light(ray: Vector, normal: Vector, random: &mut Random) -> LightWords {
    let square = dot(normal, normal).max(1.0);
    // V mirrored at the normal: the middle of the highlight.
    let mirrored = std::array::from_fn(|k| ray[k] - 2.0 * dot(normal, ray) / square * normal[k]);
    let d = direction(random);
    let vector = match random.below(6) {
        0 => d,
        // Grazing.
        1 => near(across(d, normal, square), (0.1, 24), random),
        _ => near(mirrored, (0.7, 16), random),
    };
    let length = draw_length(1.3e8, 27, random);
    let bright = if random.one_in(3) { 81_600 } else { 8_160 };
    LightWords {
        base: scaled(vector, length).map(|v| bounded(v as i64)),
        colour: [(); 3].map(|()| random.below(bright + 1) as u32),
        ..LightWords::default()
    }
}

/// Makes a point light of a light, in the same direction from the pixel's point.
fn at_a_point(light: &mut LightWords, words: &ShaderWords, pixel: &Pixel, random: &mut Random) {
    light.point = true;
    light.shift = random.below(14) as u8;
    light.slope = [(); 3].map(|()| bounded((random.signed() * random.magnitude(1.3e8, 27)) as i64));
    let [x, y] = place(words, pixel);
    for (k, place) in [x, y, 0].into_iter().enumerate() {
        let deep = (i64::from(light.slope[k]) * pixel.depth) >> (words.depth - 1);
        light.base[k] = bounded(i64::from(light.base[k]) + (place << light.shift) + deep);
    }
}
