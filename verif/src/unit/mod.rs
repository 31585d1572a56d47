//! Every unit as a [`Subject`](crate::subject::Subject): ports, hardware, golden model, stimulus; one file per group of units.

mod decision;
mod depth;
mod elementary;
mod normal;
mod processor;
mod raster;
mod root;

use crate::subject::{Inputs, Subject};
use imogene_models::format::{Format, FormatError};
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
}

impl Default for Parameters {
    fn default() -> Self {
        Parameters {
            depth_word: 24,
            planes: 3,
            rows_per_stage: 1,
            objects: 4,
        }
    }
}

/// Why a unit cannot be co-simulated.
#[derive(Debug, Error, PartialEq)]
pub enum UnitError {
    /// Not a unit's name.
    #[error("'{0}' is not a unit; accepted: {names}", names = NAMES.join(", "))]
    Unknown(String),
    /// Not a format.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// A count out of its range.
    #[error("{name} is {value}; accepted: {low} to {high}")]
    Range {
        /// Option.
        name: &'static str,
        /// Given value.
        value: usize,
        /// Least accepted.
        low: usize,
        /// Greatest accepted.
        high: usize,
    },
}

/// Units that can be co-simulated on their own.
pub const NAMES: [&str; 13] = [
    "pe1",
    "pe2",
    "square_root",
    "quadric_pe",
    "depth_interval",
    "plane_depth",
    "cut_plane",
    "two_volume_merge",
    "normal_unit",
    "quadric_processor",
    "raster_control",
    "visibility_node",
    "decider",
];

/// A unit by its name.
pub fn subject(name: &str, parameters: Parameters) -> Result<Subject, UnitError> {
    if !NAMES.contains(&name) {
        return Err(UnitError::Unknown(name.to_string()));
    }
    let format = Format::new(parameters.depth_word)?;
    check_range("planes", parameters.planes, 0, 12)?;
    check_range("rows-per-stage", parameters.rows_per_stage, 1, format.root as usize)?;
    check_range("objects", parameters.objects, 1, 256)?;
    Ok(match parameters.depth_word {
        16 => by_width::<16, 17, 18, 32, 28>(name, parameters),
        20 => by_width::<20, 21, 22, 40, 32>(name, parameters),
        24 => by_width::<24, 25, 26, 48, 36>(name, parameters),
        28 => by_width::<28, 29, 30, 56, 40>(name, parameters),
        _ => by_width::<32, 33, 34, 64, 44>(name, parameters),
    })
}

fn check_range(name: &'static str, value: usize, low: usize, high: usize) -> Result<(), UnitError> {
    if (low..=high).contains(&value) {
        Ok(())
    } else {
        Err(UnitError::Range {
            name,
            value,
            low,
            high,
        })
    }
}

fn by_width<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>(
    name: &str,
    p: Parameters,
) -> Subject {
    let format = Format::new(W as u32).expect("a catalogue format");
    let mut subject = match name {
        "pe1" => elementary::pe1::<S>(),
        "pe2" => elementary::pe2::<F>(),
        "square_root" => root::square_root::<F, W, W1, S>(p.rows_per_stage),
        "quadric_pe" => root::quadric_pe::<W, W1, S, F>(format, p.rows_per_stage),
        "depth_interval" => depth::depth_interval::<W, S>(format),
        "plane_depth" => depth::plane_depth::<W, P>(format),
        "cut_plane" => depth::cut_plane::<W>(format),
        "two_volume_merge" => depth::two_volume_merge::<W>(),
        "normal_unit" => normal::normal_unit::<W>(p.planes),
        "quadric_processor" => processor::quadric_processor::<W, W1, S, F, P>(format, p.planes, p.rows_per_stage),
        "raster_control" => raster::raster_control(),
        "visibility_node" => decision::visibility_node::<W>(),
        _ => decision::decider::<W>(p.objects),
    };
    subject.options = format!(
        "--format {} --planes {} --rows-per-stage {} --objects {}",
        p.depth_word, p.planes, p.rows_per_stage, p.objects
    );
    subject
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
