//! `imogene detail`.

use super::load_scene;
use crate::arguments::Detail;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_files::text::counted;
use imogene_plan::culling::precision::guard_bits;
use imogene_plan::culling::reduce::ReducedObject;
use imogene_plan::culling::zones::{Touches, beside, map};
use imogene_prepare::PreparedScene;
use imogene_studies::detail::{Changed, Report, WorkSaved, ZoneStream};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Pixels of the bar between two maps.
const GAP: usize = 8;

/// What a scene requires; the keys are stable.
#[derive(Serialize)]
struct DetailReport<'a> {
    scene: String,
    width: u32,
    height: u32,
    zone: u32,
    /// Pixels of an object that may change.
    pixels: u64,
    objects: Vec<Row<'a>>,
    work: WorkSaved,
    hidden: u64,
    loads: Touches,
    changed: Changed,
    /// The stream of a zone machine with 8 object and 4 volume processors for the whole scene, by each refinement.
    zone_streams: Vec<ZoneStream>,
    /// Why there is none.
    zone_refusal: Option<String>,
}

#[derive(Serialize)]
struct Row<'a> {
    #[serde(flatten)]
    object: &'a ReducedObject,
    zones: Touches,
    /// Guard bits of f1 and f2 with which rounding moves neither by more than half a count on its box.
    guards: [u32; 2],
}

pub fn run(options: &Detail, json: bool) -> Result {
    let (framed, prepared) = load_scene(&options.scene)?;
    prepared.refuse_composed()?;
    let report = output::during(1, "what the scene requires", |_| {
        Report::of(&framed, &prepared, options.zone, options.pixels)
    });
    let out = options.out.as_ref();
    let files = out.map(|out| write_maps(&report, &prepared, out));
    let files = files.transpose()?.unwrap_or_default();
    let (streams, refusal) = match &report.streams {
        Ok(streams) => (streams.to_vec(), None),
        Err(why) => (vec![], Some(why.to_string())),
    };
    let summary = DetailReport {
        scene: options.scene.scene.display().to_string(),
        width: prepared.width,
        height: prepared.height,
        zone: options.zone,
        pixels: options.pixels,
        objects: rows(&report, &prepared),
        work: report.work,
        hidden: report.hidden,
        loads: report.loads,
        changed: report.changed,
        zone_streams: streams,
        zone_refusal: refusal,
    };
    output::written(json, &summary, files, include_str!("detail.txt"))?;
    let holds = options.pixels > 0 || report.changed == Changed::default();
    Failure::unless(holds, || {
        let pixels = counted(report.changed.pixels, "pixel");
        format!(
            "{}: {pixels} other than before, and none may be",
            summary.scene
        )
    })
}

fn rows<'a>(report: &'a Report, prepared: &PreparedScene) -> Vec<Row<'a>> {
    let row = |(index, object): (usize, &'a ReducedObject)| {
        let window = prepared.objects[index].screen_box();
        let side = (window.x1 - window.x0).max(window.y1 - window.y0) + 1;
        Row {
            object,
            zones: report.touches.objects[index],
            guards: guard_bits(side.max(1) as u64),
        }
    };
    report.reduced.objects.iter().enumerate().map(row).collect()
}

fn write_maps(report: &Report, prepared: &PreparedScene, out: &Path) -> Result<Vec<PathBuf>> {
    let size = (prepared.width as usize, prepared.height as usize);
    let mut files = output::files();
    let mut write = |name: &str, width: usize, rgb: &[u8]| {
        output::add_picture(&mut files, &out.join(name), [width, size.1], rgb)
    };
    write("picture.png", size.0, &report.picture)?;
    let mut pair = |name: &str, (before, after): (Vec<u64>, Vec<u64>)| {
        let most = before.iter().copied().max().unwrap_or(0);
        let one = |counts: &[u64]| {
            let screen = (prepared.width, prepared.height);
            map(&report.touches.pieces, counts, most, screen)
        };
        let (width, rgb) = beside(&one(&before), &one(&after), size, GAP);
        write(name, width, &rgb)
    };
    let zones = report.touches.zones.iter();
    let objects = zones.map(|zone| (zone.boxes, zone.bounds));
    pair("objects.png", objects.unzip())?;
    if !prepared.volumes.is_empty() && report.streams.is_ok() {
        let volumes = report.volumes_of_zones.iter();
        let volumes = volumes.map(|zone| (zone[0], zone[1]));
        pair("volumes.png", volumes.unzip())?;
    }
    Ok(files.finish()?)
}
