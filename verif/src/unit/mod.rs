//! Every unit as a [`Subject`]: ports, hardware, golden model, stimulus; one file per group of units.

mod decision;
mod depth;
mod elementary;
mod facet;
mod first_generation;
mod lighting;
mod machine;
mod memory;
mod normal;
mod patch;
mod polyhedron;
mod processor;
mod programmable;
mod raster;
mod root;
mod root_family;
mod round;
mod shading;
mod solid;
mod transparency;
mod video;
mod video_filter;
mod video_stream;
mod volume;
pub mod words;
mod zone;

use crate::engine::BUILT_IN;
use crate::engine::circuit::Circuit;
use crate::signal::Signal;
use crate::subject::{Golden, Inputs, Stimulus, Subject};
use imogene_contract::{Request, RequestError, Unit};
use imogene_golden::format::Format;
use imogene_hdl::{Direction, Module, PortRecord};
use imogene_rtl::emit::design;

/// Units that the tests of all units run over: those that are not loaded over a bus, for which random stimulus would
/// need many clocks to load a scene.
pub fn units() -> impl Iterator<Item = Unit> {
    let is_loaded = |unit: &Unit| matches!(unit, Unit::CoefficientStore | Unit::Beam);
    Unit::ALL.into_iter().filter(move |unit| !is_loaded(unit))
}

/// A unit with its parameters, ready to be co-simulated.
///
/// # Errors
///
/// When a parameter is out of its range.
pub fn subject(request: &Request) -> Result<Subject, RequestError> {
    let request = *request;
    let top = design(&request)?.top;
    let Description { golden, stimulus } = describe(&request);
    Ok(Subject {
        name: request.unit.name().to_owned(),
        engine: BUILT_IN,
        inputs: signals(&top, Direction::In),
        outputs: signals(&top, Direction::Out),
        hardware: Box::new(move || {
            let design = design(&request).expect("a checked request");
            Box::new(Circuit::new(&design))
        }),
        golden,
        stimulus,
        latency: request.latency(),
        options: request.arguments(),
    })
}

fn signals(top: &Module, direction: Direction) -> Vec<Signal> {
    let ports = top.ports_of(direction);
    let signal = |port: &PortRecord| Signal {
        name: port.name.clone(),
        width: port.width,
        signed: port.signed,
    };
    ports.map(signal).collect()
}

/// The inputs of a unit.
fn inputs(request: &Request) -> Vec<Signal> {
    signals(
        &design(request).expect("a legal request").top,
        Direction::In,
    )
}

/// What a file of this module states of a unit; ports and hardware are those of its circuit.
struct Description {
    /// Takes the inputs and gives the outputs in the order of the ports.
    golden: Box<dyn Fn() -> Box<dyn Golden> + Sync>,
    stimulus: Stimulus,
}

/// Joins each unit to its golden model and stimulus.
fn describe(p: &Request) -> Description {
    let format = Format::new(p.depth_word).expect("a checked request");
    let n = |count: u32| count as usize;
    match p.unit {
        Unit::Pe1 => elementary::pe1(format.sum),
        Unit::Pe2 => elementary::pe2(format.quadratic),
        Unit::SquareRoot => root::square_root(format, n(p.rows_per_stage)),
        Unit::SquareRootNonRestoring => root_family::non_restoring(format, n(p.rows_per_stage)),
        Unit::SquareRootIterative => root_family::iterative(format),
        Unit::SquareRootRows => root_family::rows(format, p.digits, n(p.rows_per_stage)),
        Unit::SquareRootLeading => root_family::leading(format, p.digits, n(p.rows_per_stage)),
        Unit::SquareRootLinear => root_family::linear(format, p.corrections),
        Unit::SquareRootQuadratic => root_family::quadratic(format, p.corrections),
        Unit::QuadricPe => root::quadric_pe(format, n(p.rows_per_stage)),
        Unit::DepthInterval => depth::depth_interval(format),
        Unit::PlaneDepth => depth::plane_depth(format),
        Unit::CutPlane => depth::cut_plane(format),
        Unit::TwoVolumeMerge => depth::two_volume_merge(),
        Unit::NormalUnit => normal::normal_unit(n(p.planes)),
        Unit::QuadricProcessor => {
            processor::quadric_processor(format, n(p.planes), n(p.rows_per_stage))
        }
        Unit::ProgrammablePe => programmable::programmable_pe(format),
        Unit::MemoryPe2 => memory::memory_pe2(format),
        Unit::PatchDecider => patch::patch_decider(format),
        Unit::PatchProcessor => patch::patch_processor(format, n(p.planes), n(p.rows_per_stage)),
        Unit::FirstGenerationProcessor => {
            first_generation::first_generation_processor(format, n(p.rows_per_stage))
        }
        Unit::PolyhedronProcessor => polyhedron::polyhedron_processor(format, n(p.planes)),
        Unit::FacetProcessor => facet::facet_processor(format, n(p.sides)),
        Unit::CurvedFacetProcessor => facet::curved_facet_processor(format, n(p.sides)),
        Unit::SphereProcessor => round::sphere_processor(format),
        Unit::CylinderProcessor => round::cylinder_processor(format),
        Unit::QuadricVolume => volume::quadric_volume(format, n(p.planes), n(p.rows_per_stage)),
        Unit::PolyhedralVolume => volume::polyhedral_volume(format, n(p.planes)),
        Unit::RasterControl => raster::raster_control(),
        Unit::CoefficientStore => machine::coefficient_store(format, n(p.planes)),
        Unit::Beam => machine::beam(format, n(p.objects), n(p.planes), n(p.rows_per_stage)),
        Unit::VideoTiming => video::video_timing(n(p.mode)),
        Unit::PixelFifo => video_stream::pixel_fifo(),
        Unit::FrameStore => video_stream::frame_store(),
        Unit::PostFilter => video_filter::post_filter(),
        Unit::Overlay => video_filter::overlay(),
        Unit::Accumulator => video_filter::accumulator(),
        Unit::ShadingProcessor => shading::shading_processor(format, n(p.lights)),
        Unit::VisibilityNode => decision::visibility_node(),
        Unit::VisibilityChain => decision::visibility_chain(n(p.objects)),
        Unit::CardDecider => decision::card_decider(n(p.objects), n(p.cards)),
        Unit::ShadowStage => lighting::shadow_stage(n(p.objects)),
        Unit::TransparencyStage => transparency::transparency_stage(),
        Unit::TransparencyPipeline => transparency::transparency_pipeline(n(p.layers)),
        Unit::CsgDecider => {
            solid::csg_decider(format, n(p.products), n(p.intersected), n(p.subtracted))
        }
        Unit::Decider => decision::decider(n(p.objects)),
    }
}

/// A port value as a bit.
fn bit(value: i64) -> bool {
    value != 0
}

/// What a golden model with a fixed latency states: results come out `latency` edges after their inputs went in.
struct Late<T> {
    delay: crate::signal::Delay<T>,
}

impl<T> Late<T> {
    fn new(latency: usize) -> Late<T> {
        Late {
            delay: crate::signal::Delay::new(latency - 1),
        }
    }

    fn push(&mut self, result: T) -> Option<T> {
        self.delay.push(result)
    }
}

/// A stimulus of raster flags on the first three ports and words on the others.
fn any_raster(subject: &Subject, clocks: usize) -> proptest::strategy::BoxedStrategy<Vec<Inputs>> {
    crate::stimulus::raster(&subject.inputs, clocks)
}
