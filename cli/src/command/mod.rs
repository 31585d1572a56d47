//! The commands.

pub mod board;
pub mod bounds;
pub mod check;
pub mod cosim;
pub mod cracks;
pub mod demo;
pub mod detail;
pub mod emit;
pub mod evaluate;
pub mod extremes;
pub mod fit;
pub mod fitted;
pub mod import;
pub mod machine;
pub mod mutate;
pub mod new;
pub mod package;
pub mod peers;
pub mod prepare;
pub mod primitives;
pub mod prove;
pub mod raytrace;
pub mod render;
pub mod repair;
pub mod shading;
pub mod speed;
pub mod sweep;
pub mod synth;
pub mod terrain;
pub mod trade;
pub mod units;

use crate::arguments::{Scene, Size, View};
use crate::failure::{Failure, Result};
use crate::{missing, molecules, output};
use imogene_files::text::counted;
use imogene_files::{free_memory, memory_limit};
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_prepare::{Framing, PreparedScene, Seen, memory, prepare_reporting, steps};
use imogene_scene::animation::Playback;
use imogene_scene::{FramedScene, Look, SceneFile};
use imogene_verif::engine::Engine;
use imogene_verif::report::Report;
use imogene_verif::scene::{self, Options, slots};
use std::path::Path;

/// A scene in the camera frame, and its words.
type Framed = (FramedScene, PreparedScene);

/// A scene file in the camera frame and prepared for a format.
fn load_scene(scene: &Scene) -> Result<Framed> {
    let file = read_scene(&scene.scene, &scene.view)?;
    frame_in(&file, scene.size, scene.format()?)
}

/// A scene of which only the picture counts, framed and prepared: without the objects that nobody sees.
fn load_seen(file: SceneFile, scene: &Scene) -> Result<Framed> {
    let ((width, height), format) = (size_of(&file, scene.size), scene.format()?);
    let bar = output::progress(file.frame_steps(), "framing");
    let seen = Seen::of(&file, (width, height), &format, &|| bar.inc(1))?;
    has_room(seen.memory(), file.objects.len())?;
    let framed = seen.frame(&|| bar.inc(1))?;
    bar.finish_and_clear();
    // A file of a million objects takes more memory than what is kept of them.
    drop(file);
    prepared(framed, format)
}

/// A scene file with the camera and the frame that are asked for.
fn read_scene(path: &Path, view: &View) -> Result<SceneFile> {
    let mut file = molecules::read_scene(path)?;
    if let Some(name) = &view.camera {
        file.look_through(name).map_err(Failure::in_file(path))?;
    }
    let Some(frame) = view.frame else {
        return Ok(file);
    };
    let playback = Playback::new(&file).map_err(Failure::in_file(path))?;
    let count = playback.count();
    if frame as usize > count {
        let frames = counted(count, "frame");
        let problem = format!(
            "--frame {frame}: the animation has {frames}; a number from 1 to {count} is possible"
        );
        return Err(Failure::at(path, problem));
    }
    playback
        .scene(frame as usize - 1)
        .map_err(Failure::in_file(path))
}

/// The scene as it is looked at; with a warning of what is endless and does not fit into a picture.
fn looked(file: SceneFile, look: Option<Look>, size: Option<Size>) -> Result<SceneFile> {
    let Some(look) = look else {
        return Ok(file);
    };
    let (file, endless) = look.applied(&file, size_of(&file, size))?;
    for name in &endless {
        output::warning(format!(
            "object '{name}' has no end that --fit could count with"
        ));
    }
    Ok(file)
}

/// Size of a picture: the one asked for, or the scene's own.
fn size_of(file: &SceneFile, size: Option<Size>) -> (u32, u32) {
    size.unwrap_or((file.image.width, file.image.height))
}

fn frame_in(file: &SceneFile, size: Option<Size>, format: Format) -> Result<Framed> {
    let (width, height) = size_of(file, size);
    has_room(memory::of_scene(file), file.objects.len())?;
    let framed = output::during(file.frame_steps(), "framing", |bar| {
        file.frame_reporting(width, height, &|| bar.inc(1))
    })?;
    prepared(framed, format)
}

/// Refuses a preparation that would not fit into memory.
fn has_room(needed: u64, objects: usize) -> Result {
    let Some(free) = free_memory().filter(|free| *free < needed) else {
        return Ok(());
    };
    let mib = |bytes: u64| bytes.div_ceil(1 << 20);
    let remedy = match memory_limit() {
        // A little more, because two runs do not take the same.
        Some(limit) => format!("--max-memory {}M", mib(limit + needed - free + needed / 8)),
        None => format!("{}M more memory", mib(needed - free)),
    };
    Err(Failure::Input(format!(
        "preparing {} takes up to {}M of memory, and {}M are left; {remedy} would do, or fewer objects",
        counted(objects, "object"),
        mib(needed),
        mib(free)
    )))
}

fn prepared(framed: FramedScene, format: Format) -> Result<Framed> {
    let prepared = output::during(steps(&framed), "preparation", |bar| {
        prepare_reporting(&framed, format, missing::options(), &|| bar.inc(1))
    })?;
    missing::tell("", &framed, &prepared)?;
    Ok((framed, prepared))
}

/// The report of a scene and the frame that the hardware drew.
type Drawn = (Report, Frame);

fn run_beam(prepared: &PreparedScene, options: &Options, engine: Engine) -> Result<Drawn> {
    let pixels = u64::from(prepared.width) * u64::from(prepared.height);
    Ok(output::during(pixels, "hardware in simulation", |bar| {
        scene::run(prepared, options, engine, || bar.inc(1))
    })?)
}

/// The same with processors that a beam machine does not have, each by itself.
fn run_slots(prepared: &PreparedScene, rows_per_stage: usize, engine: Engine) -> Result<Drawn> {
    let pixels = slots::pixels(prepared);
    Ok(output::during(pixels, "processors in simulation", |bar| {
        slots::run(prepared, rows_per_stage, engine, |n| bar.inc(n))
    })?)
}

/// Threads for independent work.
fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// The result of a co-simulation as text.
fn describe(report: &Report) -> String {
    let mut text = format!(
        "{}: {}, {}, {} compared in {:.1} s ({:.0} clocks per second, engine {}): {}",
        report.subject,
        counted(report.cycles, "clock"),
        counted(report.pixels, "pixel"),
        counted(report.comparisons, "value"),
        report.seconds,
        report.cycles_per_second,
        report.engine,
        counted(report.mismatches, "mismatch")
    );
    if let Some(seed) = report.seed {
        text += &format!(", seed {seed}");
    }
    for file in &report.files {
        text += &format!("\n  wrote {}", file.display());
    }
    text
}

/// What stands before the outcome of a comparison.
fn negation(holds: bool) -> &'static str {
    if holds { "" } else { "NOT " }
}

/// Success if hardware and golden model agree, else the report of the first differences.
fn verdict(report: &Report) -> Result {
    if report.passed() {
        return Ok(());
    }
    let subject = &report.subject;
    if report.mismatches == 0 {
        return Err(Failure::Check(format!("{subject}: nothing was compared")));
    }
    let mismatches = counted(report.mismatches, "mismatch");
    let mut text = format!("{subject}: {mismatches} between hardware and golden model");
    for mismatch in &report.first_mismatches {
        text += &format!("\n  {mismatch}");
    }
    for file in &report.files {
        text += &format!("\n  trace: {}", file.display());
    }
    text += &format!("\n  reproduce: {}", report.reproduce);
    Err(Failure::Check(text))
}
