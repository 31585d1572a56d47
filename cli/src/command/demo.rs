//! `imogene demo`.

use super::emit::add_verilog;
use super::machine::write_pictures;
use super::{describe, frame_in, negation, run_beam, threads, verdict};
use crate::arguments::{Demo, Size};
use crate::failure::{Failure, Result};
use crate::output;
use imogene_golden::format::Format;
use imogene_plan::description::MachineDescription;
use imogene_plan::display::image;
use imogene_rtl::emit::machine::emit_machine;
use imogene_scene::SceneFile;
use imogene_verif::display::pins::{PinsRun, run as run_pins};
use imogene_verif::display::request::request_for;
use imogene_verif::engine::Engine;
use imogene_verif::report::Report;
use imogene_verif::scene;
use imogene_verif::waveform::{WaveformRequest, WindowStart};
use serde::Serialize;
use std::panic::resume_unwind;

/// The teapot and a machine with a VGA screen, compiled in so that the demo needs no file.
const TEAPOT: &str = include_str!("../../../scenes/teapot.toml");
const MACHINE: &str = include_str!("../../../machines/beam-640x480.toml");
/// The screen of the machine.
const SCREEN: Size = (640, 480);
/// Picture of the run whose waveforms are kept.
const TRACED_SIZE: Size = (160, 120);
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
    /// Clocks of a frame on the pins.
    clocks_per_frame: u64,
    objects: usize,
    planes: usize,
    pictures_identical: bool,
}

pub fn run(options: &Demo, json: bool) -> Result {
    let file = SceneFile::parse(TEAPOT, "teapot.toml")?;
    let machine = MachineDescription::parse(MACHINE, "beam-640x480.toml")?;
    let (framed, prepared) = frame_in(&file, Some(SCREEN), machine.format()?)?;
    let image = image(&framed, &prepared, &machine)?;
    let command = format!("imogene demo --out {}", options.out.display());
    // Written first: an unwritable folder is found before the long work.
    let mut files = output::files();
    let emitted = emit_machine(&request_for(&machine, &[], &command))?;
    add_verilog(&mut files, &emitted, &options.out, false)?;

    let golden = image.picture.clone();
    let pins = PinsRun::plain(Engine::BuiltIn);
    let (outcome, inside) = std::thread::scope(|scope| {
        let outcome = scope.spawn(|| run_pins(&machine, &[image], &pins, || {}));
        let mut inside = inside(&file, machine.format()?)?;
        if let Some(trace) = inside.trace.take() {
            trace.add_to(&mut files, &options.out.join("trace.vcd"))?;
        }
        let outcome = outcome
            .join()
            .unwrap_or_else(|panic| resume_unwind(panic))?;
        Ok::<_, Failure>((outcome, inside))
    })?;
    let pictures_identical = outcome.picture == golden;
    let pictures = (Some(&*golden), Some(&outcome));
    write_pictures(&machine, pictures, &options.out, &mut files)?;
    let mut report = outcome.report;
    let seconds = report.seconds.max(inside.seconds);
    report.absorb(inside);
    report.timed(seconds);
    report.subject = "teapot".into();
    report.reproduce = command;
    let summary_path = options.out.join("summary.json");
    report.files = files.paths();
    report.files.push(summary_path.clone());
    let summary = Summary {
        report,
        width: SCREEN.0,
        height: SCREEN.1,
        clocks_per_frame: outcome.clocks_per_frame,
        objects: machine.objects,
        planes: machine.planes,
        pictures_identical,
    };
    files.add_text(&summary_path, &(output::json_text(&summary) + "\n"))?;
    files.finish()?;
    output::report(json, &summary, tell);
    verdict(&summary.report)?;
    Failure::unless(summary.pictures_identical, || {
        "pins.png and golden.png differ".into()
    })
}

/// The same scene in a small picture, with the waveforms of a processor: its inside is compared as well.
fn inside(file: &SceneFile, format: Format) -> Result<Report> {
    let (_, prepared) = frame_in(file, Some(TRACED_SIZE), format)?;
    let options = scene::Options {
        trace: Some(WaveformRequest {
            from: WindowStart::Usual,
            clocks: TRACE_CLOCKS,
            nets: vec![],
        }),
        traced: TRACED,
        ..scene::Options::plain(1, threads())
    };
    Ok(run_beam(&prepared, &options, Engine::BuiltIn)?.0)
}

fn tell(summary: &Summary) {
    let not = negation(summary.pictures_identical);
    output::text(describe(&summary.report));
    output::text(format!(
        "{} object processors of {} cut planes on a screen of {} x {}: {} clocks a frame, 16.7 ms at 25.175 MHz; \
         the picture on the pins is {not}the golden picture",
        summary.objects, summary.planes, summary.width, summary.height, summary.clocks_per_frame
    ));
}
