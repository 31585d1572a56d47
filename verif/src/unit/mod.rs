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

use crate::engine::circuit::Circuit;
use crate::signal::Signal;
use crate::subject::{Golden, Hardware, Inputs, Stimulus, Subject};
use imogene_hdl::Direction;
use imogene_models::format::{Format, FormatError};
use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::{EmitError, EmitRequest, design};
use thiserror::Error;

/// Parameters of a unit under co-simulation.
#[derive(Clone, Copy, Debug)]
pub struct Parameters {
    /// Depth word.
    pub depth_word: u32,
    /// Cut planes of a processor.
    pub planes: usize,
    /// Rows of the root network per register stage.
    pub rows_per_stage: usize,
    /// Inputs of the decider.
    pub objects: usize,
    /// Digits that a shortened square root keeps; the unit's own choice if not given.
    pub digits: Option<usize>,
    /// Corrections of an approximate square root; the unit's own choice if not given.
    pub corrections: Option<usize>,
    /// Sides of a facet; 3 if not given.
    pub sides: Option<usize>,
    /// Number of a video mode; 0 if not given.
    pub mode: Option<usize>,
    /// Cards of a decider; 2 if not given.
    pub cards: Option<usize>,
    /// Layers of a transparency pipeline; 2 if not given.
    pub layers: Option<usize>,
    /// Products of a solid; 2 if not given.
    pub products: Option<usize>,
    /// Objects intersected in a product; 2 if not given.
    pub intersected: Option<usize>,
    /// Objects taken away in a product; 2 if not given.
    pub subtracted: Option<usize>,
    /// Lights of the shading processor; 1 if not given.
    pub lights: Option<usize>,
}

impl Parameters {
    /// The unit of these parameters, to be emitted.
    pub fn request(&self, unit: Unit) -> EmitRequest {
        EmitRequest {
            unit,
            depth_word: self.depth_word as usize,
            planes: self.planes,
            rows_per_stage: self.rows_per_stage,
            objects: self.objects,
            digits: self.digits,
            corrections: self.corrections,
            sides: self.sides,
            mode: self.mode,
            cards: self.cards,
            layers: self.layers,
            products: self.products,
            intersected: self.intersected,
            subtracted: self.subtracted,
            lights: self.lights,
        }
    }
}

impl Default for Parameters {
    fn default() -> Self {
        Parameters {
            depth_word: 24,
            planes: 3,
            rows_per_stage: 1,
            objects: 4,
            digits: None,
            corrections: None,
            sides: None,
            mode: None,
            cards: None,
            layers: None,
            products: None,
            intersected: None,
            subtracted: None,
            lights: None,
        }
    }
}

/// Why a unit cannot be co-simulated.
#[derive(Debug, Error, PartialEq)]
pub enum UnitError {
    /// Not a unit's name.
    #[error("'{0}' is not a unit; accepted: {names}", names = list())]
    Unknown(String),
    /// Not a format.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// A parameter out of its range, or one that the unit does not have.
    #[error("{0}")]
    Parameter(EmitError),
}

/// Units that the tests of all units run over.
pub const NAMES: [&str; 44] = [
    "pe1",
    "pe2",
    "programmable_pe",
    "memory_pe2",
    "square_root",
    "square_root_non_restoring",
    "square_root_iterative",
    "square_root_rows",
    "square_root_leading",
    "square_root_linear",
    "square_root_quadratic",
    "quadric_pe",
    "depth_interval",
    "plane_depth",
    "cut_plane",
    "two_volume_merge",
    "normal_unit",
    "patch_decider",
    "quadric_processor",
    "patch_processor",
    "first_generation_processor",
    "polyhedron_processor",
    "facet_processor",
    "curved_facet_processor",
    "sphere_processor",
    "cylinder_processor",
    "quadric_volume",
    "polyhedral_volume",
    "raster_control",
    "visibility_node",
    "decider",
    "video_timing",
    "pixel_fifo",
    "frame_store",
    "post_filter",
    "overlay",
    "accumulator",
    "visibility_chain",
    "card_decider",
    "shadow_stage",
    "transparency_stage",
    "transparency_pipeline",
    "csg_decider",
    "shading_processor",
];

/// Units that are loaded over a bus; their stimulus needs many clocks to load a scene.
pub const MACHINE_NAMES: [&str; 2] = ["coefficient_store", "beam"];

/// Whether a unit has this name.
pub fn is_unit(name: &str) -> bool {
    NAMES.iter().chain(&MACHINE_NAMES).any(|unit| *unit == name)
}

/// The names of all units as a text.
pub fn list() -> String {
    [&NAMES[..], &MACHINE_NAMES].concat().join(", ")
}

/// A unit by its name, one of [`NAMES`] or [`MACHINE_NAMES`].
pub fn subject(name: &str, parameters: Parameters) -> Result<Subject, UnitError> {
    if !is_unit(name) {
        return Err(UnitError::Unknown(name.to_string()));
    }
    let format = Format::new(parameters.depth_word)?;
    let unit = Unit::from_name(name).expect("the names are those of the catalogue");
    let request = parameters.request(unit);
    request.check().map_err(UnitError::Parameter)?;
    let unit = describe(&request, format);
    let (inputs, outputs) = (unit.inputs.clone(), unit.outputs.clone());
    Ok(Subject {
        name: unit.name,
        engine: "rust-hdl",
        inputs: unit.inputs,
        outputs: unit.outputs,
        hardware: Box::new(move || Box::new(UnitHardware::new(&request, &inputs, &outputs))),
        golden: unit.golden,
        stimulus: unit.stimulus,
        latency: request.latency(),
        options: options(&request),
    })
}

/// The options that the unit has, as on the command line.
fn options(request: &EmitRequest) -> String {
    let mut text = format!("--format {}", request.depth_word);
    for (option, value) in request.options() {
        text += &format!(" --{option} {value}");
    }
    text
}

/// What a file of this module states of a unit; its hardware is the emitted unit of the same name.
struct Description {
    name: String,
    inputs: Vec<Signal>,
    outputs: Vec<Signal>,
    golden: Box<dyn Fn() -> Box<dyn Golden> + Sync>,
    stimulus: Stimulus,
}

fn describe(p: &EmitRequest, format: Format) -> Description {
    match p.unit.name() {
        "pe1" => elementary::pe1(format.sum),
        "pe2" => elementary::pe2(format.quadratic),
        "square_root" => root::square_root(format, p.rows_per_stage),
        "square_root_non_restoring" => root_family::non_restoring(format, p.rows_per_stage),
        "square_root_iterative" => root_family::iterative(format),
        "square_root_rows" => root_family::rows(format, p.digits() as u32, p.rows_per_stage),
        "square_root_leading" => root_family::leading(format, p.digits() as u32, p.rows_per_stage),
        "square_root_linear" => root_family::linear(format, p.corrections() as u32),
        "square_root_quadratic" => root_family::quadratic(format, p.corrections() as u32),
        "quadric_pe" => root::quadric_pe(format, p.rows_per_stage),
        "depth_interval" => depth::depth_interval(format),
        "plane_depth" => depth::plane_depth(format),
        "cut_plane" => depth::cut_plane(format),
        "two_volume_merge" => depth::two_volume_merge(format),
        "normal_unit" => normal::normal_unit(format, p.planes),
        "quadric_processor" => processor::quadric_processor(format, p.planes, p.rows_per_stage),
        "programmable_pe" => programmable::programmable_pe(format),
        "memory_pe2" => memory::memory_pe2(format),
        "patch_decider" => patch::patch_decider(format, p.planes),
        "patch_processor" => patch::patch_processor(format, p.planes, p.rows_per_stage),
        "first_generation_processor" => {
            first_generation::first_generation_processor(format, p.rows_per_stage)
        }
        "polyhedron_processor" => polyhedron::polyhedron_processor(format, p.planes),
        "facet_processor" => facet::facet_processor(format, p.sides()),
        "curved_facet_processor" => facet::curved_facet_processor(format, p.sides()),
        "sphere_processor" => round::sphere_processor(format),
        "cylinder_processor" => round::cylinder_processor(format),
        "quadric_volume" => volume::quadric_volume(format, p.planes, p.rows_per_stage),
        "polyhedral_volume" => volume::polyhedral_volume(format, p.planes),
        "raster_control" => raster::raster_control(),
        "coefficient_store" => machine::coefficient_store(format, p.planes),
        "beam" => machine::beam(format, p.objects, p.planes, p.rows_per_stage),
        "video_timing" => video::video_timing(p.mode()),
        "pixel_fifo" => video_stream::pixel_fifo(),
        "frame_store" => video_stream::frame_store(),
        "post_filter" => video_filter::post_filter(),
        "overlay" => video_filter::overlay(),
        "accumulator" => video_filter::accumulator(),
        "shading_processor" => shading::shading_processor(format, p.lights()),
        "visibility_node" => decision::visibility_node(format),
        "visibility_chain" => decision::visibility_chain(format, p.objects),
        "card_decider" => decision::card_decider(format, p.objects, p.cards()),
        "shadow_stage" => lighting::shadow_stage(p.objects),
        "transparency_stage" => transparency::transparency_stage(format),
        "transparency_pipeline" => transparency::transparency_pipeline(format, p.layers()),
        "csg_decider" => solid::csg_decider(format, p.products(), p.intersected(), p.subtracted()),
        _ => decision::decider(format, p.objects),
    }
}

/// The unit in its own simulator, its ports matched by name.
struct UnitHardware {
    circuit: Circuit,
    /// For each port of a direction the signal that it is.
    inputs: Vec<usize>,
    outputs: Vec<usize>,
}

impl UnitHardware {
    fn new(request: &EmitRequest, inputs: &[Signal], outputs: &[Signal]) -> UnitHardware {
        let design = design(request).expect("a checked request");
        let place = |signals: &[Signal], direction: Direction| -> Vec<usize> {
            let ports = design.top.ports_of(direction);
            ports
                .map(|port| {
                    let name = &port.name;
                    let index = signals.iter().position(|signal| signal.name == *name);
                    let index = index.unwrap_or_else(|| panic!("no signal for port '{name}'"));
                    let Signal { width, signed, .. } = signals[index];
                    assert_eq!((width, signed), (port.width, port.signed), "{name}");
                    index
                })
                .collect()
        };
        UnitHardware {
            circuit: Circuit::new(&design),
            inputs: place(inputs, Direction::In),
            outputs: place(outputs, Direction::Out),
        }
    }
}

impl Hardware for UnitHardware {
    fn clock(&mut self, inputs: &[i64]) -> Vec<Option<i64>> {
        let words: Vec<i64> = self.inputs.iter().map(|index| inputs[*index]).collect();
        self.circuit.clock(&words);
        let mut values = vec![None; self.outputs.len()];
        for (port, index) in self.outputs.iter().enumerate() {
            values[*index] = Some(self.circuit.output(port));
        }
        values
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
