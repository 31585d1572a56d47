//! What is told of a run.

use crate::command::{describe, negation};
use crate::output;
use imogene_files::text::counted;
use imogene_plan::description::MachineDescription;
use imogene_plan::zone::clocks::FrameClocks;
use imogene_plan::zone::growth::Growth;
use imogene_verif::report::Report;
use serde::Serialize;
use std::path::PathBuf;

/// What a machine was and did; the keys are stable.
#[derive(Serialize)]
pub(super) struct MachineReport<'a> {
    pub(super) machine: &'a MachineDescription,
    pub(super) top: String,
    pub(super) scenes: Vec<String>,
    /// Clocks of a frame on the pins, none of a stream; and pixels of it, one per clock within a line.
    pub(super) clocks_per_frame: Option<u64>,
    pub(super) pixels_per_frame: u64,
    /// Words of each frame.
    pub(super) words: Vec<usize>,
    /// Clocks of each scene's frame in a zone machine, by the formula.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) zone_clocks: Vec<FrameClocks>,
    /// Clocks from the first word of each scene until the machine took the last one, and until it came on the screen.
    pub(super) taking: Vec<u64>,
    pub(super) loading: Vec<u64>,
    /// Which scene each frame showed.
    pub(super) shown: Vec<Option<usize>>,
    /// The picture of the pins is the golden picture, byte for byte.
    pub(super) equal: Option<bool>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) growth: Vec<Growth>,
    pub(super) report: Option<Report>,
    pub(super) files: Vec<PathBuf>,
}

pub(super) fn tell(summary: &MachineReport) {
    let pace = match summary.clocks_per_frame {
        Some(clocks) => format!("in {clocks} clocks of a frame on the pins"),
        None => "of a frame over AXI4-Stream".to_owned(),
    };
    let pixels = counted(summary.pixels_per_frame, "pixel");
    output::text(format!("{}: {pixels} {pace}", summary.top));
    for (place, clocks) in summary.zone_clocks.iter().enumerate() {
        output::text(format!(
            "  {}: {} in {} ({} drawing, {} lighting passes), {}",
            summary.scenes[place],
            counted(clocks.total, "clock"),
            counted(clocks.zones, "zone"),
            clocks.draw_passes,
            clocks.light_passes,
            counted(clocks.beats, "beat")
        ));
    }
    if let Some(report) = &summary.report {
        output::text(describe(report));
        let shown = summary.shown.iter().flatten().count();
        let frames = counted(summary.shown.len(), "frame");
        let not = negation(summary.equal == Some(true));
        output::text(format!(
            "  {frames}, {shown} of a scene; the last one is {not}the golden picture"
        ));
    }
    let files = summary.files.iter();
    files.for_each(|file| output::text(format!("  wrote {}", file.display())));
}
