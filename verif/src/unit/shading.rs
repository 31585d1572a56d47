//! The shading processor.

use super::description::{Description, behind_valid, bit, late};
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::machine::shader::{LATENCY, LightWords, Pixel, Shader, ShaderWords};
use imogene_studies::shading_trial::sequence;
use proptest::prelude::*;

/// Where the ports stand, in their order.
mod port {
    pub const VALID: usize = 0;
    pub const PIXEL: usize = 1;
    pub const DEPTH: usize = 3;
    pub const LOAD_VALID: usize = 9;
    pub const LOAD_ADDRESS: usize = 10;
    pub const LOAD_DATA: usize = 11;
    pub const COUNT: usize = 12;
}

pub(super) fn shading_processor(format: Format, lights: usize, suns: usize) -> Description {
    let stimulus = move |subject: &_, clocks| words_then_pixels(subject, clocks, (lights, suns));
    Description::new(stimulus, move || {
        let mut words = ShaderWords::unloaded(format.depth, lights);
        let mut shader = Shader::new(&words);
        let mut late = late(LATENCY as usize);
        move |i: &[i64]| {
            if bit(i[port::LOAD_VALID]) {
                words.load(i[port::LOAD_ADDRESS] as u16, i[port::LOAD_DATA] as u32);
                shader = shader.reloaded(&words);
            }
            let colour = bit(i[port::VALID]).then(|| shader.pixel(&pixel(i)));
            behind_valid(late.push(colour.map(|colour| colour.map(i64::from))))
        }
    })
}

fn pixel(i: &[i64]) -> Pixel {
    let [x, y, depth, material, nx, ny, nz, flags] = std::array::from_fn(|k| i[port::PIXEL + k]);
    Pixel {
        x: x as u16,
        y: y as u16,
        depth,
        material: material as u8,
        normal: [nx, ny, nz].map(|v| v as i16),
        flags: flags as u16,
    }
}

/// Words are held while pixels are inside, so they are loaded first; then pixels with gaps.
fn words_then_pixels(
    subject: &Subject,
    clocks: usize,
    (lights, suns): (usize, usize),
) -> BoxedStrategy<Vec<Inputs>> {
    let depth = subject.inputs[port::DEPTH].width;
    let gaps = proptest::collection::vec(0u8..4, clocks + LATENCY as usize);
    (any::<u64>(), gaps)
        .prop_map(move |(seed, gaps)| {
            let (mut words, pixels) = sequence(seed, depth, lights, gaps.len());
            words.lights[lights - suns..]
                .iter_mut()
                .for_each(shine_from_afar);
            let idle: Inputs = vec![0; port::COUNT];
            let mut list: Vec<Inputs> = vec![];
            for (address, word) in words.load_words() {
                let mut inputs = idle.clone();
                inputs[port::LOAD_ADDRESS] = address.into();
                inputs[port::LOAD_DATA] = word.into();
                if gaps[list.len() % gaps.len()] == 0 {
                    // A word on the bus that is not valid is not loaded.
                    let mut other = inputs.clone();
                    other[port::LOAD_DATA] ^= 0xffff_ffff;
                    list.push(other);
                }
                inputs[port::LOAD_VALID] = 1;
                list.push(inputs);
            }
            for (gap, p) in gaps.iter().zip(pixels) {
                let [nx, ny, nz] = p.normal.map(i64::from);
                let (x, y) = (p.x.into(), p.y.into());
                let (material, flags) = (p.material.into(), p.flags.into());
                let valid = i64::from(*gap > 0);
                list.push(vec![
                    valid, x, y, p.depth, material, nx, ny, nz, flags, 0, 0, 0,
                ]);
            }
            list
        })
        .boxed()
}

/// Makes a light directional; its direction fills its words.
fn shine_from_afar(light: &mut LightWords) {
    let longest = light.base.map(|part| if part < 0 { !part } else { part });
    let longest = longest.into_iter().fold(1, i32::max);
    let places = 26 - longest.ilog2();
    *light = LightWords {
        point: false,
        shift: 0,
        slope: [0; 3],
        base: light.base.map(|part| part << places),
        ..*light
    };
}
