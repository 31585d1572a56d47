//! The shading processor, and shading by a table.

use super::description::{Description, behind_valid, bit, late};
use crate::stimulus::mapped;
use crate::subject::{Inputs, Stimuli, Subject};
use imogene_contract::shading::{MATERIAL_WORDS, table_latency};
use imogene_golden::format::Format;
use imogene_golden::machine::shader::{
    LATENCY, LightWords, MATERIAL_ADDRESS, Pixel, Shader, ShaderWords, SphereTables,
};
use imogene_studies::shading_trial::sequence;
use proptest::prelude::*;

/// Where the ports stand, in their order.
mod port {
    pub const VALID: usize = 0;
    pub const PIXEL: usize = 1;
    pub const DEPTH: usize = 3;
    pub const NORMAL: usize = 5;
    pub const FLAGS: usize = 8;
}

/// Inputs that load a word: valid, address, data, behind all others.
const LOAD: usize = 3;

pub(super) fn shading_processor(format: Format, lights: usize, suns: usize) -> Description {
    let stimulus = move |subject: &_, clocks| {
        words_then_pixels(subject, clocks, lights, inverted, move |seed, words| {
            let suns = words.lights[lights - suns..].iter_mut();
            suns.for_each(shine_from_afar);
            let at = u16::from(inverted(seed)) * MATERIAL_WORDS as u16;
            let loads = words.load_words().into_iter();
            let loads = loads.map(|(address, word)| match address < MATERIAL_ADDRESS {
                true => (address, word),
                false => (address ^ at, word),
            });
            let mut loads: Vec<_> = loads.collect();
            add_strays(&mut loads, seed, 16);
            loads
        })
    };
    let words = ShaderWords::unloaded(format.depth, lights);
    described(stimulus, words, LATENCY)
}

pub(super) fn lit_sphere(format: Format, places: u32, count: u32, nearest: bool) -> Description {
    let tables = SphereTables {
        nearest,
        ..SphereTables::dark(places, count, 0)
    };
    let words = ShaderWords {
        sphere: Some(tables.clone()),
        ..ShaderWords::unloaded(format.depth, 0)
    };
    let stimulus = move |subject: &_, clocks| {
        let tables = tables.clone();
        let none = |_| 0;
        words_then_pixels(subject, clocks, 1, none, move |seed, words| {
            // Words of lights and materials mean nothing to it.
            let view = words.load_words().into_iter().take(20);
            let mut loads: Vec<_> = view.chain(drawn(&tables, seed).load_words()).collect();
            add_strays(&mut loads, seed, 15);
            loads
        })
    };
    described(stimulus, words, table_latency(places, nearest))
}

/// Bits of the numbers of materials that are 1 where those of the drawn ones are 0.
fn inverted(seed: u64) -> u8 {
    (seed >> 8) as u8
}

/// Adds words at addresses with one bit inverted, of so many: others that count, or some that are not in use.
fn add_strays(loads: &mut Vec<(u16, u32)>, seed: u64, bits: u64) {
    let strays = (0..8u64).map(|n| {
        let [at, other] = [1, 2].map(|back| loads[loads.len() - back - n as usize]);
        (at.0 ^ 1 << (seed.rotate_left(8 * n as u32) % bits), other.1)
    });
    let strays: Vec<_> = strays.collect();
    loads.extend(strays);
}

/// Tables of any entries that are no brighter than white.
fn drawn(tables: &SphereTables, seed: u64) -> SphereTables {
    let mut state = seed;
    let white = if tables.nearest { 255 } else { 1020 };
    let mut level = || {
        let product = state.wrapping_mul(6_364_136_223_846_793_005);
        state = product.wrapping_add(1);
        (state >> 33) as u16 % (white + 1)
    };
    let entries = tables.entries.iter().map(|_| [(); 3].map(|()| level()));
    SphereTables {
        entries: entries.collect(),
        ..tables.clone()
    }
}

/// Words that are loaded, and the colours of pixels so many clocks later.
fn described(
    stimulus: impl Fn(&Subject, usize) -> Stimuli + Sync + 'static,
    words: ShaderWords,
    latency: u32,
) -> Description {
    Description::new(stimulus, move || {
        let mut words = words.clone();
        let mut shader = Shader::new(&words);
        let mut late = late(latency as usize);
        move |i: &[i64]| {
            let [valid, address, data] = [3, 2, 1].map(|back| i[i.len() - back]);
            if bit(valid) {
                words.load(address as u16, data as u32);
                shader = shader.reloaded(&words);
            }
            let colour = bit(i[port::VALID]).then(|| shader.pixel(&pixel(i)));
            behind_valid(late.push(colour.map(|colour| colour.map(i64::from))))
        }
    })
}

/// The pixel of inputs; without flags where every light reaches all.
fn pixel(i: &[i64]) -> Pixel {
    let [x, y, depth, material, nx, ny, nz] = std::array::from_fn(|k| i[port::PIXEL + k]);
    let has_flags = i.len() > port::FLAGS + LOAD;
    Pixel {
        x: x as u16,
        y: y as u16,
        depth,
        material: material as u8,
        normal: [nx, ny, nz].map(|v| v as i16),
        flags: if has_flags { i[port::FLAGS] as u16 } else { 0 },
    }
}

/// Words are held while pixels are inside, so they are loaded first; then pixels with gaps, in whose materials some
/// bits are inverted.
fn words_then_pixels(
    subject: &Subject,
    clocks: usize,
    lights: usize,
    inverted: fn(u64) -> u8,
    loaded: impl Fn(u64, &mut ShaderWords) -> Vec<(u16, u32)> + 'static,
) -> Stimuli {
    let depth = subject.inputs[port::DEPTH].width;
    let count = subject.inputs.len();
    let gaps = proptest::collection::vec(0u8..4, clocks + LATENCY as usize);
    mapped((any::<u64>(), gaps), move |(seed, gaps)| {
        let (mut words, pixels) = sequence(seed, depth, lights, gaps.len());
        words.is_field = seed & 3 == 0;
        let idle: Inputs = vec![0; count];
        let mut list: Vec<Inputs> = vec![];
        let mut loads = loaded(seed, &mut words);
        // The first pixel follows any word at once.
        let last = seed as usize % loads.len();
        loads.rotate_left(last);
        for (address, word) in loads {
            let mut inputs = idle.clone();
            inputs[count - 2] = address.into();
            inputs[count - 1] = word.into();
            if gaps[list.len() % gaps.len()] == 0 {
                // A word on the bus that is not valid is not loaded.
                let mut other = inputs.clone();
                other[count - 1] ^= 0xffff_ffff;
                list.push(other);
            }
            inputs[count - LOAD] = 1;
            list.push(inputs);
        }
        for (gap, p) in gaps.iter().zip(pixels) {
            let mut inputs = idle.clone();
            inputs[port::VALID] = i64::from(*gap > 0);
            let material = p.material ^ inverted(seed);
            let place = [p.x.into(), p.y.into(), p.depth, material.into()];
            inputs[port::PIXEL..port::NORMAL].copy_from_slice(&place);
            inputs[port::NORMAL..port::FLAGS].copy_from_slice(&p.normal.map(i64::from));
            if count > port::FLAGS + LOAD {
                inputs[port::FLAGS] = p.flags.into();
            }
            list.push(inputs);
        }
        list
    })
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
