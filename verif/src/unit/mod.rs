//! Every unit as a [`Subject`]: ports, hardware, golden model, stimulus; one file per group of units.

mod board;
mod decision;
mod depth;
mod description;
mod elementary;
mod likely;
mod machine;
mod normal;
mod object;
mod root;
mod shading;
mod video;
pub mod words;

use crate::engine::circuit::{self, Circuit, Compiled};
use crate::engine::design::DesignError;
use crate::engine::machine::driven;
use crate::engine::simulator::with_verilog;
use crate::engine::{BUILT_IN, Engine, LEVELISED};
use crate::signal::Signal;
use crate::subject::{LANES, Subject};
use description::Description;
use imogene_contract::{MachineWords, Request, RequestError, Unit};
use imogene_golden::format::Format;
use imogene_golden::unit::root::Method;
use imogene_hdl::Direction;
use imogene_rtl::emit::{design, emit};
use std::sync::OnceLock;

/// Units that are not loaded over a bus, which would take random stimulus many clocks: for tests of all units.
pub fn units() -> impl Iterator<Item = Unit> {
    let is_loaded = |unit: &Unit| matches!(unit, Unit::CoefficientStore | Unit::Beam);
    Unit::ALL.into_iter().filter(move |unit| !is_loaded(unit))
}

/// A unit with its parameters, ready to be co-simulated.
pub fn subject(request: &Request) -> Result<Subject, RequestError> {
    let request = *request;
    let top = design(&request)?.top;
    // Compiled once, when it first runs.
    let [alone, side_by_side] = [(); 2].map(|()| OnceLock::new());
    let design = move || design(&request).expect("a checked request");
    let Description {
        golden,
        stimulus,
        longest,
    } = describe(&request).apart(request.root_form.clocks(request.depth_word));
    Ok(Subject {
        name: request.unit.name().to_owned(),
        engine: BUILT_IN,
        inputs: top.ports_of(Direction::In).map(Signal::of).collect(),
        outputs: top.ports_of(Direction::Out).map(Signal::of).collect(),
        lanes: LANES,
        hardware: Box::new(move |runs| {
            let compiled = match runs {
                1 => alone.get_or_init(|| Compiled::of(&design(), &[])),
                _ => side_by_side.get_or_init(|| Compiled::in_lanes(&design())),
            };
            Box::new(Circuit::new(compiled))
        }),
        golden,
        stimulus,
        longest,
        latency: request.latency(),
        options: request.arguments(),
    })
}

/// The same in the simulator of `imogene-hdl`, where memories may upset what is read while it is written.
pub fn levelised(request: &Request, upsets_collisions: bool) -> Result<Subject, RequestError> {
    let design = circuit::levelised(design(request)?, upsets_collisions);
    Ok(driven(subject(request)?, LEVELISED, design))
}

impl Engine {
    /// A unit in this engine; a simulator runs what is emitted of it.
    pub fn unit(self, request: &Request) -> Result<Subject, DesignError> {
        let subject = subject(request)?;
        match self {
            Engine::BuiltIn => Ok(subject),
            Engine::Verilog(simulator) => {
                let emitted = emit(request)?;
                with_verilog(subject, simulator, &emitted.top, &emitted.bundle())
            }
        }
    }
}

/// Joins each unit to its golden model and stimulus.
fn describe(p: &Request) -> Description {
    let words = MachineWords {
        root_form: p.root_form,
        ..MachineWords::of(p.depth_word)
    };
    let format = Format::fitted(&words).expect("a checked request");
    let n = |count: u32| count as usize;
    let [planes, rows, objects] = [p.planes, p.rows_per_stage, p.objects].map(n);
    let network = |method| root::network(format, method, rows);
    let (kept, corrections) = (p.digits, p.corrections);
    match p.unit {
        Unit::Pe1 => elementary::pe1(format),
        Unit::Pe2 => elementary::pe2(format),
        Unit::SquareRoot => network(Method::Restoring),
        Unit::SquareRootNonRestoring => network(Method::NonRestoring),
        Unit::SquareRootIterative => root::iterative(format),
        Unit::SquareRootRows => network(Method::Rows { kept }),
        Unit::SquareRootLeading => network(Method::Leading { kept }),
        Unit::SquareRootLinear => network(Method::Linear { corrections }),
        Unit::SquareRootQuadratic => network(Method::Quadratic { corrections }),
        Unit::QuadricPe => root::quadric_pe(format, rows),
        Unit::PlaneDepth => depth::plane_depth(format),
        Unit::CutPlane => depth::cut_plane(format),
        Unit::QuadricCut => depth::quadric_cut(format),
        Unit::NormalUnit => normal::normal_unit(planes),
        Unit::ProgrammablePe => elementary::programmable_pe(format),
        Unit::MemoryPe2 => elementary::memory_pe2(format),
        Unit::PatchDecider => depth::patch_decider(format),
        Unit::QuadricProcessor
        | Unit::QuotientProcessor
        | Unit::PatchProcessor
        | Unit::FirstGenerationProcessor
        | Unit::FacetProcessor
        | Unit::CurvedFacetProcessor
        | Unit::SphereProcessor
        | Unit::CylinderProcessor => object::object_processor(p, format),
        Unit::PolyhedronProcessor => object::polyhedron_processor(format, planes),
        Unit::QuadricVolume => object::volume(format, planes, Some(rows)),
        Unit::PolyhedralVolume => object::volume(format, planes, None),
        Unit::RasterControl => video::raster_control(),
        Unit::CoefficientStore => machine::coefficient_store(format, planes),
        Unit::Beam => machine::beam(format, objects, planes, rows),
        Unit::VideoTiming => video::video_timing(n(p.mode)),
        Unit::TmdsEncoder => board::tmds_encoder(),
        Unit::TmdsSerialiser => board::tmds_serialiser(),
        Unit::SceneSequencer => board::scene_sequencer(),
        Unit::PixelFifo => video::pixel_fifo(),
        Unit::LineMerger => video::line_merger(),
        Unit::FrameStore => video::frame_store(),
        Unit::PostFilter => video::post_filter(),
        Unit::Overlay => video::overlay(),
        Unit::Accumulator => video::accumulator(),
        Unit::ShadingProcessor => shading::shading_processor(format, n(p.lights), n(p.suns)),
        Unit::LitSphere => shading::lit_sphere(format, p.table_places, p.tables, false),
        Unit::LitSphereNearest => shading::lit_sphere(format, p.table_places, p.tables, true),
        Unit::VisibilityNode => decision::visibility_node(),
        Unit::VisibilityChain => decision::visibility_chain(objects),
        Unit::CardDecider => decision::card_decider(objects, n(p.cards)),
        Unit::ShadowStage => decision::shadow_stage(objects),
        Unit::TransparencyStage => decision::transparency_stage(),
        Unit::TransparencyPipeline => decision::transparency_pipeline(n(p.layers)),
        Unit::CsgProduct => decision::csg_product(format, n(p.intersected), n(p.subtracted)),
        Unit::Decider => decision::decider(objects),
    }
}
