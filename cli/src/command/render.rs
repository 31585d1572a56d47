//! `imogene render`.

mod frames;
mod models;
mod samples;
mod split;

use super::{frame_in, load_seen, looked, read_scene};
use crate::arguments::{Model, Render};
use crate::failure::Failure;
use crate::output;
use imogene_analysis::bounds::{Failing, failing};
use imogene_analysis::metrics::Drawing;
use imogene_analysis::phong;
use imogene_golden::machine::frame::Frame;
use imogene_plan::split::Division;
use imogene_prepare::PreparedScene;
use imogene_scene::{Absent, FramedScene, RangeReport};
use imogene_studies::picture;
use imogene_studies::zones::zones;
use models::draw;
pub use models::{exact_frame, golden_frame, golden_lighting};
use serde::Serialize;
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

/// What was drawn; the keys are stable.
#[derive(Serialize)]
struct RenderReport {
    model: Model,
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

/// Writes what was drawn, and tells of it.
fn finish(
    options: &Render,
    (framed, prepared): (&FramedScene, &PreparedScene),
    (frame, rgb): (&Frame, &[u8]),
    [prepare_seconds, seconds]: [f64; 2],
    split: Option<split::SplitReport>,
    json: bool,
) -> Result<(), Failure> {
    let (width, height) = (prepared.width, prepared.height);
    let report = RenderReport {
        model: options.model,
        width,
        height,
        prepare_seconds,
        seconds,
        pixels_per_second: f64::from(width) * f64::from(height) / seconds.max(1e-9),
        covered_pixels: frame.covered(),
        volumes: prepared.volumes.len(),
        absent: Absent::of(&framed.objects),
        range: framed.range.report(prepared.format.z_max()),
        split,
        files: write(options, frame, rgb)?,
    };
    output::told(json, &report, include_str!("render/picture.txt"))
}

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
        false => frame_in(&file, scene.size, scene.format()?)?,
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
    let seconds = [prepare_seconds, started.elapsed().as_secs_f64()];
    let scene = (&framed, &prepared);
    finish(options, scene, (&frame, &rgb), seconds, None, json)?;
    match options.model {
        Model::Golden => drawn_as_it_is(&failing(&framed, &prepared)),
        Model::Exact | Model::Rtl => Ok(()),
    }
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
    let zones = zones(framed, prepared.format, zone)?;
    let prepare_seconds = started.elapsed().as_secs_f64();
    let started = Instant::now();
    let frame = Drawing::in_zones(&zones, framed).frame;
    let lighting = golden_lighting(&frame, prepared);
    let seconds = [prepare_seconds, started.elapsed().as_secs_f64()];
    let rgb = phong::shade(&frame, &lighting, framed, &prepared.format);
    let scene = (framed, prepared);
    finish(options, scene, (&frame, &rgb), seconds, None, json)
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
    let seconds = [prepare_seconds, started.elapsed().as_secs_f64()];
    let frame = &divided.frame;
    let rgb = phong::shade(frame, &divided.lighting, framed, &prepared.format);
    let scene = (framed, prepared);
    finish(options, scene, (frame, &rgb), seconds, Some(split), json)
}

fn write(options: &Render, frame: &Frame, rgb: &[u8]) -> Result<Vec<PathBuf>, Failure> {
    let mut files = output::files();
    let size = [frame.width, frame.height];
    output::add_picture(&mut files, &options.output(), size, rgb)?;
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
