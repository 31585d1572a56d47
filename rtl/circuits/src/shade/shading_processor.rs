//! Shading processor.

use super::LEVEL;
use super::attenuation::attenuation;
use super::clocks::{FACTORS, HIGHLIGHT};
use super::light_factors::light_factors;
use super::light_vector::{light_vector, sun_vector};
use super::sent_light::{Material, SENT_LIGHT, sent_light};
use super::sight::sight;
use super::words::{light_store, sun_store, view_store};
use crate::machine::LoadBus;
use crate::object::Normal;
use crate::raster::Pixel;
use crate::video::Colour;
use imogene_contract::shading::{
    self, LATENCY, LIGHT, LIGHT_WORDS, MATERIAL, MATERIAL_WORDS, MOST_MATERIALS,
};
use imogene_contract::words::far_end;
use imogene_hdl::{Bits, Bundle, Int, Value, bundle, bundles, memory, module, net};

/// Bits of what is sent of a light, of which the highest two are 0, and bits behind the point.
const SENT: u32 = 36;
const FRACTION: u32 = shading::LEVEL_FRACTION as u32;
/// Clock of a pixel at which its exponent is read, and at which its other words are; a register behind the memory
/// gives them two clocks later.
const EXPONENT: u32 = HIGHLIGHT - 2;
const SHARES: u32 = FACTORS - 2;

bundle! {
    /// Words for a shading processor.
    ShadingLoad() {
        valid: Bits(1), "write a word; only while no pixel is inside";
        address: Bits(16), "address of the word, section 8 of the architecture";
        data: Bits(32), "the word, in the low bits";
    }
}

impl ShadingLoad {
    /// The same as a bus of words.
    pub(super) fn bus(self) -> LoadBus {
        LoadBus {
            write: self.valid,
            address: self.address,
            data: self.data,
        }
    }
}

/// Lights of a shading processor.
#[derive(Clone, Copy, Debug)]
pub struct Lights {
    /// All of them.
    pub count: u64,
    /// Of these, the last ones that are directional alone.
    pub suns: u64,
}

bundles! {
    /// A visible point.
    Point(depth: u32, normal: u32) {
        valid: Bits(1) as "valid", "this clock carries a pixel";
        pixel: Pixel() as "", "pixel of the screen";
        depth: Int(depth) as "depth", "depth; 2^(W-1) - 1 is the background";
        material: Bits(8) as "material", "number of the material";
        normal: Normal(normal) as "", "vector of any length";
        flags: Bits(16) as "flags", "bit i: source i reaches the point";
    }
}

bundle! {
    /// The colour of a pixel.
    Shaded() {
        out_valid: Bits(1), "valid, with the colour of its pixel";
        red: Bits(LEVEL), "red, 0 to 255";
        green: Bits(LEVEL), "green, 0 to 255";
        blue: Bits(LEVEL), "blue, 0 to 255";
    }
}

impl Shaded {
    /// Its colour.
    pub fn colour(&self) -> Colour {
        Colour::of([self.red, self.green, self.blue])
    }
}

/// The colour of every pixel by the formula of Phong, one pixel per clock, from depth, normal, material and the flags
/// of the sources, with some lights at once.
///
/// Latency 66. For the wires, a register stands before every multiplier, behind products that are added, behind the
/// load bus and behind the pixel.
/// Words stay unchanged while pixels are inside. Section 8 of the architecture; Chaillou 1991, III.1.2.
pub fn shading_processor(at: &str, point: Point, load: ShadingLoad, lights: Lights) -> Shaded {
    let inputs = (point, ("load", load));
    module("shading_processor", at, inputs, |(point, load)| {
        // A word comes to its store a clock late, and so does the pixel that it counts for.
        let point = point.delayed(1);
        let view = view_store("view_store", part(load, 0, LIGHT, 32).delayed(1));
        let (sight, ray_places) = sight("sight", point.pixel, point.normal, view.eye);
        let depth = &point.depth;
        let width = depth.width();
        let left = |depth: Bits| depth.extend(32).left(32 - width);
        // What is left of the way to the far end: all bits but the sign are inverted.
        let sign = Bits::new(1 << (width - 1), width);
        net! {
            let kept_far = left(!depth.bits() ^ sign).reg();
        }
        let ray = (sight.ray_log, ray_places);
        let loss = attenuation("attenuation", view.fog, kept_far, ray);
        let material = materials(load, point.material);
        let sent = (0..lights.count).map(|light| {
            let bus = part(load, LIGHT + light * LIGHT_WORDS, LIGHT_WORDS, 28).delayed(1);
            let store = format!("light_stores_{light}");
            let (source, vector, colour) = if light + lights.suns < lights.count {
                let (source, place, colour) = light_store(&store, bus);
                let at = format!("vectors_{light}");
                let vector = light_vector(&at, place, sight.place, *depth);
                (source, vector, colour)
            } else {
                let (source, direction, colour) = sun_store(&store, bus);
                (source, sun_vector(direction), colour)
            };
            let (own, late) = ((source, vector), (material.exponent, loss));
            let at = format!("factors_{light}");
            let factors = light_factors(&at, own, sight, point.flags, late);
            sent_light(&format!("sent_{light}"), factors, material.own, colour).parts()
        });
        let sent: Vec<[Bits; 3]> = sent.collect();
        let is_far = depth.is(far_end(width) as u64);
        let is_far = is_far.delayed_as("is_far", LATENCY as u32 - 2);
        let ambient = material.ambient.parts();
        let background = view.background.parts();
        let [red, green, blue] = [0, 1, 2].map(|channel| {
            let sent = sent.iter().map(|levels| levels[channel]);
            let level = level(sent.collect(), ambient[channel]);
            is_far.select(background[channel], level).reg()
        });
        Shaded {
            out_valid: point.valid.delayed_as("valid_late", LATENCY as u32 - 1),
            red,
            green,
            blue,
        }
    })
}

/// Words of the material of a pixel.
struct Shares {
    exponent: Bits,
    ambient: Colour,
    own: Material,
}

/// Keeps the words of all materials, and gives those of one material when the pixel needs them: what is needed at two
/// clocks stands in two memories.
fn materials(load: ShadingLoad, number: Bits) -> Shares {
    let bus = part(load, MATERIAL, MATERIAL_WORDS * MOST_MATERIALS, 32).delayed(1);
    let early = number.delayed_as("material_early", EXPONENT);
    let late = early.delayed_as("material_late", SHARES - EXPONENT);
    let last = late.delayed_as("material_last", SENT_LIGHT);
    let entry = bus.address.slice(9, 2);
    let kept = |name: &str, index: u64, (high, low): (u32, u32), read: Bits| {
        let write = bus.write & bus.address.low(2).is(index);
        let write = (write, entry, bus.data.slice(high, low));
        let store = format!("materials_{name}");
        let word = memory(&store, MOST_MATERIALS as usize, write, read);
        word.reg().named(&format!("material_{name}"))
    };
    let [low, high, all] = [(15, 0), (31, 16), (31, 0)];
    let ambient = kept("ambient", 0, all, last);
    let share = kept("share", 2, all, late);
    let [low_of, high_of] = [|word: Bits| word.low(16), |word: Bits| word.slice(31, 16)];
    Shares {
        exponent: kept("exponent", 3, (23, 16), early),
        ambient: Colour::of([
            low_of(ambient),
            high_of(ambient),
            kept("ambient_b", 1, low, last),
        ]),
        own: Material {
            mirror: kept("mirror", 1, high, late),
            share: Colour::of([low_of(share), high_of(share), kept("share_b", 3, low, late)]),
        },
    }
}

/// The words that begin at an address, as many as a power of two.
pub(super) fn part(load: ShadingLoad, first: u64, words: u64, width: u32) -> LoadBus {
    let places = words.ilog2();
    LoadBus {
        write: load.valid & load.address.slice(15, places).is(first >> places),
        address: load.address.low(places),
        data: load.data.low(width),
    }
}

/// Ambient light and what the surface sends back of each light, rounded to a level; the brightest one where it is more.
fn level(sent: Vec<Bits>, ambient: Bits) -> Bits {
    // Of ambient light and rounding there is less than a 32nd of what one light can send.
    let width = SENT.max(SENT - 1 + sent.len().ilog2());
    let ambient = ambient.extend(width).left(FRACTION - LEVEL);
    let rounded = ambient + Bits::new(1 << (FRACTION - 1), width);
    let sent = sent.into_iter().map(|level| level.extend(width));
    let parts: Vec<Bits> = sent.chain([rounded]).collect();
    let sum = |parts: &[Bits]| {
        let parts = parts.iter().copied();
        let sum = parts.reduce(|one, other| one + other);
        sum.expect("a light").reg()
    };
    let pair = |(place, pair)| sum(pair).named(&format!("pair_sum_{place}"));
    let sums: Vec<Bits> = parts.chunks(2).enumerate().map(pair).collect();
    net! { let level_sum = sum(&sums); }
    let is_less = level_sum.slice(width - 1, FRACTION + LEVEL).is(0);
    let brightest = Bits::new((1 << LEVEL) - 1, LEVEL);
    is_less.select(level_sum.slice(FRACTION + LEVEL - 1, FRACTION), brightest)
}
