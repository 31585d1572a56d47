//! Verilog of a unit.
//!
//! A block is connected and checked by rust-hdl, collected through a probe, lowered to typed expressions, and written as plain
//! Verilog-2005: each distinct module once, registers as `reg`s, no identifier that another language reserves. rust-hdl's own
//! text is not used: it drops widths and precedence. The same request gives the same text, byte for byte.

mod collect;
mod lower;
mod merge;
mod module;
mod names;
#[cfg(test)]
mod tests;

use crate::catalogue::{LINEAR_CORRECTIONS, QUADRATIC_CORRECTIONS, Shape, Unit, kept_digits};
use crate::format::{DEPTH_WORDS, MOST_OBJECTS, MOST_PLANES};
use crate::kernel::Ports;
use crate::machine::beam::Beam;
use crate::machine::coefficient_store::CoefficientStore;
use crate::machine::decider::Decider;
use crate::machine::raster_control::RasterControl;
use crate::machine::visibility_node::VisibilityNode;
use crate::object::quadric_processor::QuadricProcessor;
use crate::step::Clocked;
use crate::unit::cut_plane::CutPlane;
use crate::unit::depth_interval::DepthInterval;
use crate::unit::normal_unit::NormalUnit;
use crate::unit::pe1::Pe1;
use crate::unit::pe2::Pe2;
use crate::unit::plane_depth::PlaneDepth;
use crate::unit::quadric_pe::QuadricPe;
use crate::unit::square_root::SquareRoot;
use crate::unit::square_root_iterative::SquareRootIterative;
use crate::unit::square_root_leading::SquareRootLeading;
use crate::unit::square_root_linear::SquareRootLinear;
use crate::unit::square_root_non_restoring::SquareRootNonRestoring;
use crate::unit::square_root_quadratic::SquareRootQuadratic;
use crate::unit::square_root_rows::SquareRootRows;
use crate::unit::two_volume_merge::TwoVolumeMerge;
use collect::{Scope, collect};
use rust_hdl::core::prelude::AtomKind;
use std::fmt::{self, Write};

/// What to emit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EmitRequest {
    /// The unit.
    pub unit: Unit,
    /// Depth word `W` of the format.
    pub depth_word: usize,
    /// Cut planes of an object, 0 to 12.
    pub planes: usize,
    /// Rows of the root network between registers, 1 to `W`.
    pub rows_per_stage: usize,
    /// Object slots, 1 to 256.
    pub objects: usize,
}

impl EmitRequest {
    /// A unit at the base format 24, with 3 planes, 1 row per stage and 4 objects.
    pub fn new(unit: Unit) -> Self {
        Self {
            unit,
            depth_word: 24,
            planes: 3,
            rows_per_stage: 1,
            objects: 4,
        }
    }

    fn shape(&self) -> Shape {
        Shape {
            depth_word: self.depth_word,
            planes: self.planes,
            rows_per_stage: self.rows_per_stage,
            objects: self.objects,
        }
    }

    /// Checks every parameter against its legal range.
    pub fn check(&self) -> Result<(), EmitError> {
        check_format(self.depth_word)?;
        check_range("planes", self.planes, 0, MOST_PLANES)?;
        check_range("rows per stage", self.rows_per_stage, 1, self.depth_word)?;
        check_range("objects", self.objects, 1, MOST_OBJECTS)
    }

    /// The command line that makes the same text.
    pub fn command(&self) -> String {
        let mut command = format!(
            "imogene emit {} --format {}",
            self.unit.name(),
            self.depth_word
        );
        for (option, value) in self.unit.options(&self.shape()) {
            let _ = write!(command, " --{option} {value}");
        }
        command + " --out DIR"
    }
}

/// Refuses a format outside the catalogue.
fn check_format(depth_word: usize) -> Result<(), EmitError> {
    if DEPTH_WORDS.contains(&depth_word) {
        Ok(())
    } else {
        Err(EmitError::Format { value: depth_word })
    }
}

fn check_range(
    parameter: &'static str,
    value: usize,
    least: usize,
    most: usize,
) -> Result<(), EmitError> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        Err(EmitError::Range {
            parameter,
            value,
            least,
            most,
        })
    }
}

/// Direction of a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Into the unit.
    Input,
    /// Out of the unit.
    Output,
}

/// A port of the emitted module.
#[derive(Clone, Debug, PartialEq, Eq)]
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
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Emitted {
    /// Name of the top module.
    pub top: String,
    /// Names and texts of the files.
    pub files: Vec<(String, String)>,
    /// Ports of the top module, in its order.
    pub ports: Vec<Port>,
    /// Clocks from the first input of a computation to its result.
    pub latency: usize,
    /// Modules in the files.
    pub modules: usize,
}

/// Why a unit cannot be emitted or simulated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EmitError {
    /// The format is not in the catalogue.
    Format {
        /// The depth word asked for.
        value: usize,
    },
    /// A parameter is out of its legal range.
    Range {
        /// The parameter.
        parameter: &'static str,
        /// The value asked for.
        value: usize,
        /// Least legal value.
        least: usize,
        /// Greatest legal value.
        most: usize,
    },
    /// No unit has this name.
    Unit {
        /// The name asked for.
        name: String,
    },
    /// A block is not written as the emitter needs it; a defect of this crate.
    Block {
        /// The block, name or expression.
        place: String,
        /// What is wrong with it.
        problem: String,
    },
}

impl EmitError {
    fn block(place: &str, problem: &str) -> Self {
        Self::Block {
            place: place.to_owned(),
            problem: problem.to_owned(),
        }
    }

    fn nested(operator: &str) -> Self {
        Self::block(
            operator,
            "has operands of different types, or other than names and constants",
        )
    }
}

impl fmt::Display for EmitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Format { value } => {
                let legal: Vec<_> = DEPTH_WORDS.iter().map(usize::to_string).collect();
                write!(
                    f,
                    "format {value} is not in the catalogue; legal formats are {}",
                    legal.join(", ")
                )
            }
            Self::Range {
                parameter,
                value,
                least,
                most,
            } => {
                write!(
                    f,
                    "{parameter} = {value} is out of range; legal values are {least} to {most}"
                )
            }
            Self::Unit { name } => {
                let legal: Vec<_> = Unit::ALL.iter().map(|unit| unit.name()).collect();
                write!(
                    f,
                    "there is no unit `{name}`; the units are {}",
                    legal.join(", ")
                )
            }
            Self::Block { place, problem } => write!(f, "`{place}` {problem}"),
        }
    }
}

impl std::error::Error for EmitError {}

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
    let scope = with_block(request, Collect)?;
    let modules = merge::modules(&scope)?;
    let top = request.unit.name().to_owned();
    let ports = ports(&scope);
    let latency = request.unit.latency(&request.shape());
    let mut text = header(request, &ports, latency);
    for (name, body) in &modules {
        let _ = write!(text, "\nmodule {name}{body}\nendmodule\n");
    }
    Ok(Emitted {
        files: vec![(format!("{top}.v"), text)],
        top,
        ports,
        latency,
        modules: modules.len(),
    })
}

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
            kept_digits(W),
            rows_per_stage,
        )),
        Unit::SquareRootLeading => task.run(SquareRootLeading::<F, W, W1, S>::new(
            kept_digits(W),
            rows_per_stage,
        )),
        Unit::SquareRootLinear => task.run(SquareRootLinear::<F, W, W1>::new(LINEAR_CORRECTIONS)),
        Unit::SquareRootQuadratic => task.run(SquareRootQuadratic::<F, W, W1, P>::new(
            QUADRATIC_CORRECTIONS,
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
        Unit::RasterControl => task.run(RasterControl::new()),
        Unit::VisibilityNode => task.run(VisibilityNode::<W>::default()),
        Unit::Decider => task.run(Decider::<W>::new(objects)),
        Unit::CoefficientStore => task.run(CoefficientStore::<S, F, P>::new(planes)),
        Unit::Beam => task.run(Beam::<W, W1, S, F, P>::new(objects, planes, rows_per_stage)),
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

fn header(request: &EmitRequest, ports: &[Port], latency: usize) -> String {
    let mut text = String::new();
    let unit = request.unit;
    let _ = writeln!(text, "// {}: {}", unit.name(), unit.contract());
    let _ = writeln!(text, "//");
    let _ = writeln!(text, "// parameters: format {}", request.depth_word);
    for (option, value) in unit.options(&request.shape()) {
        let _ = writeln!(text, "//             {} {value}", option.replace('-', " "));
    }
    let _ = writeln!(
        text,
        "// latency:    {latency} {}",
        if latency == 1 { "clock" } else { "clocks" }
    );
    let _ = writeln!(text, "// source:     {}", unit.source());
    let _ = writeln!(text, "// ports:");
    for port in ports {
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
    let _ = writeln!(text, "//");
    let _ = writeln!(text, "// Made by: {}", request.command());
    let _ = writeln!(text, "// SPDX-License-Identifier: MIT OR Apache-2.0");
    text
}
