//! `imogene render`.

mod frames;
mod models;

use super::{frame_in, load_seen, looked, read_scene, threads};
use crate::arguments::{Model, Render};
use crate::failure::{Failure, Result};
use crate::output;
use imogene_analysis::bounds::{Failing, failing};
use imogene_analysis::metrics::Drawing;
use imogene_analysis::phong;
use imogene_golden::machine::accumulator::{Accumulator, PassPixel};
use imogene_golden::machine::frame::Frame;
use imogene_plan::split::{Divided, Division, Duplication, Work, Worker};
use imogene_scene::{Absent, RangeReport, SceneFile};
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
    split: Option<SplitReport>,
}

pub fn run(options: &Render, json: bool) -> Result {
    if let Some(range) = options.frames {
        return frames::run(options, range, json);
    }
    let started = Instant::now();
    // Zones round anew, pieces count the work of all objects, and hardware has a processor for each.
    let (zone, division) = (options.zone, options.split.split);
    let is_picture = zone.is_none() && division.is_none() && options.model != Model::Rtl;
    let scene = &options.scene;
    let file = read_scene(&scene.scene, &scene.view)?;
    let file = looked(file, options.look.look(false), scene.size)?;
    let again = options.samples.map(|count| (count, file.clone()));
    let (framed, prepared) = match is_picture {
        true => load_seen(file, scene)?,
        false => frame_in(&file, scene.size, scene.format()?)?,
    };
    // With coefficients that are rounded anew for each zone.
    let zones = match zone {
        Some(zone) => {
            check_golden(options, "zones are", "--zone")?;
            Some(zones(&framed, prepared.format, zone)?)
        }
        None => None,
    };
    let prepare_seconds = started.elapsed().as_secs_f64();
    let started = Instant::now();
    let mut split = None;
    let (frame, lighting) = match (zones, division) {
        (Some(zones), _) => {
            let frame = Drawing::in_zones(&zones, &framed).frame;
            let lighting = golden_lighting(&frame, &prepared);
            (frame, lighting)
        }
        (None, Some(division)) => {
            check_golden(options, "a divided picture is", "--split")?;
            prepared.refuse_transparent()?;
            let workers = options.split.workers.map_or_else(threads, usize::from);
            let pieces = division.pieces(prepared.width, prepared.height).len() as u64;
            let divided = output::during(pieces, "pieces of the screen", |bar| {
                Divided::draw(&prepared, division, workers, || bar.inc(1))
            });
            split = Some(SplitReport::of(&divided, division));
            (divided.frame, divided.lighting)
        }
        (None, None) => draw(options, &framed, &prepared)?,
    };
    let rgb = match again {
        Some((count, file)) => sampled(options, &file, count)?,
        None => phong::shade(&frame, &lighting, &framed, &prepared.format),
    };
    let seconds = started.elapsed().as_secs_f64();
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
    };
    let files = write(options, &frame, &rgb)?;
    output::written(json, report, files, include_str!("render/picture.txt"))?;
    match is_picture && options.model == Model::Golden {
        true => drawn_as_it_is(&failing(&framed, &prepared)),
        false => Ok(()),
    }
}

/// Warns of each object that the golden picture may not show as it is, and fails if there is any.
fn drawn_as_it_is(failing: &[Failing]) -> Result {
    for Failing { object, reason } in failing {
        output::warning(format!("object '{object}': {reason}"));
    }
    Failure::unless(failing.is_empty(), || {
        let count = failing.len();
        format!(
            "{count} of the objects may not be drawn as they are; `imogene check` says more, and a longer depth word (--format) may help"
        )
    })
}

/// Refuses another model where only the golden one draws.
fn check_golden(options: &Render, what: &str, option: &str) -> Result {
    if options.model == Model::Golden {
        return Ok(());
    }
    Err(Failure::Input(format!(
        "{what} drawn by the golden model; give --model golden, or leave {option} out"
    )))
}

fn write(options: &Render, frame: &Frame, rgb: &[u8]) -> Result<Vec<PathBuf>> {
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

/// The machine's own supersampling: the mean colours of `count` passes, whose places make a square grid about that of
/// the plain picture.
fn sampled(options: &Render, file: &SceneFile, count: u32) -> Result<Vec<u8>> {
    let side = count.isqrt();
    let place = |k: u32| (f64::from(k) + 0.5) / f64::from(side) - 0.5;
    let mut sums: Option<Accumulator> = None;
    let mut mean = vec![];
    for pass in 0..count {
        let mut file = file.flattened().into_owned();
        let sample_at = &mut file.camera.sample_at;
        sample_at[0] += place(pass % side);
        sample_at[1] += place(pass / side);
        let (framed, prepared) = load_seen(file, &options.scene)?;
        let (frame, lighting) = draw(options, &framed, &prepared)?;
        let rgb = phong::shade(&frame, &lighting, &framed, &prepared.format);
        let sums = sums.get_or_insert_with(|| Accumulator::new(rgb.len() / 3));
        for (address, colour) in rgb.chunks_exact(3).enumerate() {
            let pixel = PassPixel {
                address,
                first: pass == 0,
                last: pass + 1 == count,
                colour: [colour[0], colour[1], colour[2]],
            };
            mean.extend(sums.add(&pixel, count).into_iter().flatten());
        }
    }
    Ok(mean)
}

/// How the work was divided; the keys are stable.
#[derive(Serialize)]
struct SplitReport {
    split: Division,
    pieces: usize,
    work: Work,
    /// Mean load of a worker over the greatest, in pixels visited: 1 is even.
    balance: f64,
    /// The same if the pieces were taken from a common queue.
    balance_of_queue: f64,
    /// Mean seconds of a worker over the greatest.
    balance_of_seconds: f64,
    duplication: Duplication,
    workers: Vec<Worker>,
}

impl SplitReport {
    fn of(divided: &Divided, division: Division) -> SplitReport {
        let seconds = divided.workers.iter().map(|worker| worker.seconds);
        let most = seconds.clone().fold(1e-9, f64::max);
        SplitReport {
            split: division,
            pieces: divided.pieces.len(),
            work: divided.work(),
            balance: divided.balance(),
            balance_of_queue: divided.balance_of_queue(),
            balance_of_seconds: seconds.sum::<f64>() / divided.workers.len() as f64 / most,
            duplication: divided.duplication,
            workers: divided.workers.clone(),
        }
    }
}
