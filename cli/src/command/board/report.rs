//! What is told of a board.

use crate::arguments;
use crate::failure::{Failure, Result};
use crate::output::{self, Written};
use imogene_board::{Board, Pins, Routed};
use imogene_files::Outputs;
use imogene_files::text::counted;
use imogene_plan::description::MachineDescription;
use imogene_studies::kit::page::with;
use serde::Serialize;
use serde_json::json;
use std::collections::BTreeMap;

/// A board and what it shows; the keys are stable.
#[derive(Serialize)]
pub(super) struct BoardReport<'a> {
    pub(super) board: &'a Board,
    pub(super) machine: &'a MachineDescription,
    /// Clock of the pixels in Hz: exactly as a fraction, and how far it is from that of the mode.
    pub(super) pixel_hertz: String,
    pub(super) pixel_deviation_percent: f64,
    /// Clock of the pairs of bits in MHz; that of the pixels where there are none.
    pub(super) fast_mhz: f64,
    /// Words of all images.
    pub(super) words: usize,
    /// Images, and how many frames of the screen show each of them.
    pub(super) images: usize,
    pub(super) frames_per_image: u64,
    /// What the pins show in simulation of the sources.
    pub(super) pins: Option<Shown>,
    /// What the sources take of a part that is not placed and routed here, used and available.
    pub(super) synthesised: Option<BTreeMap<String, (u64, u64)>>,
    /// Place and route.
    pub(super) routed: Option<Routed>,
    /// What the pins show in simulation of the Verilog that the bitstream was turned back into.
    pub(super) bitstream: Option<Shown>,
    /// What they show in simulation of the routed netlist.
    pub(super) netlist: Option<Shown>,
    pub(super) command: String,
}

/// Clocks that are simulated beside whole frames.
pub(super) const SLACK: u64 = 4_000;
/// What pins show.
#[derive(Serialize)]
pub(super) struct Shown {
    /// Clocks of the pixels that were simulated, and those between two frames.
    pub(super) clocks: u64,
    pub(super) clocks_per_frame: usize,
    /// Whole frames of the screen, pixels of all, and those that are not golden or not there.
    pub(super) frames: usize,
    pub(super) pixels: usize,
    pub(super) differing: usize,
    /// Words of each DVI channel, none of parallel pins; the greatest difference of ones and zeros since a word of
    /// control, the most transitions of a level.
    pub(super) words: Option<usize>,
    pub(super) disparity: Option<i32>,
    pub(super) transitions: Option<u32>,
}

impl Shown {
    pub(super) fn of(pins: &Pins, golden: &[impl AsRef<[u8]>], clocks: u64) -> Shown {
        let (shown, channels) = (&pins.shown, pins.channels);
        let frames = shown.pictures.iter().zip(golden);
        let missing = golden[frames.len()..].iter();
        let missing: usize = missing.map(|golden| golden.as_ref().len() / 3).sum();
        let differing = |(picture, golden): (&Vec<u8>, &_)| {
            let golden = AsRef::<[u8]>::as_ref(golden).chunks_exact(3);
            let pixels = picture.chunks_exact(3).zip(golden);
            pixels.filter(|(found, golden)| found != golden).count()
        };
        Shown {
            clocks,
            clocks_per_frame: shown.clocks,
            frames: frames.len(),
            pixels: frames.clone().map(|(picture, _)| picture.len() / 3).sum(),
            differing: missing + frames.map(differing).sum::<usize>(),
            words: channels.map(|channels| channels.words),
            disparity: channels.map(|channels| channels.disparity),
            transitions: channels.map(|channels| channels.transitions),
        }
    }
}

impl BoardReport<'_> {
    /// Fails where pins do not show the golden picture.
    pub(super) fn verdict(&self) -> Result {
        let shown = [&self.pins, &self.bitstream, &self.netlist].into_iter();
        let differing: usize = shown.flatten().map(|shown| shown.differing).sum();
        Failure::unless(differing == 0, || {
            let (pixels, command) = (counted(differing, "differing pixel"), &self.command);
            format!("{pixels} on the pins of the board; please report the command: {command}")
        })
    }
}

/// Writes a report as the last of the files, and tells of it by a template.
pub(super) fn finish(
    options: &arguments::Board,
    board: &Board,
    report: &impl Serialize,
    mut files: Outputs,
    json: bool,
    template: &str,
) -> Result {
    let path = options.out.join("board.json");
    let paths = [files.paths(), vec![path.clone()]].concat();
    let written = Written {
        report,
        files: paths,
    };
    files.add_text(&path, &output::json_text(&written))?;
    files.finish()?;
    let about = json!({ "name": board.name, "read_back": board.read_back() });
    let page = output::page(template, with(report, about))?;
    output::report(json, &written, |written| {
        output::text(page);
        output::wrote(&written.files);
    });
    Ok(())
}
