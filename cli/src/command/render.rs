//! `imogene render`.

mod frames;
mod samples;
mod split;

use super::{frame_in, load_seen, looked, read_scene, threads, verdict};
use crate::arguments::{Model, Render, Scene};
use crate::failure::Failure;
use crate::output;
use imogene_analysis::bounds::{Failing, failing};
use imogene_analysis::exact;
use imogene_analysis::metrics::Drawing;
use imogene_analysis::phong;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_plan::split::Division;
use imogene_prepare::PreparedScene;
use imogene_scene::{Absent, FramedScene, FramedSource, RangeReport};
use imogene_studies::picture;
use imogene_studies::text::counted;
use imogene_studies::trade::measure::zones;
use imogene_verif::engine::built_in::BuiltIn;
use imogene_verif::report::Report;
use imogene_verif::scene::{self, slots};
use serde::Serialize;
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

/// What was drawn; the keys are stable.
#[derive(Serialize)]
struct RenderReport {
    model: &'static str,
    width: u32,
    height: u32,
    prepare_seconds: f64,
    seconds: f64,
    pixels_per_second: f64,
    covered_pixels: usize,
    volumes: usize,
    /// Objects that were left out because nobody sees them.
    #[serde(flatten)]
    absent: Absent,
    /// The range of the depth word.
    range: RangeReport,
    #[serde(skip_serializing_if = "Option::is_none")]
    split: Option<split::SplitReport>,
    files: Vec<PathBuf>,
}

/// Draws a scene.
pub fn run(options: &Render, json: bool) -> Result<(), Failure> {
    if let Some(range) = options.frames {
        return frames::run(options, range, json);
    }
    let started = Instant::now();
    // Zones round anew, pieces count the work of all objects, and hardware has a processor for each.
    let is_picture =
        options.zone.is_none() && options.split.split.is_none() && options.model != Model::Rtl;
    let scene = &options.scene;
    let file = read_scene(&scene.scene, &scene.view)?;
    let file = looked(file, options.look.look(false), scene.size)?;
    let again = options.samples.map(|count| (count, file.clone()));
    let (framed, prepared) = match is_picture {
        true => load_seen(file, scene)?,
        false => frame_in(&file, scene.size, scene.format().map_err(Failure::input)?)?,
    };
    let prepare_seconds = started.elapsed().as_secs_f64();
    if let Some(zone) = options.zone {
        return zoned(options, zone, &framed, &prepared, json);
    }
    if let Some(division) = options.split.split {
        return divided(options, division, &framed, &prepared, prepare_seconds, json);
    }
    let started = Instant::now();
    let (frame, lighting) = draw(options, &framed, &prepared)?;
    let rgb = match again {
        Some((count, file)) => samples::colours(options, &file, count)?,
        None => phong::shade(&frame, &lighting, &framed, &prepared.format),
    };
    let seconds = started.elapsed().as_secs_f64();
    let files = write(options, &frame, &rgb)?;
    let failing = match options.model {
        Model::Golden => failing(&framed, &prepared),
        Model::Exact | Model::Rtl => vec![],
    };
    report(
        RenderReport {
            model: match options.model {
                Model::Exact => "exact",
                Model::Golden => "golden",
                Model::Rtl => "rtl",
            },
            width: prepared.width,
            height: prepared.height,
            prepare_seconds,
            seconds,
            pixels_per_second: per_second(&prepared, seconds),
            covered_pixels: frame.covered(),
            volumes: prepared.volumes.len(),
            absent: Absent::of(&framed.objects),
            range: framed.range.report(prepared.format.z_max()),
            split: None,
            files,
        },
        json,
    );
    drawn_as_it_is(&failing)
}

/// The frame by the model that is asked for, and what lights it.
fn draw(
    options: &Render,
    framed: &FramedScene,
    prepared: &PreparedScene,
) -> Result<(Frame, Lighting), Failure> {
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

/// Warns of each object that the golden picture may not show as it is, and fails if there is any.
fn drawn_as_it_is(failing: &[Failing]) -> Result<(), Failure> {
    for Failing { object, reason } in failing {
        output::warning(format!("object '{object}': {reason}"));
    }
    match failing.len() {
        0 => Ok(()),
        n => Err(Failure::Check(format!(
            "{n} of the objects may not be drawn as they are; `imogene check` says more, and a longer depth word (--format) may help"
        ))),
    }
}

/// The picture of coefficients that are rounded anew for each zone.
fn zoned(
    options: &Render,
    zone: u32,
    framed: &FramedScene,
    prepared: &PreparedScene,
    json: bool,
) -> Result<(), Failure> {
    if options.model != Model::Golden {
        return Err(Failure::Input(
            "zones are drawn by the golden model; give --model golden, or leave --zone out".into(),
        ));
    }
    let started = Instant::now();
    let zones = zones(framed, prepared.format, zone).map_err(Failure::input)?;
    let prepare_seconds = started.elapsed().as_secs_f64();
    let started = Instant::now();
    let frame = Drawing::in_zones(&zones, framed).frame;
    let lighting = golden_lighting(&frame, prepared);
    let seconds = started.elapsed().as_secs_f64();
    let rgb = phong::shade(&frame, &lighting, framed, &prepared.format);
    let files = write(options, &frame, &rgb)?;
    report(
        RenderReport {
            model: "golden",
            width: prepared.width,
            height: prepared.height,
            prepare_seconds,
            seconds,
            pixels_per_second: per_second(prepared, seconds),
            covered_pixels: frame.covered(),
            volumes: prepared.volumes.len(),
            absent: Absent::of(&framed.objects),
            range: framed.range.report(prepared.format.z_max()),
            split: None,
            files,
        },
        json,
    );
    Ok(())
}

/// The picture that workers draw piece by piece.
fn divided(
    options: &Render,
    division: Division,
    framed: &FramedScene,
    prepared: &PreparedScene,
    prepare_seconds: f64,
    json: bool,
) -> Result<(), Failure> {
    let started = Instant::now();
    let (divided, split) = split::draw(options, division, prepared)?;
    let seconds = started.elapsed().as_secs_f64();
    let rgb = phong::shade(&divided.frame, &divided.lighting, framed, &prepared.format);
    let files = write(options, &divided.frame, &rgb)?;
    report(
        RenderReport {
            model: "golden",
            width: prepared.width,
            height: prepared.height,
            prepare_seconds,
            seconds,
            pixels_per_second: per_second(prepared, seconds),
            covered_pixels: divided.frame.covered(),
            volumes: prepared.volumes.len(),
            absent: Absent::of(&framed.objects),
            range: framed.range.report(prepared.format.z_max()),
            split: Some(split),
            files,
        },
        json,
    );
    Ok(())
}

fn per_second(prepared: &PreparedScene, seconds: f64) -> f64 {
    f64::from(prepared.width) * f64::from(prepared.height) / seconds.max(1e-9)
}

fn report(report: RenderReport, json: bool) {
    if json {
        output::json(&report);
    } else {
        output::text(format!(
            "{} x {} pixels by the {} model in {:.3} s, {} covered",
            report.width, report.height, report.model, report.seconds, report.covered_pixels
        ));
        if report.volumes > 0 {
            output::text(format!(
                "{}; prepared in {:.3} s",
                counted(report.volumes, "shadow or light volume"),
                report.prepare_seconds
            ));
        }
        let Absent { hidden, off_screen } = report.absent;
        if hidden + off_screen > 0 {
            output::text(format!(
                "{} not prepared: {hidden} hidden by others, {off_screen} off the screen",
                counted(hidden + off_screen, "object")
            ));
        }
        if let Some(split) = &report.split {
            split.tell();
        }
        for file in &report.files {
            output::text(format!("wrote {}", file.display()));
        }
    }
}

fn exact_frame(framed: &FramedScene, prepared: &PreparedScene) -> Frame {
    let bar = output::progress(u64::from(prepared.height), "exact reference");
    let pixels = exact::render::render(framed, &prepared.format, || bar.inc(1));
    bar.finish_and_clear();
    exact::render::to_frame(&pixels, framed, &prepared.format)
}

/// The golden model's frame.
pub fn golden_frame(prepared: &PreparedScene) -> Frame {
    let bar = output::progress(u64::from(prepared.height), "golden model");
    let (width, height) = (prepared.width as usize, prepared.height as usize);
    let frame = beam::render(&prepared.slots(), &prepared.format, width, height, || {
        bar.inc(1)
    });
    bar.finish_and_clear();
    frame
}

fn exact_lighting(framed: &FramedScene, frame: &Frame) -> Lighting {
    let casts = |s: &FramedSource| s.shadows || s.cone.is_some();
    if !framed.sources.iter().any(casts) {
        return Lighting::full(frame);
    }
    let bar = output::progress(u64::from(framed.height), "exact shadows");
    let lighting = exact::shadow::lighting(framed, || bar.inc(1));
    bar.finish_and_clear();
    lighting
}

/// What the golden volumes leave of the sources of a frame.
pub fn golden_lighting(frame: &Frame, prepared: &PreparedScene) -> Lighting {
    let bar = output::progress(u64::from(prepared.height), "shadow and light volumes");
    let lighting = prepared.light(frame, || bar.inc(1));
    bar.finish_and_clear();
    lighting
}

fn hardware_frame(options: &Render, prepared: &PreparedScene) -> Result<Frame, Failure> {
    let (mut report, frame) = match slots::is_for_beam(prepared) {
        true => beam_frame(options, prepared)?,
        false => slots_frame(options, prepared)?,
    };
    report.subject = options.scene.scene.display().to_string();
    report.reproduce = reproduce(options);
    verdict(&report)?;
    Ok(frame)
}

/// The command that shows the difference again.
fn reproduce(options: &Render) -> String {
    let Scene {
        scene, view, words, ..
    } = &options.scene;
    let words = words.options(options.scene.format);
    let (scene, view) = (scene.display(), view.options());
    match options.look.look(false) {
        None => format!("imogene cosim {scene}{words}{view}"),
        Some(_) => format!("imogene render {scene}{words}{view} --model rtl, with the same look"),
    }
}

/// The frame of processors that run by themselves.
fn slots_frame(options: &Render, prepared: &PreparedScene) -> Result<(Report, Frame), Failure> {
    let bar = output::progress(slots::pixels(prepared), "processors in simulation");
    let drawn = slots::run(prepared, options.rows_per_stage, &|s, _| Ok(s), |n| {
        bar.inc(n)
    });
    bar.finish_and_clear();
    drawn.map_err(Failure::input)
}

/// The frame of a beam machine.
fn beam_frame(options: &Render, prepared: &PreparedScene) -> Result<(Report, Frame), Failure> {
    let pixels = u64::from(prepared.width) * u64::from(prepared.height);
    let bar = output::progress(pixels, "hardware in simulation");
    let run_options = scene::Options {
        rows_per_stage: options.rows_per_stage,
        threads: threads(),
        trace: None,
        fault: None,
    };
    let engine = |shape: &_| BuiltIn::new(shape).expect("the shape was checked");
    let drawn = scene::run(prepared, &run_options, engine, || bar.inc(1));
    bar.finish_and_clear();
    drawn.map_err(Failure::input)
}

fn write(options: &Render, frame: &Frame, rgb: &[u8]) -> Result<Vec<PathBuf>, Failure> {
    let mut files = output::files();
    files.add(&options.output(), |out| {
        picture::png(out, frame.width, frame.height, rgb)
    })?;
    type Writer = fn(&mut dyn Write, &Frame) -> std::io::Result<()>;
    let arrays: [(&Option<PathBuf>, Writer); 3] = [
        (&options.depth, picture::depth),
        (&options.ids, picture::ids),
        (&options.normals, picture::normals),
    ];
    for (path, write) in arrays {
        if let Some(path) = path {
            files.add(path, |out| write(out, frame))?;
        }
    }
    Ok(files.finish()?)
}
