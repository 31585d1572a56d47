//! The record of every unit, a file for each folder of circuits, and what several of them state.

pub mod arith;
pub mod machine;
pub mod object;
pub mod raster;
pub mod shade;
pub mod video;

const EVERY_CLOCK: &str = "one result per clock";
const PIXELS: &str = "one pixel per clock, no bubble between lines or zones";
const HELD_WORDS: &str = "one pixel per clock, no bubble between lines; coefficients change only when the pipeline has drained";

const NO_TIES: &str = "none: nothing is compared";
const SMALLER_ID: &str =
    "at equal depth the smaller id wins, so the result does not depend on the order of the inputs";

const EXACT: &str = "exact";
const MODULO: &str = "exact modulo the width of the value; whoever makes the coefficients proves that the true value fits";
const WORDS: &str = "exact in its integer words; imogene check SCENE bounds what the rounding of a scene to those words costs";
const INTEGERS: &str =
    "exact in its integer words; against real numbers: the rounding of the words, each once";
