//! `imogene machine`.

use super::{describe, frame_scene, read_scene, verdict};
use crate::arguments::{Machine, Refine, View};
use crate::failure::Failure;
use crate::output;
use imogene_files::Outputs;
use imogene_models::animation::Playback;
use imogene_models::machine::description::{MachineDescription, Output};
use imogene_models::machine::display::{DisplayError, Image, refined_image};
use imogene_models::machine::needs;
use imogene_models::machine::overlay::OverlayPlane;
use imogene_models::machine::zone::clocks::{FrameClocks, ZoneTiming, clocks};
use imogene_models::machine::zone::growth::{Growth, OBJECT_PROCESSORS, ZONE_SIDES, growth};
use imogene_models::machine::zone::plot::plot;
use imogene_models::picture::{self, read_mask};
use imogene_models::prepare::PreparedScene;
use imogene_models::scene::FramedScene;
use imogene_models::text::counted;
use imogene_rtl::emit::display::{DisplayRequest, emit_display};
use imogene_verif::display::DisplayEngine;
use imogene_verif::display::bench::{Bench, BenchFrame};
use imogene_verif::display::pins::{PinsOutcome, PinsRun, run as run_pins};
use imogene_verif::display::request::{request, zone_timing};
use imogene_verif::report::Report;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// What a machine was and did; the keys are stable.
#[derive(Serialize)]
struct MachineReport<'a> {
    machine: &'a MachineDescription,
    top: String,
    scenes: Vec<String>,
    /// Clocks of a frame on the pins, none of a stream; and pixels of it, one per clock within a line.
    clocks_per_frame: Option<u64>,
    pixels_per_frame: u64,
    /// Words of each scene's frame.
    words: Vec<usize>,
    /// Clocks of each scene's frame in a zone machine, by the formula.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    zone_clocks: Vec<FrameClocks>,
    /// Clocks from the first word of each scene until the machine took the last one, and until it came on the screen.
    taking: Vec<u64>,
    loading: Vec<u64>,
    /// Which scene each frame on the pins showed.
    shown: Vec<Option<usize>>,
    /// The picture of the pins is the golden picture, byte for byte.
    equal: Option<bool>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    growth: Vec<Growth>,
    report: Option<Report>,
    files: Vec<PathBuf>,
}

/// Shows scenes on the pins of a machine.
pub fn run(options: &Machine, json: bool) -> Result<(), Failure> {
    let machine = MachineDescription::read(&options.machine).map_err(Failure::input)?;
    let overlay = overlay_of(&machine, options)?;
    let views = views(options)?;
    let scenes = views
        .iter()
        .map(|(path, view)| prepared(path, view, &machine));
    let scenes = scenes.collect::<Result<Vec<_>, _>>()?;
    let images = images(&scenes, &machine, options)?;
    let command = command_of(options);
    let request = request(&machine, &command);
    let mut files = output::files();
    let top = add_verilog(&request, &options.out, &mut files)?;
    let timing = zone_timing_of(&request, &machine)?;
    let mut growths = vec![];
    if options.growth {
        growths = grow(
            &scenes[0].prepared,
            &machine,
            timing,
            &options.out,
            &mut files,
        )?;
    }
    let outcome = match options.emit_only {
        true => None,
        false => Some(show(&machine, &images, overlay.as_ref(), options)?),
    };
    let golden = images.last().map(|image| match &overlay {
        Some(plane) => plane.over(&image.picture),
        None => image.picture.clone(),
    });
    write_pictures(
        &machine,
        golden.as_deref(),
        outcome.as_ref(),
        &options.out,
        &mut files,
    )?;
    if options.emit_only {
        add_bench(
            &machine,
            &top,
            &scenes,
            &images,
            overlay.as_ref(),
            (&options.out, &mut files),
        )?;
    }
    let mode = machine.video_mode().map_or((0, 0), |mode| {
        (mode.clocks(), mode.line.active * mode.frame.active)
    });
    let plans = images.iter().filter_map(|image| image.plan.as_ref());
    let mut summary = MachineReport {
        machine: &machine,
        top,
        scenes: scenes.into_iter().map(|scene| scene.name).collect(),
        clocks_per_frame: (machine.output == Output::Pins).then_some(mode.0),
        pixels_per_frame: mode.1,
        words: images.iter().map(|image| image.beats.len()).collect(),
        zone_clocks: plans
            .filter_map(|plan| timing.map(|timing| clocks(plan, &timing)))
            .collect(),
        taking: outcome.as_ref().map_or(vec![], |o| o.taking.clone()),
        loading: outcome.as_ref().map_or(vec![], |o| o.loading.clone()),
        shown: outcome.as_ref().map_or(vec![], |o| o.shown.clone()),
        equal: outcome
            .as_ref()
            .map(|o| golden.as_ref() == Some(&o.picture)),
        growth: growths,
        report: outcome.map(|o| Report {
            reproduce: command,
            ..o.report
        }),
        files: files.paths(),
    };
    let path = options.out.join("summary.json");
    summary.files.push(path.clone());
    files.add_text(&path, &output::json_text(&summary))?;
    files.finish()?;
    tell(&summary, json);
    match &summary.report {
        Some(report) => verdict(report),
        None => Ok(()),
    }
}

/// The scenes and frames that are shown, in their order.
fn views(options: &Machine) -> Result<Vec<(&Path, View)>, Failure> {
    let mut views = vec![];
    for path in &options.scenes {
        let as_written = View {
            camera: options.camera.clone(),
            frame: None,
        };
        let Some(range) = options.animation else {
            views.push((path.as_path(), as_written));
            continue;
        };
        let named = |error: String| Failure::Input(format!("{}: {error}", path.display()));
        let file = read_scene(path, &as_written)?;
        let playback = Playback::new(&file).map_err(|e| named(e.to_string()))?;
        let frames = range.of("--animation", playback.count());
        for frame in frames.map_err(|e| named(e.to_string()))? {
            let view = View {
                frame: Some(frame as u32),
                ..as_written.clone()
            };
            views.push((path, view));
        }
    }
    Ok(views)
}

/// A scene, ready for the machine.
struct Scene {
    /// Path and options of the view.
    name: String,
    framed: FramedScene,
    prepared: PreparedScene,
}

impl Scene {
    fn parts(&self) -> (&FramedScene, &PreparedScene) {
        (&self.framed, &self.prepared)
    }
}

fn prepared(path: &Path, view: &View, machine: &MachineDescription) -> Result<Scene, Failure> {
    let file = read_scene(path, view)?;
    let (width, height) = machine
        .drawn_size()
        .ok_or_else(|| Failure::Input("no video mode".into()))?;
    let size = crate::arguments::Size { width, height };
    let (framed, prepared) = frame_scene(&file, Some(size), machine.depth_word)?;
    Ok(Scene {
        name: format!("{}{}", path.display(), view.options()),
        framed,
        prepared,
    })
}

/// The images of all scenes. What the machine lacks is said at once for all of them.
fn images(
    scenes: &[Scene],
    machine: &MachineDescription,
    options: &Machine,
) -> Result<Vec<Image>, Failure> {
    let named = |name: &dyn std::fmt::Display, error| Failure::Input(format!("{name}: {error}"));
    // What no machine shows is the matter of its scene, what this one lacks that of its description.
    for scene in scenes {
        match needs::check(machine, &[scene.parts()]) {
            Ok(()) | Err(DisplayError::Needs(_)) => {}
            Err(error) => return Err(named(&scene.name, error)),
        }
    }
    let all: Vec<_> = scenes.iter().map(Scene::parts).collect();
    needs::check(machine, &all).map_err(|error| named(&options.machine.display(), error))?;
    let image = |scene: &Scene| {
        let image = refined_image(
            &scene.framed,
            &scene.prepared,
            machine,
            options.refine.into(),
        );
        image.map_err(|error| named(&scene.name, error))
    };
    scenes.iter().map(image).collect()
}

/// The plane of `--overlay`.
fn overlay_of(
    machine: &MachineDescription,
    options: &Machine,
) -> Result<Option<OverlayPlane>, Failure> {
    let Some(path) = &options.overlay else {
        return Ok(None);
    };
    if !machine.overlay {
        return Err(Failure::Input(format!(
            "{}: the machine has no overlay plane; --overlay wants a description with overlay = true",
            options.machine.display()
        )));
    }
    let (width, height, pixels) = read_mask(path).map_err(Failure::input)?;
    let screen = machine
        .video_mode()
        .map(|mode| (mode.line.active as usize, mode.frame.active as usize));
    if screen != Some((width, height)) {
        let (columns, lines) = screen.unwrap_or_default();
        return Err(Failure::Input(format!(
            "{}: {width} x {height} pixels; the screen has {columns} x {lines}, and so many are accepted",
            path.display()
        )));
    }
    Ok(Some(OverlayPlane::new(&pixels, [255; 3])))
}

fn command_of(options: &Machine) -> String {
    let scenes: Vec<String> = options
        .scenes
        .iter()
        .map(|path| path.display().to_string())
        .collect();
    let refine = match options.refine {
        Refine::Box => "",
        Refine::Bounds => " --refine bounds",
        Refine::Pixels => " --refine pixels",
    };
    let view = View {
        camera: options.camera.clone(),
        frame: None,
    };
    let frames = options.animation.map_or(String::new(), |range| {
        format!(" --animation {range}").trim_end().to_owned()
    });
    format!(
        "imogene machine {}{}{frames} --machine {}{refine} --out DIR",
        scenes.join(" "),
        view.options(),
        options.machine.display()
    )
}

/// Adds the Verilog to the files; returns the name of the top module.
fn add_verilog(
    request: &DisplayRequest,
    out: &Path,
    files: &mut Outputs,
) -> Result<String, Failure> {
    let emitted = emit_display(request).map_err(Failure::input)?;
    let path = out.join(format!("{}.v", emitted.top));
    files.add_text(&path, &emitted.bundle())?;
    Ok(emitted.top)
}

/// Adds what a bench of the user's own drives the machine with.
fn add_bench(
    machine: &MachineDescription,
    top: &str,
    scenes: &[Scene],
    images: &[Image],
    overlay: Option<&OverlayPlane>,
    (out, files): (&Path, &mut Outputs),
) -> Result<(), Failure> {
    let frames = scenes.iter().zip(images).map(|(scene, image)| BenchFrame {
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
    for (name, text) in bench.files().map_err(Failure::input)? {
        files.add_text(&out.join(name), &text)?;
    }
    Ok(())
}

fn zone_timing_of(
    request: &DisplayRequest,
    machine: &MachineDescription,
) -> Result<Option<ZoneTiming>, Failure> {
    match machine.zone {
        Some(_) => zone_timing(request).map(Some).map_err(Failure::input),
        None => Ok(None),
    }
}

fn grow(
    scene: &PreparedScene,
    machine: &MachineDescription,
    timing: Option<ZoneTiming>,
    out: &Path,
    files: &mut Outputs,
) -> Result<Vec<Growth>, Failure> {
    let timing = timing.ok_or_else(|| {
        Failure::Input("--growth counts the passes of a zone machine; a beam machine has one clock for each pixel whatever the scene".into())
    })?;
    let shape = machine.zone_machine();
    let rows = growth(scene, &shape, &timing, &ZONE_SIDES, &OBJECT_PROCESSORS);
    let rows = rows.map_err(Failure::input)?;
    let title = format!(
        "clocks of a frame of {} x {} pixels",
        scene.width / machine.supersampling,
        scene.height / machine.supersampling
    );
    let text = plot(&title, &rows).map_err(Failure::input)?;
    files.add_text(&out.join("growth.svg"), &text)?;
    Ok(rows)
}

fn show(
    machine: &MachineDescription,
    images: &[Image],
    overlay: Option<&OverlayPlane>,
    options: &Machine,
) -> Result<PinsOutcome, Failure> {
    let engine = match options.engine.simulator() {
        None => DisplayEngine::RustHdl,
        Some(simulator) => DisplayEngine::Verilog(simulator),
    };
    let run = PinsRun {
        overlay,
        engine,
        stalls: options.stalls,
        late: options.late,
        frames: options.frames as usize,
    };
    let bar = output::progress(
        images.len() as u64 + u64::from(options.frames),
        "frames on the pins",
    );
    let outcome = run_pins(machine, images, &run, || bar.inc(1));
    bar.finish_and_clear();
    outcome.map_err(Failure::input)
}

fn write_pictures(
    machine: &MachineDescription,
    golden: Option<&[u8]>,
    outcome: Option<&PinsOutcome>,
    out: &Path,
    files: &mut Outputs,
) -> Result<(), Failure> {
    let Some((mode, golden)) = machine.video_mode().zip(golden) else {
        return Ok(());
    };
    let size = (mode.line.active as usize, mode.frame.active as usize);
    let mut write = |name: &str, picture: &[u8]| {
        files.add(&out.join(name), |out| {
            picture::png(out, size.0, size.1, picture)
        })?;
        Ok::<(), Failure>(())
    };
    write("golden.png", golden)?;
    match outcome {
        Some(outcome) if outcome.picture.len() == golden.len() => {
            write("pins.png", &outcome.picture)
        }
        _ => Ok(()),
    }
}

fn tell(summary: &MachineReport, json: bool) {
    if json {
        output::json(summary);
        return;
    }
    let pace = match summary.clocks_per_frame {
        Some(clocks) => format!("in {clocks} clocks of a frame on the pins"),
        None => "of a frame over AXI4-Stream".to_owned(),
    };
    output::text(format!(
        "{}: {} {pace}",
        summary.top,
        counted(summary.pixels_per_frame, "pixel")
    ));
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
        output::text(format!(
            "  {}, {shown} of a scene; the last one is {} golden picture",
            counted(summary.shown.len(), "frame"),
            if summary.equal == Some(true) {
                "the"
            } else {
                "NOT the"
            }
        ));
    }
    for file in &summary.files {
        output::text(format!("  wrote {}", file.display()));
    }
}
