//! Frames by each of the models, and what lights them.

use crate::arguments::{Model, Render};
use crate::command::{run_beam, run_slots, threads, verdict};
use crate::failure::Result;
use crate::output;
use imogene_analysis::exact;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_prepare::PreparedScene;
use imogene_scene::{FramedScene, FramedSource};
use imogene_verif::engine::Engine;
use imogene_verif::scene::{self, slots};

/// The frame by the model that is asked for, and what lights it.
pub fn draw(
    options: &Render,
    framed: &FramedScene,
    prepared: &PreparedScene,
) -> Result<(Frame, Lighting)> {
    let frame = match options.model {
        Model::Exact => exact_frame(framed, prepared),
        Model::Golden => golden_frame(prepared),
        Model::Rtl => hardware_frame(options, prepared)?,
    };
    let lighting = match options.model {
        Model::Exact => exact_lighting(framed, &frame),
        // What is simulated are the object processors; the volumes are those of the golden model.
        Model::Golden | Model::Rtl => golden_lighting(&frame, prepared),
    };
    Ok((frame, lighting))
}

pub fn exact_frame(framed: &FramedScene, prepared: &PreparedScene) -> Frame {
    let pixels = output::during(u64::from(prepared.height), "exact reference", |bar| {
        exact::render::render(framed, &prepared.format, || bar.inc(1))
    });
    exact::render::to_frame(&pixels, framed, &prepared.format)
}

pub fn golden_frame(prepared: &PreparedScene) -> Frame {
    output::during(u64::from(prepared.height), "golden model", |bar| {
        prepared.frame(|| bar.inc(1))
    })
}

pub fn exact_lighting(framed: &FramedScene, frame: &Frame) -> Lighting {
    let casts = |s: &FramedSource| s.shadows || s.cone.is_some();
    if !framed.sources.iter().any(casts) {
        return Lighting::full(frame);
    }
    output::during(u64::from(framed.height), "exact shadows", |bar| {
        exact::shadow::lighting(framed, || bar.inc(1))
    })
}

/// What the golden volumes leave of the sources of a frame.
pub fn golden_lighting(frame: &Frame, prepared: &PreparedScene) -> Lighting {
    let lines = u64::from(prepared.height);
    output::during(lines, "shadow and light volumes", |bar| {
        prepared.light(frame, || bar.inc(1))
    })
}

fn hardware_frame(options: &Render, prepared: &PreparedScene) -> Result<Frame> {
    prepared.refuse_composed()?;
    let (mut report, frame) = match slots::is_for_beam(prepared) {
        true => {
            let run = scene::Options::plain(options.rows_per_stage, threads());
            run_beam(prepared, &run, Engine::BuiltIn)?
        }
        false => run_slots(prepared, options.rows_per_stage, Engine::BuiltIn)?,
    };
    report.subject = options.scene.scene.display().to_string();
    report.reproduce = reproduce(options);
    verdict(&report)?;
    Ok(frame)
}

/// The command that shows the difference again.
fn reproduce(options: &Render) -> String {
    let asked = &options.scene;
    let words = asked.words.options(asked.format);
    let (scene, view) = (asked.scene.display(), asked.view.options());
    match options.look.look(false) {
        None => format!("imogene cosim {scene}{words}{view}"),
        Some(_) => format!("imogene render {scene}{words}{view} --model rtl, with the same look"),
    }
}
