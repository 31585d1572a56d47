//! Every unit that is a design by itself, under the name that the catalogue gives it.

use crate::arith::*;
use crate::machine::*;
pub use crate::machines::widths;
use crate::machines::{MachineWords, objects};
use crate::object::*;
use crate::raster::*;
use crate::shade::*;
use crate::video::*;
use imogene_contract::video::{LEAD, VideoMode};
use imogene_contract::words::NORMAL;
use imogene_contract::{Request, Unit};
use imogene_hdl::{Bits, Design, Value};

/// The design of a unit.
///
/// # Panics
///
/// With the reason, where the parameters make no circuit.
pub fn design(request: &Request) -> Design {
    Design::of(|| build(request))
}

fn linear(p: &Request) -> Linear {
    Linear::input(widths(p.depth_word).linear)
}

fn quadric(p: &Request) -> (Linear, Quadratic) {
    let f2 = Quadratic::input(widths(p.depth_word).quadratic);
    (linear(p), f2)
}

fn network(p: &Request) -> Network {
    Network::of(p.depth_word, p.rows_per_stage)
}

fn radicand(p: &Request) -> Bits {
    Bits::input(widths(p.depth_word).quadratic)
}

fn roots(p: &Request) -> Roots {
    Roots::input(widths(p.depth_word).linear)
}

fn raster() -> (Flags, Pixel) {
    (Flags::input(), Pixel::input())
}

fn words(p: &Request) -> Words {
    Words::input(widths(p.depth_word), p.planes as usize)
}

fn candidates(p: &Request, count: u32) -> Vec<Candidate> {
    let candidate = |_| Candidate::input(p.depth_word, NORMAL as u32, 8);
    (0..count).map(candidate).collect()
}

/// Builds the circuit of a unit.
fn build(p: &Request) {
    match p.unit {
        Unit::Pe1 => {
            pe1("top", Flags::input(), linear(p));
        }
        Unit::Pe2 => {
            pe2("top", Flags::input(), quadric(p).1);
        }
        Unit::ProgrammablePe => {
            let words = SplitWords::input(widths(p.depth_word).quadratic);
            programmable_pe("top", Flags::input(), Program::input(), words);
        }
        Unit::MemoryPe2 => {
            let load = LoadWord::input(widths(p.depth_word).quadratic);
            memory_pe2("top", load, Commands::input());
        }
        Unit::SquareRoot => {
            square_root("top", radicand(p), p.rows_per_stage);
        }
        Unit::SquareRootRows => {
            square_root_rows("top", radicand(p), p.digits, p.rows_per_stage);
        }
        Unit::SquareRootIterative => {
            square_root_iterative("top", Bits::input(1), radicand(p));
        }
        Unit::SquareRootNonRestoring => {
            square_root_non_restoring("top", radicand(p), p.rows_per_stage);
        }
        Unit::SquareRootLeading => {
            square_root_leading("top", radicand(p), p.digits, p.rows_per_stage);
        }
        Unit::SquareRootLinear => {
            square_root_linear("top", radicand(p), p.corrections);
        }
        Unit::SquareRootQuadratic => {
            square_root_quadratic("top", radicand(p), p.corrections);
        }
        Unit::QuadricPe => {
            quadric_pe("top", Flags::input(), quadric(p), network(p));
        }
        Unit::PlaneDepth => {
            let words = Linear::input(widths(p.depth_word).plane);
            plane_depth("top", Flags::input(), words, p.depth_word);
        }
        Unit::CutPlane => {
            let word = p.depth_word;
            cut_plane("top", Cut::input(word), Interval::input(word));
        }
        Unit::DepthInterval => {
            depth_interval("top", roots(p), Bits::input(2), p.depth_word);
        }
        Unit::TwoVolumeMerge => {
            let [a, b] = [(); 2].map(|()| Interval::input(p.depth_word));
            two_volume_merge("top", a, b);
        }
        Unit::NormalUnit => {
            let words = NormalWords::of(&words(p));
            normal_unit("top", Flags::input(), Face::input(p.depth_word), words);
        }
        Unit::QuadricProcessor => {
            let shape = Shape {
                depth: p.depth_word,
                root: network(p),
                two_volumes: true,
            };
            quadric_processor("top", Flags::input(), Pixel::input(), words(p), shape);
        }
        Unit::SphereProcessor => {
            let words = Sphere::input(widths(p.depth_word));
            sphere_processor("top", Flags::input(), Pixel::input(), words);
        }
        Unit::CylinderProcessor => {
            let words = Cylinder::input(widths(p.depth_word));
            cylinder_processor("top", Flags::input(), Pixel::input(), words, p.depth_word);
        }
        Unit::PatchDecider => {
            let plane = |_| PlaneAt::input(p.depth_word);
            let planes = (0..p.planes).map(plane).collect();
            patch_decider("top", roots(p), planes, p.depth_word);
        }
        Unit::PatchProcessor => {
            let patch = Patch::input(widths(p.depth_word), p.planes);
            let (flags, pixel) = raster();
            patch_processor("top", flags, pixel, patch, p.depth_word, network(p));
        }
        Unit::FirstGenerationProcessor => {
            let words = FirstGeneration::input(widths(p.depth_word));
            let (flags, pixel) = raster();
            first_generation_processor("top", flags, pixel, words, p.depth_word, network(p));
        }
        Unit::PolyhedronProcessor => {
            let words = Polyhedron::input(widths(p.depth_word), p.planes);
            let (flags, pixel) = raster();
            polyhedron_processor("top", flags, pixel, words, p.depth_word);
        }
        Unit::PolyhedralVolume => {
            let bounds = Bounds::input(widths(p.depth_word), p.planes);
            let (flags, pixel) = raster();
            polyhedral_volume(
                "top",
                flags,
                pixel,
                VolumePoint::input(p.depth_word),
                bounds,
            );
        }
        Unit::FacetProcessor => {
            let widths = widths(p.depth_word);
            let facet = Facet::input(p.sides, Linear::input, widths.plane, widths.gradient);
            let (flags, pixel) = raster();
            facet_processor("top", flags, pixel, facet, p.depth_word);
        }
        Unit::CurvedFacetProcessor => {
            let width = widths(p.depth_word).quadratic;
            let facet = Facet::input(p.sides, Quadratic::input, width, width);
            let (flags, pixel) = raster();
            curved_facet_processor("top", flags, pixel, facet, p.depth_word);
        }
        Unit::QuadricVolume => {
            let words = VolumeWords::input(widths(p.depth_word), p.planes);
            let point = VolumePoint::input(p.depth_word);
            let (flags, pixel) = raster();
            quadric_volume("top", flags, pixel, point, words, network(p));
        }
        Unit::RasterControl => {
            raster_control("top", Zone::input());
        }
        Unit::VisibilityNode => {
            let both = candidates(p, 2);
            visibility_node("top", both[0], both[1]);
        }
        Unit::Decider => {
            decider("top", candidates(p, p.objects));
        }
        Unit::VisibilityChain => {
            visibility_chain("top", candidates(p, p.objects));
        }
        Unit::CardDecider => {
            let all = candidates(p, p.cards * p.objects);
            card_decider("top", all, p.objects as usize);
        }
        Unit::CsgDecider => {
            let objects = |each: u32| {
                let convex = |_| Convex::input(p.depth_word);
                (0..p.products * each).map(convex).collect()
            };
            let (intersected, subtracted) = (objects(p.intersected), objects(p.subtracted));
            csg_decider("top", p.products as usize, intersected, subtracted);
        }
        Unit::ShadowStage => {
            let volumes = (0..p.objects).map(|_| Volume::input()).collect();
            shadow_stage("top", Bits::input(16), volumes);
        }
        Unit::CoefficientStore => {
            let widths = widths(p.depth_word);
            let bus = LoadBus::input(widths.bus());
            coefficient_store("top", bus, widths, u64::from(p.planes));
        }
        Unit::Beam => {
            let slots = vec![Slot::full(p.planes as usize); p.objects as usize];
            let machine = objects(&MachineWords::of(p.depth_word), p.rows_per_stage, slots);
            let load = Load::input(machine.widths.bus());
            beam("top", Zone::input(), load, &machine);
        }
        Unit::TransparencyStage => {
            let word = p.depth_word;
            transparency_stage(
                "top",
                crate::shade::Surface::input(word),
                Layer::input(word),
            );
        }
        Unit::TransparencyPipeline => {
            let layers = (0..p.layers).map(|_| Layer::input(p.depth_word));
            transparency_pipeline(
                "top",
                crate::shade::Surface::input(p.depth_word),
                layers.collect(),
            );
        }
        Unit::ShadingProcessor => {
            let point = Point::input(p.depth_word, NORMAL as u32);
            let load = ShadingLoad::input();
            shading_processor("top", point, load, u64::from(p.lights));
        }
        Unit::VideoTiming => {
            let mode = &VideoMode::ALL[p.mode as usize];
            video_timing("top", Bits::input(1), mode, LEAD as u64);
        }
        Unit::PixelFifo => {
            pixel_fifo("top", Queue::input(3 * LEVEL), 6, LEAD as u32);
        }
        Unit::FrameStore => {
            frame_store("top", PixelStream::input(), Asked::input(), 12);
        }
        Unit::PostFilter => {
            post_filter("top", Bits::input(2), Picture::input(), 11);
        }
        Unit::Overlay => {
            let colour = Colour::input(LEVEL);
            overlay(
                "top",
                BitPlane::input(10),
                Bits::input(1),
                Pixel::input(),
                colour,
            );
        }
        Unit::Accumulator => {
            accumulator("top", PassPixel::input(12), Colour::input(LEVEL), 12);
        }
    }
}
