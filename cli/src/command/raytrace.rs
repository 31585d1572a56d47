//! `imogene raytrace`.

use super::{read_scene, size_of};
use crate::arguments::Raytrace;
use crate::failure::{Failure, Result};
use crate::{missing, output};
use imogene_files::text::counted;
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_oracle::compare::{CLOSE_LEVELS, Mark, Seen};
use imogene_oracle::ordinary::scene_text;
use imogene_oracle::paint;
use imogene_oracle::run::{Outcome, run as trace};
use imogene_oracle::survey::survey;
use imogene_oracle::table::{Row, table};
use imogene_prepare::Options;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// What was compared; the keys are stable.
#[derive(Serialize)]
struct TraceReport {
    format: u32,
    holds: bool,
    scenes: Vec<Row>,
    files: Vec<PathBuf>,
}

pub fn run(options: &Raytrace, json: bool) -> Result {
    if options.output.is_some() && options.scenes.len() > 1 {
        return Err(Failure::Input(
            "one picture for several scenes; give --out DIR for one of each, or one scene".into(),
        ));
    }
    let format = Format::new(options.format)?;
    if let Some(scenes) = options.random {
        return random(scenes, options, format, json);
    }
    let (mut rows, mut files) = (vec![], output::files());
    for path in &options.scenes {
        let (row, picture) = one(path, options, &format)?;
        let in_folder = options.out.as_ref().map(|folder| {
            let name = path.file_stem().unwrap_or(path.as_os_str());
            folder.join(name).with_extension("png")
        });
        if let Some((frame, marks)) = picture
            && let Some(file) = options.output.clone().or(in_folder)
        {
            let rgb = paint::comparison(&frame, format.z_max(), &marks);
            output::add_picture(&mut files, &file, [frame.width, frame.height], &rgb)?;
        }
        if !json {
            tell(&row);
        }
        rows.push(row);
    }
    if let Some(path) = &options.table {
        files.add_text(path, &table(&rows))?;
    }
    let files = files.finish()?;
    let failed = rows.iter().filter(|row| !row.holds()).count();
    if json {
        output::json(&TraceReport {
            format: options.format,
            holds: failed == 0,
            scenes: rows,
            files,
        });
    } else {
        output::wrote(&files);
    }
    Failure::unless(failed == 0, || {
        let scenes = counted(options.scenes.len(), "scene");
        format!("of {scenes}, {failed} differ from the traced picture where they must not")
    })
}

/// Looks at scenes made at random.
fn random(scenes: u64, options: &Raytrace, format: Format, json: bool) -> Result {
    let found = output::during(scenes, "random scenes", |bar| {
        survey(options.seed, scenes, format, || bar.inc(1))
    });
    if let Some(folder) = &options.out {
        let mut files = output::files();
        let findings = [&found.refused, &found.check_fails, &found.differing];
        for finding in findings.into_iter().flatten() {
            let file = folder.join(format!("{}-{}.toml", options.seed, finding.number));
            let text = scene_text(options.seed, finding.number);
            files.add_text(&file, &text)?;
        }
        files.finish()?;
    }
    output::told(json, &found, include_str!("survey.txt"))?;
    let differing = found.differing.len();
    Failure::unless(differing == 0, || {
        format!("{differing} of {scenes} scenes differ from the traced picture where they must not")
    })
}

type Drawn = Option<(Frame, Vec<Mark>)>;

fn one(path: &Path, options: &Raytrace, format: &Format) -> Result<(Row, Drawn)> {
    let scene = read_scene(path, &options.view)?;
    let (width, height) = size_of(&scene, options.size);
    let named = path.display().to_string();
    let scene = match missing::reduced(scene, (width, height), *format, Options::default()) {
        Ok(scene) => scene,
        Err(refusal) if options.scenes.len() == 1 => return Err(refusal),
        Err(refusal) => {
            let reason = refusal.message().unwrap_or_default();
            return Ok((Row::new(named, (width, height), Err(reason)), None));
        }
    };
    let bar = output::progress(1, "tracing");
    let outcome = trace(&scene, width, height, *format, &|steps| {
        bar.set_length(steps);
        bar.inc(1);
    })?;
    bar.finish_and_clear();
    Ok(match outcome {
        Outcome::Refused(reason) if options.scenes.len() == 1 => {
            return Err(Failure::Input(reason));
        }
        Outcome::Refused(reason) => (Row::new(named, (width, height), Err(reason)), None),
        Outcome::Compared(found) => (
            Row::new(named, (width, height), Ok(&found)),
            Some((found.golden, found.marks)),
        ),
    })
}

fn tell(row: &Row) {
    let (size, scene) = (format!("{} x {}", row.width, row.height), &row.scene);
    let Some(c) = &row.comparison else {
        let reason = row.refused.as_deref().unwrap_or_default();
        return output::text(format!("{scene}: refused: {reason}"));
    };
    let verdict = if c.holds() { "holds" } else { "DIFFERS" };
    output::text(format!(
        "{scene}: {verdict}; {size}, {} covered, traced in {:.2} s ({} exactly); band {}, {} differ in it, {} outside, \
         {} tied, {} announced; depths off by at most {:.2} words outside the band, {:.0} % of the bound, {} beyond it; \
         colours of {}, of {} known to {} levels and off by {:.2} at most, {} beyond their bound",
        c.covered,
        row.trace_seconds,
        counted(c.solved_exactly, "pixel"),
        counted(c.band, "pixel"),
        c.differences_inside,
        c.differences_outside,
        c.tied,
        c.announced,
        c.depth_error,
        100.0 * c.depth_ratio,
        c.depths_beyond_bound,
        counted(c.colours, "pixel"),
        c.colours_known,
        CLOSE_LEVELS,
        c.colour_error,
        c.colours_beyond_bound
    ));
    for d in &c.first {
        let side = |s: &Seen| match s.object {
            -1 => "the background".to_owned(),
            id => format!("object {id}, face {}, depth {:.3}", s.number, s.depth),
        };
        let (x, y, golden, traced) = (d.x, d.y, side(&d.golden), side(&d.traced));
        output::text(format!(
            "  column {x}, line {y}: golden {golden}, traced {traced}"
        ));
        if let Some((golden, allowed)) = d.colour {
            output::text(format!(
                "    in the colour {golden:?}; the traced one is {allowed:.1?}"
            ));
        }
    }
}
