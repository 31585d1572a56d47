//! `imogene machine`.

mod files;
mod report;

use super::emit::add_verilog;
use super::{frame_in, read_scene, verdict};
use crate::arguments::{FrameRange, Machine, View, option};
use crate::failure::{Failure, Result};
use crate::output;
pub use files::write_pictures;
use files::{Scene, add_bench, grow};
use imogene_files::text::counted;
use imogene_golden::machine::overlay::OverlayPlane;
use imogene_plan::description::{MachineDescription, Output};
use imogene_plan::display::{DisplayError, Image, check_tables, images as images_on};
use imogene_plan::needs;
use imogene_plan::zone::clocks::clocks;
use imogene_plan::zone::refine::Refinement;
use imogene_rtl::emit::machine::emit_machine;
use imogene_scene::animation::Playback;
use imogene_studies::picture::read_mask;
use imogene_verif::display::pins::{PinsOutcome, PinsRun, run as run_pins};
use imogene_verif::display::request::{request_for, zone_timing};
use imogene_verif::report::Report;
use report::{MachineReport, tell};
use std::fmt::Display;
use std::path::Path;

pub fn run(options: &Machine, json: bool) -> Result {
    let machine = MachineDescription::read(&options.machine)?;
    let overlay = overlay_of(&machine, options)?;
    let scenes = all_prepared(&views(options)?, &machine)?;
    let images = images(&scenes, &machine, &options.machine, options.refine)?;
    let command = command_of(options);
    let request = request_for(&machine, &images[0].tables, &command);
    let mut files = output::files();
    let emitted = emit_machine(&request)?;
    add_verilog(&mut files, &emitted, &options.out, false)?;
    let top = emitted.top;
    let timing = machine.zone.map(|_| zone_timing(&request)).transpose()?;
    let mut growth = vec![];
    if options.growth {
        let scene = &scenes[0].prepared;
        growth = grow(scene, &machine, timing, &options.out, &mut files)?;
    }
    let overlay = overlay.as_ref();
    let mut outcome = match options.emit_only {
        true => None,
        false => Some(show(&machine, &images, overlay, options)?),
    };
    if let Some((outcome, path)) = outcome.as_mut().zip(options.waves.vcd.as_ref()) {
        if let Some(trace) = outcome.report.trace.take() {
            trace.add_to(&mut files, path)?;
        } else if let Some(place) = options.waves.vcd_from {
            output::warning(format!(
                "no waveforms: the run ended before {place}; it showed {}, and --frames shows more",
                counted(outcome.shown.len(), "frame")
            ));
        }
    }
    let golden = images.last().map(|image| match overlay {
        Some(plane) => plane.over(&image.picture),
        None => image.picture.clone(),
    });
    let pictures = (golden.as_deref(), outcome.as_ref());
    write_pictures(&machine, pictures, &options.out, &mut files)?;
    if options.emit_only {
        let place = (options.out.as_path(), &mut files);
        add_bench(&machine, &top, &scenes, &images, overlay, place)?;
    }
    let clocks_per_frame = machine.video_mode().map(|mode| mode.clocks());
    let (columns, lines) = machine.frame_size().unwrap_or_default();
    let fields = machine.fields().len();
    let plans = images.iter().filter_map(|image| image.plan.as_ref());
    let zone_clocks = plans.filter_map(|plan| Some(clocks(plan, &timing?)));
    let mut summary = MachineReport {
        machine: &machine,
        top,
        scenes: scenes.into_iter().map(|scene| scene.name).collect(),
        clocks_per_frame: clocks_per_frame.filter(|_| machine.output == Output::Pins),
        pixels_per_frame: columns * lines,
        words: images.iter().map(|image| image.beats.len()).collect(),
        zone_clocks: zone_clocks.collect(),
        taking: vec![],
        loading: vec![],
        shown: vec![],
        equal: None,
        growth,
        report: None,
        files: files.paths(),
    };
    if let Some(outcome) = outcome {
        (summary.taking, summary.loading) = (outcome.taking, outcome.loading);
        let scene_of = |image: Option<usize>| image.map(|image| image / fields);
        summary.shown = outcome.shown.into_iter().map(scene_of).collect();
        summary.equal = Some(golden.as_ref() == Some(&outcome.picture));
        summary.report = Some(Report {
            reproduce: command,
            ..outcome.report
        });
    }
    let path = options.out.join("summary.json");
    summary.files.push(path.clone());
    files.add_text(&path, &output::json_text(&summary))?;
    files.finish()?;
    output::report(json, &summary, tell);
    summary.report.as_ref().map_or(Ok(()), verdict)
}

/// The scenes and frames that are shown, in their order.
fn views(options: &Machine) -> Result<Vec<(&Path, View)>> {
    let mut views = vec![];
    for path in &options.scenes {
        let as_written = as_written(options);
        match options.animation {
            Some(range) => {
                let frames = frames_of(path, &as_written, range)?;
                views.extend(frames.into_iter().map(|(view, _)| (path.as_path(), view)));
            }
            None => views.push((path, as_written)),
        }
    }
    Ok(views)
}

/// The frames of the animation of a scene, and the seconds that each is shown.
pub fn frames_of(path: &Path, as_written: &View, range: FrameRange) -> Result<Vec<(View, f64)>> {
    let file = read_scene(path, as_written)?;
    let playback = Playback::new(&file).map_err(Failure::in_file(path))?;
    let frames = range.of("--animation", playback.count());
    let frames = frames.map_err(Failure::in_file(path))?;
    let frame = |number: usize| {
        let view = View {
            frame: Some(number as u32),
            ..as_written.clone()
        };
        (view, playback.frame(number - 1).duration)
    };
    Ok(frames.map(frame).collect())
}

/// What a machine, described by a file, shows of scenes.
pub fn images_of(
    views: &[(&Path, View)],
    machine: &MachineDescription,
    path: &Path,
) -> Result<Vec<Image>> {
    let scenes = all_prepared(views, machine)?;
    images(&scenes, machine, path, Refinement::Box)
}

fn all_prepared(views: &[(&Path, View)], machine: &MachineDescription) -> Result<Vec<Scene>> {
    let scene = |(path, view): &(&Path, View)| {
        let file = read_scene(path, view)?;
        let size = machine.drawn_size();
        let size = size.ok_or_else(|| Failure::Input("no video mode".into()))?;
        let (framed, prepared) = frame_in(&file, Some(size), machine.format()?)?;
        Ok(Scene {
            name: format!("{}{}", path.display(), view.options()),
            framed,
            prepared,
        })
    };
    views.iter().map(scene).collect()
}

/// The images of all scenes. What the machine lacks is said at once for all of them.
fn images(
    scenes: &[Scene],
    machine: &MachineDescription,
    path: &Path,
    refine: Refinement,
) -> Result<Vec<Image>> {
    let named =
        |name: &dyn Display, error: &dyn Display| Failure::Input(format!("{name}: {error}"));
    // What no machine shows is the matter of its scene, what this one lacks that of its description.
    for scene in scenes {
        match needs::check(machine, &[scene.parts()]) {
            Ok(()) | Err(DisplayError::Needs(_)) => {}
            Err(error) => return Err(named(&scene.name, &error)),
        }
    }
    let all: Vec<_> = scenes.iter().map(Scene::parts).collect();
    needs::check(machine, &all)
        .map_err(|error| Failure::Advice(format!("{}: {error}", path.display())))?;
    let mut images = vec![];
    for scene in scenes {
        let shown = images_on(&scene.framed, &scene.prepared, machine, refine);
        images.extend(shown.map_err(|error| named(&scene.name, &error))?);
    }
    let scene_of = |image: usize| &scenes[image / machine.fields().len()];
    check_tables(&images).map_err(|error| named(&scene_of(error.image).name, &error))?;
    Ok(images)
}

/// The plane of `--overlay`.
fn overlay_of(machine: &MachineDescription, options: &Machine) -> Result<Option<OverlayPlane>> {
    let Some(path) = &options.overlay else {
        return Ok(None);
    };
    if !machine.overlay {
        let problem =
            "the machine has no overlay plane; --overlay wants a description with overlay = true";
        return Err(Failure::at(&options.machine, problem));
    }
    let (width, height, pixels) = read_mask(path).map_err(|problem| {
        let file = path.display();
        Failure::Input(format!(
            "cannot read '{file}': {problem}; accepted is a PNG picture"
        ))
    })?;
    let screen = machine.video_mode();
    let screen = screen.map(|mode| (mode.line.active as usize, mode.frame.active as usize));
    if screen != Some((width, height)) {
        let (columns, lines) = screen.unwrap_or_default();
        let problem = format!(
            "{width} x {height} pixels; the screen has {columns} x {lines}, and so many are accepted"
        );
        return Err(Failure::at(path, problem));
    }
    Ok(Some(OverlayPlane::new(&pixels, [255; 3])))
}

fn command_of(options: &Machine) -> String {
    let scenes = options.scenes.iter().map(|path| path.display());
    let refine = match options.refine {
        Refinement::Box => "",
        Refinement::Bounds => " --refine bounds",
        Refinement::Pixels => " --refine pixels",
    };
    let frames = option("animation", options.animation);
    format!(
        "imogene machine {}{}{} --machine {}{refine} --out DIR",
        output::joined(scenes, " "),
        as_written(options).options(),
        frames.trim_end(),
        options.machine.display()
    )
}

/// A scene as it is written, through the camera that is asked for.
fn as_written(options: &Machine) -> View {
    View {
        camera: options.camera.clone(),
        frame: None,
    }
}

fn show(
    machine: &MachineDescription,
    images: &[Image],
    overlay: Option<&OverlayPlane>,
    options: &Machine,
) -> Result<PinsOutcome> {
    let waveforms = options.waves.request();
    let run = PinsRun {
        overlay,
        engine: options.engine,
        stalls: options.stalls,
        late: options.late,
        frames: options.frames as usize,
        waveforms: waveforms.as_ref(),
        stops: None,
    };
    let steps = images.len() as u64 + u64::from(options.frames);
    Ok(output::during(steps, "frames on the pins", |bar| {
        run_pins(machine, images, &run, || bar.inc(1))
    })?)
}
