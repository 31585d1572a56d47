//! `imogene demo`.

use super::emit::{add_verilog, emitted};
use super::render::{golden_frame, golden_lighting};
use super::{beam, describe, frame_scene, threads, verdict};
use crate::arguments::{Demo, Size};
use crate::failure::Failure;
use crate::output;
use imogene_analysis::phong;
use imogene_contract::{Request, Unit};
use imogene_scene::SceneFile;
use imogene_studies::picture;
use imogene_verif::engine::Engine;
use imogene_verif::report::Report;
use imogene_verif::scene::{self, WaveformRequest};
use serde::Serialize;

/// The teapot, compiled in so that the demo needs no file.
const TEAPOT: &str = include_str!("../../../scenes/teapot.toml");
/// A few seconds of a simulator that visits every register.
const SIZE: Size = Size {
    width: 320,
    height: 240,
};
/// Clocks of waveforms kept.
const TRACE_CLOCKS: u64 = 1_600;
/// Object whose processor is traced: the body of the pot.
const TRACED: usize = 0;

/// The report with what the demo adds.
#[derive(Serialize)]
struct Summary {
    #[serde(flatten)]
    report: Report,
    width: u32,
    height: u32,
    objects: usize,
    planes: usize,
    latency: usize,
    pictures_identical: bool,
}

/// Runs the demo.
pub fn run(options: &Demo, json: bool) -> Result<(), Failure> {
    let file = SceneFile::parse(TEAPOT, "teapot.toml")?;
    let (framed, prepared) = frame_scene(&file, Some(SIZE), 24)?;
    let run_options = scene::Options {
        trace: Some(WaveformRequest {
            object: TRACED,
            clocks: TRACE_CLOCKS,
        }),
        ..scene::Options::plain(1, threads())
    };
    let shape = scene::shape_of(&prepared, run_options.rows_per_stage)?;
    let request = Request {
        objects: shape.objects as u32,
        planes: shape.planes as u32,
        rows_per_stage: shape.rows_per_stage as u32,
        ..Request::of(Unit::Beam, shape.format.depth)
    };
    // Written first: an unwritable folder is found before the long work.
    let emitted = emitted(&request, None)?;
    let mut files = output::files();
    add_verilog(&mut files, &emitted, &options.out, false)?;

    let (mut report, frame) = beam::run(&prepared, &run_options, Engine::BuiltIn)?;
    let golden = golden_frame(&prepared);
    for (name, frame) in [("image.png", &frame), ("golden.png", &golden)] {
        let path = options.out.join(name);
        let lighting = golden_lighting(frame, &prepared);
        let rgb = phong::shade(frame, &lighting, &framed, &prepared.format);
        files.add(&path, |out| {
            picture::png(out, frame.width, frame.height, &rgb)
        })?;
    }
    if let Some(trace) = report.trace.take() {
        trace.add_to(&mut files, &options.out.join("trace.vcd"))?;
    }
    let summary_path = options.out.join("summary.json");
    report.subject = "teapot".into();
    report.reproduce = format!("imogene demo --out {}", options.out.display());
    report.files = files.paths();
    report.files.push(summary_path.clone());
    let summary = Summary {
        pictures_identical: frame == golden,
        report,
        width: SIZE.width,
        height: SIZE.height,
        objects: shape.objects,
        planes: shape.planes,
        latency: emitted.latency,
    };
    files.add_text(&summary_path, &(output::json_text(&summary) + "\n"))?;
    files.finish()?;
    tell(&summary, json)
}

fn tell(summary: &Summary, json: bool) -> Result<(), Failure> {
    if json {
        output::json(summary);
    } else {
        output::text(describe(&summary.report));
        output::text(format!(
            "{} objects with up to {} cut planes, latency {} clocks; pictures of hardware and golden model {}",
            summary.objects,
            summary.planes,
            summary.latency,
            if summary.pictures_identical {
                "are identical"
            } else {
                "DIFFER"
            }
        ));
    }
    verdict(&summary.report)?;
    if summary.pictures_identical {
        Ok(())
    } else {
        Err(Failure::Check("image.png and golden.png differ".into()))
    }
}
