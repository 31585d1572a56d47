//! `imogene repair`.

use super::load_scene;
use super::render::{exact_frame, golden_lighting};
use crate::arguments::Repair;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_analysis::phong;
use imogene_files::text::counted;
use imogene_oracle::paint;
use imogene_oracle::repair::{RepairReport, Repaired, differing_faces, repair};
use imogene_prepare::PreparedScene;
use imogene_scene::FramedScene;
use serde::Serialize;
use std::path::PathBuf;
use std::time::Instant;

/// What was repaired; the keys are stable.
#[derive(Serialize)]
struct Report {
    width: u32,
    height: u32,
    #[serde(flatten)]
    repair: RepairReport,
    /// Open pixels of all.
    share: f64,
    /// Every other pixel is as the first pass drew it, bit for bit.
    leaves_the_rest: bool,
    /// The comparison with the whole exact picture.
    exact: Option<Exact>,
}

#[derive(Serialize)]
struct Exact {
    seconds: f64,
    /// Pixels whose object or face differs from the exact one, before and after.
    differing_before: usize,
    differing_after: usize,
}

pub fn run(options: &Repair, json: bool) -> Result {
    let (framed, prepared) = load_scene(&options.scene)?;
    let repaired = output::during(u64::from(prepared.height), "exact repair", |bar| {
        repair(&framed, &prepared, || bar.inc(1))
    });
    let exact = (!options.unchecked).then(|| compare(&framed, &prepared, &repaired));
    let report = Report {
        width: prepared.width,
        height: prepared.height,
        share: repaired.report.open as f64 / repaired.report.pixels as f64,
        leaves_the_rest: repaired.leaves_the_rest(),
        repair: repaired.report.clone(),
        exact,
    };
    let files = write(options, &framed, &prepared, &repaired)?;
    output::written(json, &report, files, include_str!("repair.txt"))?;
    let differing = report.exact.as_ref().map_or(0, |e| e.differing_after);
    Failure::unless(differing == 0 && report.leaves_the_rest, || {
        let pixels = counted(differing, "pixel");
        format!("the repaired picture differs from the exact one at {pixels}")
    })
}

fn compare(framed: &FramedScene, prepared: &PreparedScene, repaired: &Repaired) -> Exact {
    let started = Instant::now();
    let exact = exact_frame(framed, prepared);
    Exact {
        seconds: started.elapsed().as_secs_f64(),
        differing_before: differing_faces(&repaired.first, &exact),
        differing_after: differing_faces(&repaired.frame, &exact),
    }
}

fn write(
    options: &Repair,
    framed: &FramedScene,
    prepared: &PreparedScene,
    repaired: &Repaired,
) -> Result<Vec<PathBuf>> {
    let mut files = output::files();
    let frame = &repaired.frame;
    let size = [frame.width, frame.height];
    if let Some(path) = &options.output {
        let lighting = golden_lighting(frame, prepared);
        let rgb = phong::shade(frame, &lighting, framed, &prepared.format);
        output::add_picture(&mut files, path, size, &rgb)?;
    }
    if let Some(path) = &options.map {
        let open = (0..repaired.open.len()).filter(|&i| repaired.open[i]);
        let rgb = paint::pixels(frame, prepared.format.z_max(), open, paint::ALLOWED, false);
        output::add_picture(&mut files, path, size, &rgb)?;
    }
    Ok(files.finish()?)
}
