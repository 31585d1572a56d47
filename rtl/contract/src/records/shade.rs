//! What gives a pixel its colour.

use super::EVERY_CLOCK;
use crate::parameters::{LAYERS, LIGHTS};
use crate::unit::Record;

pub(crate) const TRANSPARENCY_STAGE: Record = Record {
    name: "transparency_stage",
    computes: "the colour of a transparent object blended over that of a pixel, if it is nearer",
    source: "Chaillou 1991, IV.3.3",
    parameters: &[],
    latency: "2",
    throughput: EVERY_CLOCK,
    ties: "at equal depth the opaque surface hides the layer; 255ths have no halves",
    error: "bound: half a step of a component",
};

pub(crate) const TRANSPARENCY_PIPELINE: Record = Record {
    name: "transparency_pipeline",
    computes: "the colours of transparent objects blended over that of a pixel, farthest first",
    source: "Chaillou 1991, IV.3.3",
    parameters: &[LAYERS],
    latency: "2 T",
    throughput: EVERY_CLOCK,
    ties: "at equal depth the opaque surface hides the layer; 255ths have no halves",
    error: "bound: half a step of a component for each of {T} layers",
};

pub(crate) const SHADING_PROCESSOR: Record = Record {
    name: "shading_processor",
    computes: "the colour of every pixel by Phong shading under several lights",
    source: "Chaillou 1991, III.1.2; Nyiri 1994, 1.2.4",
    parameters: &[LIGHTS],
    latency: "38",
    throughput: "one pixel per clock, without a bubble; words change only when the pipeline has drained",
    ties: "a normal at a right angle to the line of sight is not turned; a light in the plane of the surface adds nothing; half a level is rounded up",
    error: "within one level of 8 bits of the formula in real numbers on the same integer words (docs/shading.md)",
};
