//! What stands between the pixels and the screen.

use super::{EXACT, NO_TIES};
use crate::parameters::MODE;
use crate::unit::Record;

pub(crate) const VIDEO_TIMING: Record = Record {
    name: "video_timing",
    computes: "the raster of a screen with its blanking, and the same some clocks ahead",
    source: "Chaillou 1991, I.2.4.2 and IV.4.4",
    parameters: &[MODE],
    latency: "1",
    throughput: "one position of the raster per clock with enable",
    ties: NO_TIES,
    error: EXACT,
};

pub(crate) const PIXEL_FIFO: Record = Record {
    name: "pixel_fifo",
    computes: "a queue from a pipeline that cannot stall to an AXI4-Stream receiver that can",
    source: "architecture, 8",
    parameters: &[],
    latency: "2",
    throughput: "one pixel per clock as long as the receiver does not stall, behind a pipeline of at most 60 clocks",
    ties: NO_TIES,
    error: EXACT,
};

pub(crate) const FRAME_STORE: Record = Record {
    name: "frame_store",
    computes: "the last whole frame that came, while the next one comes",
    source: "architecture, 8",
    parameters: &[],
    latency: "3",
    throughput: "one pixel per clock out, and one in while a frame is not whole",
    ties: "a retrace in the clock of the last pixel of a frame comes too early for it",
    error: EXACT,
};

pub(crate) const POST_FILTER: Record = Record {
    name: "post_filter",
    computes: "a picture smoothed by a 2 x 2 box or a 3 x 3 binomial",
    source: "Chaillou 1991, IV.4.3",
    parameters: &[],
    latency: "3",
    throughput: "one pixel per clock; a clock without a pixel after each line, width + 2 after a picture",
    ties: "halves are rounded up; beyond an edge the nearest pixel stands",
    error: EXACT,
};

pub(crate) const OVERLAY: Record = Record {
    name: "overlay",
    computes: "a plane of one bit per pixel over a picture",
    source: "Chaillou 1991, IV.4.7.1",
    parameters: &[],
    latency: "4",
    throughput: "one pixel per clock",
    ties: "a word read in the clock that writes it is the old one",
    error: EXACT,
};

pub(crate) const ACCUMULATOR: Record = Record {
    name: "accumulator",
    computes: "the mean of 4 or 16 passes over a picture",
    source: "Chaillou 1991, III.1.5 and IV.4.7.2",
    parameters: &[],
    latency: "3",
    throughput: "one pixel per clock",
    ties: "halves are rounded up",
    error: EXACT,
};
