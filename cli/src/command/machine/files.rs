//! The files of a run.

use crate::failure::{Failure, Result};
use crate::output;
use imogene_files::Outputs;
use imogene_golden::machine::overlay::OverlayPlane;
use imogene_plan::description::MachineDescription;
use imogene_plan::display::Image;
use imogene_plan::zone::clocks::ZoneTiming;
use imogene_plan::zone::growth::{Growth, OBJECT_PROCESSORS, ZONE_SIDES, growth};
use imogene_prepare::PreparedScene;
use imogene_scene::FramedScene;
use imogene_studies::growth_plot::plot;
use imogene_verif::display::bench::{Bench, BenchFrame};
use imogene_verif::display::pins::PinsOutcome;
use std::path::Path;

/// A scene, ready for the machine.
pub(super) struct Scene {
    /// Path and options of the view.
    pub(super) name: String,
    pub(super) framed: FramedScene,
    pub(super) prepared: PreparedScene,
}

impl Scene {
    pub(super) fn parts(&self) -> (&FramedScene, &PreparedScene) {
        (&self.framed, &self.prepared)
    }
}

/// Adds what a bench of the user's own drives the machine with.
pub(super) fn add_bench(
    machine: &MachineDescription,
    top: &str,
    scenes: &[Scene],
    images: &[Image],
    overlay: Option<&OverlayPlane>,
    (out, files): (&Path, &mut Outputs),
) -> Result {
    let fields = machine.fields().len();
    let scenes = scenes.iter().flat_map(|scene| vec![scene; fields]);
    let frames = scenes.zip(images).map(|(scene, image)| BenchFrame {
        scene: &scene.name,
        image,
    });
    let frames: Vec<BenchFrame> = frames.collect();
    let bench = Bench {
        machine,
        top,
        frames: &frames,
        overlay,
    };
    for (name, text) in bench.files() {
        files.add_text(&out.join(name), &text)?;
    }
    Ok(())
}

pub(super) fn grow(
    scene: &PreparedScene,
    machine: &MachineDescription,
    timing: Option<ZoneTiming>,
    out: &Path,
    files: &mut Outputs,
) -> Result<Vec<Growth>> {
    let timing = timing.ok_or_else(|| {
        Failure::Input("--growth counts the passes of a zone machine; a beam machine has one clock for each pixel whatever the scene".into())
    })?;
    let shape = machine.zone_machine();
    let rows = growth(scene, &shape, &timing, &ZONE_SIDES, &OBJECT_PROCESSORS)?;
    let title = format!(
        "clocks of a frame of {} x {} pixels",
        scene.width / machine.supersampling,
        scene.height / machine.supersampling
    );
    let text = plot(&title, &rows)?;
    files.add_text(&out.join("growth.svg"), &text)?;
    Ok(rows)
}

pub fn write_pictures(
    machine: &MachineDescription,
    (golden, outcome): (Option<&[u8]>, Option<&PinsOutcome>),
    out: &Path,
    files: &mut Outputs,
) -> Result {
    let Some((mode, golden)) = machine.video_mode().zip(golden) else {
        return Ok(());
    };
    let size = [mode.line, mode.frame].map(|span| span.active as usize);
    output::add_picture(files, &out.join("golden.png"), size, golden)?;
    if let Some(shown) = outcome.filter(|outcome| outcome.picture.len() == golden.len()) {
        output::add_picture(files, &out.join("pins.png"), size, &shown.picture)?;
    }
    Ok(())
}
