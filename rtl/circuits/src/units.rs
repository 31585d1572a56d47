//! Every unit that is a design by itself, under the name that the catalogue gives it.

use crate::arith::*;
use crate::machine::*;
use crate::object::*;
use crate::raster::*;
use crate::rows::PerLane;
use crate::shade::*;
use crate::video::*;
use imogene_contract::slots::FittedSlot;
use imogene_contract::video::{LEAD, MERGED, MERGED_WORDS, VideoMode};
use imogene_contract::{DeciderForm, MachineWords, Request, Unit};
use imogene_hdl::{Bits, Design, Value};

/// So many inputs that are alike.
fn each<T>(count: u32, input: impl Fn() -> T) -> Vec<T> {
    (0..count).map(|_| input()).collect()
}

/// A circuit as a design by itself.
#[track_caller]
fn alone<T>(circuit: impl FnOnce() -> T) -> Design {
    Design::of(circuit)
}

/// The design of a unit.
///
/// # Panics
///
/// With the reason, where the parameters make no circuit.
pub fn design(p: &Request) -> Design {
    let (depth, rows, planes) = (p.depth_word, p.rows_per_stage, p.planes);
    let words = MachineWords {
        root_form: p.root_form,
        ..MachineWords::of(depth)
    };
    let widths = Widths::of(&words);
    let network = Network::of(&words, rows);
    let linear = || Linear::input(widths.linear);
    let quadratic = || Quadratic::input(widths.quadratic);
    let radicand = || Bits::input(widths.quadratic);
    let roots = || Roots::input(widths.linear);
    let interval = || Interval::input(depth);
    let candidate = || Candidate::input(depth, NORMAL, 8);
    let candidates = |count: u32| each(count, candidate);
    let layer = || Layer::input(depth);
    let surface = || crate::shade::Surface::input(depth);
    match p.unit {
        Unit::Pe1 => alone(|| pe1("top", Flags::input(), linear())),
        Unit::Pe2 => alone(|| pe2("top", Flags::input(), quadratic())),
        Unit::ProgrammablePe => alone(|| {
            let words = SplitWords::input(widths.quadratic);
            programmable_pe("top", Flags::input(), Program::input(), words)
        }),
        Unit::MemoryPe2 => alone(|| {
            let load = LoadWord::input(widths.quadratic);
            memory_pe2("top", load, Commands::input())
        }),
        Unit::SquareRoot => alone(|| square_root("top", radicand(), rows)),
        Unit::SquareRootRows => alone(|| square_root_rows("top", radicand(), p.digits, rows)),
        Unit::SquareRootIterative => {
            alone(|| square_root_iterative("top", Bits::input(1), radicand()))
        }
        Unit::SquareRootNonRestoring => {
            alone(|| square_root_non_restoring("top", radicand(), rows))
        }
        Unit::SquareRootLeading => alone(|| square_root_leading("top", radicand(), p.digits, rows)),
        Unit::SquareRootLinear => alone(|| square_root_linear("top", radicand(), p.corrections)),
        Unit::SquareRootQuadratic => {
            alone(|| square_root_quadratic("top", radicand(), p.corrections))
        }
        Unit::QuadricPe => {
            alone(|| quadric_pe("top", Flags::input(), (linear(), quadratic()), network))
        }
        Unit::PlaneDepth => alone(|| {
            let words = Linear::input(widths.plane);
            plane_depth("top", Flags::input(), words, depth)
        }),
        Unit::CutPlane => alone(|| cut_plane("top", Cut::input(depth), interval())),
        Unit::QuadricCut => alone(|| {
            let limits = Limits::input(depth);
            quadric_cut("top", roots(), Bits::input(2), limits)
        }),
        Unit::NormalUnit => alone(|| {
            let words = NormalWords::input(widths, planes);
            let root = scaled_root_width(depth, widths.normal);
            normal_unit("top", Flags::input(), Face::input(root), words)
        }),
        Unit::QuadricProcessor => alone(|| {
            let words = Words::input(widths, planes);
            quadric_processor("top", Scan::input(), words, network)
        }),
        Unit::QuotientProcessor => alone(|| {
            let words = Quotient::input(widths, planes);
            quotient_processor("top", Scan::input(), words, network)
        }),
        Unit::SphereProcessor => {
            alone(|| sphere_processor("top", Scan::input(), Sphere::input(widths)))
        }
        Unit::CylinderProcessor => {
            alone(|| cylinder_processor("top", Scan::input(), Cylinder::input(widths), depth))
        }
        Unit::PatchDecider => alone(|| {
            let planes = each(planes, || PlaneAt::input(depth));
            patch_decider("top", roots(), planes)
        }),
        Unit::PatchProcessor => alone(|| {
            let words = Patch::input(widths, planes);
            patch_processor("top", Scan::input(), words, network)
        }),
        Unit::FirstGenerationProcessor => alone(|| {
            let words = FirstGeneration::input(widths);
            first_generation_processor("top", Scan::input(), words, network)
        }),
        Unit::PolyhedronProcessor => alone(|| {
            let words = Polyhedron::input(widths, planes);
            polyhedron_processor("top", Scan::input(), words, depth)
        }),
        Unit::PolyhedralVolume => alone(|| {
            let bounds = Bounds::input(widths, planes);
            polyhedral_volume("top", Scan::input(), VolumePoint::input(depth), bounds)
        }),
        Unit::FacetProcessor => alone(|| {
            let facet = Facet::input(p.sides, Linear::input, widths.plane, widths.gradient);
            facet_processor("top", Scan::input(), facet, depth)
        }),
        Unit::CurvedFacetProcessor => alone(|| {
            let width = widths.quadratic;
            let facet = Facet::input(p.sides, Quadratic::input, width, width);
            curved_facet_processor("top", Scan::input(), facet, depth)
        }),
        Unit::QuadricVolume => alone(|| {
            let words = VolumeWords::input(widths, planes);
            let point = VolumePoint::input(depth);
            quadric_volume("top", Scan::input(), point, words, network)
        }),
        Unit::RasterControl => alone(|| raster_control("top", Zone::input())),
        Unit::VisibilityNode => alone(|| visibility_node("top", candidate(), candidate())),
        Unit::Decider => alone(|| decider("top", candidates(p.objects))),
        Unit::VisibilityChain => alone(|| visibility_chain("top", candidates(p.objects))),
        Unit::CardDecider => alone(|| {
            let all = candidates(p.cards * p.objects);
            card_decider("top", all, p.objects as usize)
        }),
        Unit::CsgProduct => alone(|| {
            let objects = |count| each(count, || Extent::input(depth, NORMAL, 8));
            csg_product("top", objects(p.intersected), objects(p.subtracted))
        }),
        Unit::ShadowStage => alone(|| {
            let volumes = each(p.objects, Volume::input);
            shadow_stage("top", Bits::input(16), volumes)
        }),
        Unit::CoefficientStore => alone(|| {
            let bus = LoadBus::input(widths.bus());
            coefficient_store("top", bus, widths, planes.into())
        }),
        Unit::Beam => alone(|| {
            let machine = Objects {
                words,
                rows_per_stage: rows,
                slots: vec![FittedSlot::quadric(planes); p.objects as usize],
                products: vec![],
                decider: DeciderForm::Tree,
                lanes: 1,
            };
            beam("top", Zone::input(), Load::input(widths.bus()), &machine)
        }),
        Unit::TransparencyStage => alone(|| transparency_stage("top", surface(), layer())),
        Unit::TransparencyPipeline => {
            alone(|| transparency_pipeline("top", surface(), each(p.layers, layer)))
        }
        Unit::ShadingProcessor => alone(|| {
            let point = Point::input(depth, NORMAL);
            let (count, suns) = (p.lights.into(), p.suns.into());
            shading_processor("top", point, ShadingLoad::input(), Lights { count, suns })
        }),
        Unit::LitSphere | Unit::LitSphereNearest => alone(|| {
            let tables = Tables {
                places: p.table_places,
                count: p.tables,
                nearest: p.unit == Unit::LitSphereNearest,
                entries: vec![],
            };
            let (point, load) = (SpherePoint::input(depth, NORMAL), ShadingLoad::input());
            match tables.nearest {
                true => lit_sphere_nearest("top", point, load, &tables),
                false => lit_sphere("top", point, load, &tables),
            }
        }),
        Unit::VideoTiming => alone(|| {
            let mode = &VideoMode::ALL[p.mode as usize];
            video_timing("top", Bits::input(1), mode, LEAD as u64)
        }),
        Unit::TmdsEncoder => alone(|| tmds_encoder("top", Channel::input())),
        Unit::TmdsSerialiser => alone(|| tmds_serialiser("top", Symbols::input())),
        Unit::SceneSequencer => alone(|| scene_sequencer("top", Sequence::input())),
        Unit::PixelFifo => alone(|| pixel_fifo("top", Queue::input(3 * LEVEL), 6, LEAD as u32)),
        Unit::LineMerger => alone(|| {
            let (modules, words) = (MERGED as u32, MERGED_WORDS as u64);
            let lines = ModuleStream {
                tvalid: Bits::input(1),
                tdata: PerLane::of(modules, |_| Bits::input(3 * LEVEL)),
                tuser: Bits::input(1),
                tlast: Bits::input(1),
            };
            line_merger("top", lines, Bits::input(1), Group { modules, words })
        }),
        Unit::FrameStore => alone(|| frame_store("top", PixelStream::input(), Asked::input(), 12)),
        Unit::PostFilter => alone(|| post_filter("top", Bits::input(2), Picture::input(), 11)),
        Unit::Overlay => alone(|| {
            let shown = (Bits::input(1), Pixel::input(), Colour::input(LEVEL));
            overlay("top", BitPlane::input(10), shown)
        }),
        Unit::Accumulator => {
            alone(|| accumulator("top", PassPixel::input(12), Colour::input(LEVEL), 12))
        }
    }
}
