//! Verilog of a unit.
//!
//! A block is connected and checked by rust-hdl, collected through a probe, lowered to typed expressions, and written as plain
//! Verilog-2005: each distinct module once, registers as `reg`s, no identifier that another language reserves. rust-hdl's own
//! text is not used: it drops widths and precedence. The same request gives the same text, byte for byte.

mod census;
mod circuit;
mod collect;
pub mod display;
mod error;
mod lower;
pub mod machine;
mod memory;
mod merge;
mod module;
mod names;
mod raw;
mod request;
#[cfg(test)]
mod tests;

use crate::catalogue::Unit;
use crate::kernel::Ports;
use crate::machine::accumulator::Accumulator;
use crate::machine::beam::Beam;
use crate::machine::card_decider::CardDecider;
use crate::machine::coefficient_store::CoefficientStore;
use crate::machine::csg_decider::CsgDecider;
use crate::machine::decider::Decider;
use crate::machine::frame_store::FrameStore;
use crate::machine::overlay::Overlay;
use crate::machine::pixel_fifo::PixelFifo;
use crate::machine::post_filter::PostFilter;
use crate::machine::raster_control::RasterControl;
use crate::machine::shading_processor::ShadingProcessor;
use crate::machine::shadow_stage::ShadowStage;
use crate::machine::transparency_pipeline::TransparencyPipeline;
use crate::machine::transparency_stage::TransparencyStage;
use crate::machine::video_mode::VideoMode;
use crate::machine::video_timing::VideoTiming;
use crate::machine::visibility_chain::VisibilityChain;
use crate::machine::visibility_node::VisibilityNode;
use crate::object::curved_facet_processor::CurvedFacetProcessor;
use crate::object::cylinder_processor::CylinderProcessor;
use crate::object::facet_processor::FacetProcessor;
use crate::object::first_generation_processor::FirstGenerationProcessor;
use crate::object::patch_processor::PatchProcessor;
use crate::object::polyhedral_volume::PolyhedralVolume;
use crate::object::polyhedron_processor::PolyhedronProcessor;
use crate::object::quadric_processor::QuadricProcessor;
use crate::object::quadric_volume::QuadricVolume;
use crate::object::sphere_processor::SphereProcessor;
use crate::step::Clocked;
use crate::unit::cut_plane::CutPlane;
use crate::unit::depth_interval::DepthInterval;
use crate::unit::memory_pe2::MemoryPe2;
use crate::unit::normal_unit::NormalUnit;
use crate::unit::patch_decider::PatchDecider;
use crate::unit::pe1::Pe1;
use crate::unit::pe2::Pe2;
use crate::unit::plane_depth::PlaneDepth;
use crate::unit::programmable_pe::ProgrammablePe;
use crate::unit::quadric_pe::QuadricPe;
use crate::unit::square_root::SquareRoot;
use crate::unit::square_root_iterative::SquareRootIterative;
use crate::unit::square_root_leading::SquareRootLeading;
use crate::unit::square_root_linear::SquareRootLinear;
use crate::unit::square_root_non_restoring::SquareRootNonRestoring;
use crate::unit::square_root_quadratic::SquareRootQuadratic;
use crate::unit::square_root_rows::SquareRootRows;
use crate::unit::two_volume_merge::TwoVolumeMerge;
pub use census::{Census, census};
use collect::{Scope, collect};
pub use error::EmitError;
use imogene_circuits::units;
pub use raw::raw;
pub use request::EmitRequest;
use rust_hdl::core::prelude::{AtomKind, Block};
use serde::{Deserialize, Serialize};
use std::fmt::Write;

/// Direction of a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Direction {
    /// Into the unit.
    Input,
    /// Out of the unit.
    Output,
}

/// A port of the emitted module.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Port {
    /// Name in the Verilog.
    pub name: String,
    /// Direction.
    pub direction: Direction,
    /// Bits.
    pub width: usize,
    /// Two's complement.
    pub signed: bool,
}

/// The Verilog of a unit.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Emitted {
    /// Name of the top module.
    pub top: String,
    /// Comment that states parameters, latency, ports and the command that makes the text.
    pub header: String,
    /// Names and texts of the modules, leaves first, the top module last.
    pub modules: Vec<(String, String)>,
    /// Ports of the top module, in its order.
    pub ports: Vec<Port>,
    /// Clocks from the first input of a computation to its result.
    pub latency: usize,
}

impl Emitted {
    /// All modules as the text of one file.
    pub fn bundle(&self) -> String {
        let mut text = self.header.clone();
        for (_, module) in &self.modules {
            text.push('\n');
            text += module;
        }
        text
    }

    /// One file for each module, by name, leaves first: the form in which every linter finds each module where it looks for it.
    pub fn files(&self) -> Vec<(String, String)> {
        let text = |name: &str, module: &str| {
            if name == self.top {
                format!("{}\n{module}", self.header)
            } else {
                format!(
                    "// {name}: part of {}; see there.\n// SPDX-License-Identifier: {LICENCE}\n\n{module}",
                    self.top
                )
            }
        };
        let files = self.modules.iter();
        files
            .map(|(name, module)| (format!("{name}.v"), text(name, module)))
            .collect()
    }
}

const LICENCE: &str = "MIT OR Apache-2.0";

/// Calls a function with the widths `W, W1, S, F, P` of a format of the catalogue as its const parameters,
/// and after them a type, if one is given in brackets. The function returns a
/// `Result` with an [`EmitError`], which is also the answer to any other depth word.
#[macro_export]
macro_rules! for_format {
    ($depth_word:expr, $function:ident $([$type:ty])? ( $($argument:expr),* )) => {
        match $depth_word {
            16 => $function::<16, 17, 18, 32, 28 $(, $type)?>($($argument),*),
            20 => $function::<20, 21, 22, 40, 32 $(, $type)?>($($argument),*),
            24 => $function::<24, 25, 26, 48, 36 $(, $type)?>($($argument),*),
            28 => $function::<28, 29, 30, 56, 40 $(, $type)?>($($argument),*),
            32 => $function::<32, 33, 34, 64, 44 $(, $type)?>($($argument),*),
            value => Err($crate::emit::EmitError::Format { value }),
        }
    };
}

/// Emits the Verilog of a unit.
///
/// # Errors
///
/// When a parameter is out of its legal range; the error names the value and the range.
pub fn emit(request: &EmitRequest) -> Result<Emitted, EmitError> {
    emitted(request, "")
}

/// Emits the Verilog of a unit with a prefix before the name of every module, so that several configurations fit in one design.
///
/// # Errors
///
/// As for [`emit`], and when a name with the prefix is no identifier.
pub fn emit_with_prefix(request: &EmitRequest, prefix: &str) -> Result<Emitted, EmitError> {
    names::check_prefix(prefix)?;
    emitted(request, prefix)
}

fn emitted(request: &EmitRequest, prefix: &str) -> Result<Emitted, EmitError> {
    request.check()?;
    let (ports, modules) = match units::design(request.unit.name(), &request.parameters()) {
        Some(design) => (circuit::ports(&design), circuit::modules(&design, prefix)),
        None => {
            let scope = with_block(request, Collect)?;
            let modules = merge::modules(&scope, prefix)?;
            (ports(&scope), module_texts(modules))
        }
    };
    let latency = request.latency();
    Ok(Emitted {
        top: format!("{prefix}{}", request.unit.name()),
        header: header(request, &ports, latency, prefix),
        modules,
        ports,
        latency,
    })
}

/// Emits the modules of any block written as those of this crate: names and texts, leaves first.
///
/// # Errors
///
/// When rust-hdl's checks fail, or the block uses a form that the emitter does not take; the error names it.
pub fn emit_block<B: Block>(block: B) -> Result<Vec<(String, String)>, EmitError> {
    Ok(module_texts(merge::modules(&collect(block)?, "")?))
}

fn module_texts(modules: Vec<(String, String)>) -> Vec<(String, String)> {
    let text = |(name, body): (String, String)| {
        let text = format!("module {name}{body}\nendmodule\n");
        (name, text)
    };
    modules.into_iter().map(text).collect()
}

/// Clocks of the pipeline that the video units of the catalogue stand around.
pub const LEAD: usize = 40;

/// What is done with the block of a unit, whatever its type.
pub(crate) trait Task {
    type Outcome;
    fn run<B: Clocked + Ports + Send + 'static>(self, block: B)
    -> Result<Self::Outcome, EmitError>;
}

struct Collect;

impl Task for Collect {
    type Outcome = Scope;

    fn run<B: Clocked + Ports + Send + 'static>(self, block: B) -> Result<Scope, EmitError> {
        collect(block)
    }
}

/// Builds the block of a request and runs a task on it.
pub(crate) fn with_block<T: Task>(request: &EmitRequest, task: T) -> Result<T::Outcome, EmitError> {
    request.check()?;
    for_format!(request.depth_word, with_block_of_format[T](request, task))
}

fn with_block_of_format<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
    T: Task,
>(
    request: &EmitRequest,
    task: T,
) -> Result<T::Outcome, EmitError> {
    let EmitRequest {
        planes,
        rows_per_stage,
        objects,
        ..
    } = *request;
    match request.unit {
        Unit::Pe1 => task.run(Pe1::<S>::default()),
        Unit::Pe2 => task.run(Pe2::<F>::default()),
        Unit::SquareRoot => task.run(SquareRoot::<F, W, W1, S>::new(rows_per_stage)),
        Unit::SquareRootNonRestoring => {
            task.run(SquareRootNonRestoring::<F, W, W1, S>::new(rows_per_stage))
        }
        Unit::SquareRootIterative => task.run(SquareRootIterative::<F, W, W1, S>::new()),
        Unit::SquareRootRows => task.run(SquareRootRows::<F, W, W1, S>::new(
            request.digits(),
            rows_per_stage,
        )),
        Unit::SquareRootLeading => task.run(SquareRootLeading::<F, W, W1, S>::new(
            request.digits(),
            rows_per_stage,
        )),
        Unit::SquareRootLinear => {
            task.run(SquareRootLinear::<F, W, W1>::new(request.corrections()))
        }
        Unit::SquareRootQuadratic => task.run(SquareRootQuadratic::<F, W, W1, P>::new(
            request.corrections(),
        )),
        Unit::QuadricPe => task.run(QuadricPe::<W, W1, S, F>::new(rows_per_stage)),
        Unit::PlaneDepth => task.run(PlaneDepth::<W, P>::new()),
        Unit::CutPlane => task.run(CutPlane::<W>::new()),
        Unit::DepthInterval => task.run(DepthInterval::<W, S>::new()),
        Unit::TwoVolumeMerge => task.run(TwoVolumeMerge::<W>::default()),
        Unit::NormalUnit => task.run(NormalUnit::<W>::new(planes)),
        Unit::QuadricProcessor => task.run(QuadricProcessor::<W, W1, S, F, P>::new(
            planes,
            rows_per_stage,
        )),
        Unit::ProgrammablePe => task.run(ProgrammablePe::<W, W1, F>::new()),
        Unit::MemoryPe2 => task.run(MemoryPe2::<F>::new()),
        Unit::PatchDecider => task.run(PatchDecider::<W, S>::new(planes)),
        Unit::PatchProcessor => task.run(PatchProcessor::<W, W1, S, F, P>::new(
            planes,
            rows_per_stage,
        )),
        Unit::FirstGenerationProcessor => task.run(
            FirstGenerationProcessor::<W, W1, S, F, P>::new(rows_per_stage),
        ),
        Unit::PolyhedronProcessor => task.run(PolyhedronProcessor::<W, P>::new(planes)),
        Unit::FacetProcessor => task.run(FacetProcessor::<W, S, P>::new(request.sides())),
        Unit::CurvedFacetProcessor => {
            task.run(CurvedFacetProcessor::<W, S, F>::new(request.sides()))
        }
        Unit::SphereProcessor => task.run(SphereProcessor::<W, S, F>::new()),
        Unit::CylinderProcessor => task.run(CylinderProcessor::<W, S, F, P>::new()),
        Unit::QuadricVolume => {
            task.run(QuadricVolume::<W, W1, S, F, P>::new(planes, rows_per_stage))
        }
        Unit::PolyhedralVolume => task.run(PolyhedralVolume::<W, S, P>::new(planes)),
        Unit::ShadingProcessor => task.run(ShadingProcessor::<W>::new(request.lights())),
        Unit::RasterControl => task.run(RasterControl::new()),
        Unit::VisibilityChain => task.run(VisibilityChain::<W>::new(objects)),
        Unit::CardDecider => task.run(CardDecider::<W>::new(objects, request.cards())),
        Unit::ShadowStage => task.run(ShadowStage::new(objects)),
        Unit::CsgDecider => task.run(CsgDecider::<W>::new(
            request.products(),
            request.intersected(),
            request.subtracted(),
        )),
        Unit::TransparencyStage => task.run(TransparencyStage::<W>::default()),
        Unit::TransparencyPipeline => task.run(TransparencyPipeline::<W>::new(request.layers())),
        Unit::VisibilityNode => task.run(<VisibilityNode<W>>::default()),
        Unit::Decider => task.run(<Decider<W>>::new(objects)),
        Unit::CoefficientStore => task.run(CoefficientStore::<S, F, P>::new(planes)),
        Unit::Beam => task.run(Beam::<W, W1, S, F, P>::new(objects, planes, rows_per_stage)),
        Unit::VideoTiming => task.run(VideoTiming::new(&VideoMode::ALL[request.mode()], LEAD)),
        Unit::PixelFifo => task.run(PixelFifo::<6, 7, 24, 25>::new(LEAD)),
        Unit::FrameStore => task.run(FrameStore::<12>::new()),
        Unit::PostFilter => task.run(PostFilter::<11>::new()),
        Unit::Overlay => task.run(Overlay::<10>::new()),
        Unit::Accumulator => task.run(Accumulator::<12>::new()),
    }
}

fn ports(scope: &Scope) -> Vec<Port> {
    let ports = scope.nets.iter().filter(|net| module::is_port(net));
    ports
        .map(|net| Port {
            name: names::signal(&net.name),
            direction: if net.kind == AtomKind::InputParameter {
                Direction::Input
            } else {
                Direction::Output
            },
            width: net.width,
            signed: net.signed,
        })
        .collect()
}

/// Columns of the statements of a header at most.
const COLUMNS: usize = 120;

fn header(request: &EmitRequest, ports: &[Port], latency: usize, prefix: &str) -> String {
    let unit = request.unit;
    let format = format!("format {}", request.depth_word);
    let options = request.options().into_iter();
    let options = options.map(|(option, value)| format!("{} {value}", option.replace('-', " ")));
    Heading {
        top: &format!("{prefix}{}", unit.name()),
        contract: unit.contract(),
        parameters: std::iter::once(format).chain(options).collect(),
        latency,
        error: &unit.error(request),
        source: unit.source(),
        ports,
        command: &request.command_with_prefix(prefix),
    }
    .text()
}

/// What the comment before the Verilog states.
struct Heading<'a> {
    top: &'a str,
    contract: &'a str,
    /// A line each.
    parameters: Vec<String>,
    latency: usize,
    error: &'a str,
    source: &'a str,
    ports: &'a [Port],
    command: &'a str,
}

impl Heading<'_> {
    fn text(&self) -> String {
        let mut text = format!("// {}: {}\n//\n", self.top, self.contract);
        let parameters = self.parameters.join("\n//             ");
        let _ = writeln!(text, "// parameters: {parameters}");
        let clocks = if self.latency == 1 { "clock" } else { "clocks" };
        let _ = writeln!(text, "// latency:    {} {clocks}", self.latency);
        let _ = writeln!(text, "// error:      {}", wrapped(self.error));
        let _ = writeln!(text, "// source:     {}", self.source);
        let _ = writeln!(text, "// ports:");
        for port in self.ports {
            let direction = if port.direction == Direction::Input {
                "in "
            } else {
                "out"
            };
            let reading = if port.signed {
                "two's complement"
            } else {
                "unsigned"
            };
            let _ = writeln!(
                text,
                "//   {direction} {:<14} {:>2} {reading}",
                port.name, port.width
            );
        }
        let _ = writeln!(text, "//\n// Made by: {}", self.command);
        let _ = writeln!(text, "// SPDX-License-Identifier: {LICENCE}");
        text
    }
}

/// A statement on as many lines as it needs, the later ones indented like the first.
fn wrapped(statement: &str) -> String {
    let mut text = String::new();
    let mut column = "//             ".len();
    for (place, word) in statement.split(' ').enumerate() {
        if place > 0 && column + 1 + word.len() > COLUMNS {
            text += "\n//             ";
            column = "//             ".len();
        } else if place > 0 {
            text.push(' ');
            column += 1;
        }
        text += word;
        column += word.len();
    }
    text
}
