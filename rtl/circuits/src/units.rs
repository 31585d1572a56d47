//! Every unit that is a design by itself, under the name that the catalogue gives it.

use crate::arith::*;
use crate::machine::*;
use crate::machines::objects;
pub use crate::machines::widths;
use crate::object::*;
use crate::raster::*;
use crate::shade::*;
use crate::video::*;
use imogene_contract::parameters::Parameters;
use imogene_contract::video::{LEAD, VideoMode};
use imogene_contract::words::NORMAL;
use imogene_hdl::{Bits, Design, Value};

/// A unit: its name, and what builds it.
type Unit = (&'static str, fn(&Parameters));

/// The design of a unit; none if no unit is called so.
///
/// # Panics
///
/// With the reason, where the parameters make no circuit.
pub fn design(name: &str, parameters: &Parameters) -> Option<Design> {
    let (_, build) = UNITS.iter().find(|unit| unit.0 == name)?;
    Some(Design::of(|| build(parameters)))
}

fn linear(parameters: &Parameters) -> Linear {
    Linear::input(widths(parameters.depth_word).linear)
}

fn quadric(parameters: &Parameters) -> (Linear, Quadratic) {
    let f2 = Quadratic::input(widths(parameters.depth_word).quadratic);
    (linear(parameters), f2)
}

fn network(parameters: &Parameters) -> Network {
    Network::of(parameters.depth_word, parameters.rows_per_stage)
}

fn radicand(parameters: &Parameters) -> Bits {
    Bits::input(widths(parameters.depth_word).quadratic)
}

fn roots(parameters: &Parameters) -> Roots {
    Roots::input(widths(parameters.depth_word).linear)
}

fn raster() -> (Flags, Pixel) {
    (Flags::input(), Pixel::input())
}

fn words(parameters: &Parameters) -> Words {
    Words::input(widths(parameters.depth_word), parameters.planes as usize)
}

fn candidates(parameters: &Parameters, count: u32) -> Vec<Candidate> {
    let candidate = |_| Candidate::input(parameters.depth_word, NORMAL as u32, 8);
    (0..count).map(candidate).collect()
}

/// The units that are circuits of functions.
pub const UNITS: &[Unit] = &[
    ("pe1", |p| {
        pe1("top", Flags::input(), linear(p));
    }),
    ("pe2", |p| {
        pe2("top", Flags::input(), quadric(p).1);
    }),
    ("programmable_pe", |p| {
        programmable_pe("top", Flags::input(), Program::input(), quadric(p).1);
    }),
    ("memory_pe2", |p| {
        let load = LoadWord::input(widths(p.depth_word).quadratic);
        memory_pe2("top", load, Commands::input());
    }),
    ("square_root", |p| {
        square_root("top", radicand(p), p.rows_per_stage);
    }),
    ("square_root_rows", |p| {
        square_root_rows("top", radicand(p), p.digits, p.rows_per_stage);
    }),
    ("square_root_iterative", |p| {
        square_root_iterative("top", Bits::input(1), radicand(p));
    }),
    ("square_root_non_restoring", |p| {
        square_root_non_restoring("top", radicand(p), p.rows_per_stage);
    }),
    ("square_root_leading", |p| {
        square_root_leading("top", radicand(p), p.digits, p.rows_per_stage);
    }),
    ("square_root_linear", |p| {
        square_root_linear("top", radicand(p), p.corrections);
    }),
    ("square_root_quadratic", |p| {
        square_root_quadratic("top", radicand(p), p.corrections);
    }),
    ("quadric_pe", |p| {
        quadric_pe("top", Flags::input(), quadric(p), network(p));
    }),
    ("plane_depth", |p| {
        let words = Linear::input(widths(p.depth_word).plane);
        plane_depth("top", Flags::input(), words, p.depth_word);
    }),
    ("cut_plane", |p| {
        let word = p.depth_word;
        cut_plane("top", Cut::input(word), Interval::input(word));
    }),
    ("depth_interval", |p| {
        depth_interval("top", roots(p), Bits::input(2), p.depth_word);
    }),
    ("two_volume_merge", |p| {
        let [a, b] = [(); 2].map(|()| Interval::input(p.depth_word));
        two_volume_merge("top", a, b);
    }),
    ("normal_unit", |p| {
        let words = NormalWords::of(&words(p));
        normal_unit("top", Flags::input(), Face::input(p.depth_word), words);
    }),
    ("quadric_processor", |p| {
        let shape = Shape {
            depth: p.depth_word,
            root: network(p),
            two_volumes: true,
        };
        quadric_processor("top", Flags::input(), Pixel::input(), words(p), shape);
    }),
    ("sphere_processor", |p| {
        let words = Sphere::input(widths(p.depth_word));
        sphere_processor("top", Flags::input(), Pixel::input(), words);
    }),
    ("cylinder_processor", |p| {
        let words = Cylinder::input(widths(p.depth_word));
        cylinder_processor("top", Flags::input(), Pixel::input(), words, p.depth_word);
    }),
    ("patch_decider", |p| {
        let plane = |_| PlaneAt::input(p.depth_word);
        let planes = (0..p.planes).map(plane).collect();
        patch_decider("top", roots(p), planes, p.depth_word);
    }),
    ("patch_processor", |p| {
        let patch = Patch::input(widths(p.depth_word), p.planes);
        let (flags, pixel) = raster();
        patch_processor("top", flags, pixel, patch, p.depth_word, network(p));
    }),
    ("first_generation_processor", |p| {
        let words = FirstGeneration::input(widths(p.depth_word));
        let (flags, pixel) = raster();
        first_generation_processor("top", flags, pixel, words, p.depth_word, network(p));
    }),
    ("polyhedron_processor", |p| {
        let words = Polyhedron::input(widths(p.depth_word), p.planes);
        let (flags, pixel) = raster();
        polyhedron_processor("top", flags, pixel, words, p.depth_word);
    }),
    ("polyhedral_volume", |p| {
        let bounds = Bounds::input(widths(p.depth_word), p.planes);
        let (flags, pixel) = raster();
        polyhedral_volume(
            "top",
            flags,
            pixel,
            VolumePoint::input(p.depth_word),
            bounds,
        );
    }),
    ("facet_processor", |p| {
        let widths = widths(p.depth_word);
        let facet = Facet::input(p.sides, Linear::input, widths.plane, widths.gradient);
        let (flags, pixel) = raster();
        facet_processor("top", flags, pixel, facet, p.depth_word);
    }),
    ("curved_facet_processor", |p| {
        let width = widths(p.depth_word).quadratic;
        let facet = Facet::input(p.sides, Quadratic::input, width, width);
        let (flags, pixel) = raster();
        curved_facet_processor("top", flags, pixel, facet, p.depth_word);
    }),
    ("quadric_volume", |p| {
        let words = VolumeWords::input(widths(p.depth_word), p.planes);
        let point = VolumePoint::input(p.depth_word);
        let (flags, pixel) = raster();
        quadric_volume("top", flags, pixel, point, words, network(p));
    }),
    ("raster_control", |_| {
        raster_control("top", Zone::input());
    }),
    ("visibility_node", |p| {
        let both = candidates(p, 2);
        visibility_node("top", both[0], both[1]);
    }),
    ("decider", |p| {
        decider("top", candidates(p, p.objects));
    }),
    ("visibility_chain", |p| {
        visibility_chain("top", candidates(p, p.objects));
    }),
    ("card_decider", |p| {
        let all = candidates(p, p.cards * p.objects);
        card_decider("top", all, p.objects as usize);
    }),
    ("csg_decider", |p| {
        let objects = |each: u32| {
            let convex = |_| Convex::input(p.depth_word);
            (0..p.products * each).map(convex).collect()
        };
        let (intersected, subtracted) = (objects(p.intersected), objects(p.subtracted));
        csg_decider("top", p.products as usize, intersected, subtracted);
    }),
    ("shadow_stage", |p| {
        let volumes = (0..p.objects).map(|_| Volume::input()).collect();
        shadow_stage("top", Bits::input(16), volumes);
    }),
    ("coefficient_store", |p| {
        let widths = widths(p.depth_word);
        let bus = LoadBus::input(widths.quadratic);
        coefficient_store("top", bus, widths, u64::from(p.planes));
    }),
    ("beam", |p| {
        let machine = objects(p.depth_word, p.rows_per_stage, p.objects, p.planes);
        let load = Load::input(machine.widths.quadratic);
        beam("top", Zone::input(), load, &machine);
    }),
    ("transparency_stage", |p| {
        let word = p.depth_word;
        transparency_stage(
            "top",
            crate::shade::Surface::input(word),
            Layer::input(word),
        );
    }),
    ("transparency_pipeline", |p| {
        let layers = (0..p.layers).map(|_| Layer::input(p.depth_word));
        transparency_pipeline(
            "top",
            crate::shade::Surface::input(p.depth_word),
            layers.collect(),
        );
    }),
    ("shading_processor", |p| {
        let point = Point::input(p.depth_word, NORMAL as u32);
        let load = ShadingLoad::input();
        shading_processor("top", point, load, u64::from(p.lights));
    }),
    ("video_timing", |p| {
        let mode = &VideoMode::ALL[p.mode as usize];
        video_timing("top", Bits::input(1), mode, LEAD as u64);
    }),
    ("pixel_fifo", |_| {
        pixel_fifo("top", Queue::input(3 * LEVEL), 6, LEAD as u32);
    }),
    ("frame_store", |_| {
        frame_store("top", PixelStream::input(), Asked::input(), 12);
    }),
    ("post_filter", |_| {
        post_filter("top", Bits::input(2), Picture::input(), 11);
    }),
    ("overlay", |_| {
        let colour = Colour::input(LEVEL);
        overlay(
            "top",
            BitPlane::input(10),
            Bits::input(1),
            Pixel::input(),
            colour,
        );
    }),
    ("accumulator", |_| {
        accumulator("top", PassPixel::input(12), Colour::input(LEVEL), 12);
    }),
];
