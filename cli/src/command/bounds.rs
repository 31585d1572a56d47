//! `imogene bounds`.

use super::frame_in;
use crate::arguments::{Bounds, Size};
use crate::failure::{Failure, Result};
use crate::{molecules, output};
use imogene::verdict;
use imogene_analysis::bounds::headroom::{Headroom, Summary, headroom, summaries};
use imogene_golden::format::Format;
use imogene_scene::SceneFile;
use imogene_studies::kit::DrawError;
use imogene_studies::kit::page::{text, with};
use imogene_studies::trial::{self, FORMATS, Term, TrialReport};
use serde::Serialize;
use serde_json::json;
use std::path::{Path, PathBuf};

pub fn run(options: &Bounds, json: bool) -> Result {
    match options.scenes.is_empty() {
        true => try_bounds(options, json),
        false => show_headroom(options, json),
    }
}

/// The trial of every format; the keys are stable.
#[derive(Serialize)]
struct Trial {
    seed: u64,
    cases: u64,
    violations: u64,
    formats: Vec<TrialReport>,
}

fn try_bounds(options: &Bounds, json: bool) -> Result {
    let bar = output::progress(options.cases * FORMATS.len() as u64, "random cases");
    let mut formats = vec![];
    if !json {
        output::text(trial_head());
    }
    for widths in FORMATS {
        let format = Format::fitted(&widths)?;
        let report = trial::run(&format, options.cases, options.seed, false, |n| bar.inc(n));
        if !json {
            bar.suspend(|| output::text(trial_line(&report)));
        }
        formats.push(report);
    }
    bar.finish_and_clear();
    let trial = Trial {
        seed: options.seed,
        cases: options.cases,
        violations: formats.iter().map(|f| f.tally.violations).sum(),
        formats,
    };
    if json {
        output::json(&trial);
    }
    verdict::of_bounds(options.seed, &trial.formats)
}

/// The table's head: one column for each bound, with the worst and the mean ratio of an error to it.
fn trial_head() -> String {
    let terms = Term::ALL.map(|(_, name)| name);
    format!(
        "| W, g1:g2 | cases | comparisons | in integers | violations | {} |\n|{}",
        output::joined(terms, " | "),
        "---|".repeat(5 + Term::ALL.len())
    )
}

fn trial_line(report: &TrialReport) -> String {
    let ratios = report.terms.iter().map(|t| match t.fared.bound {
        0.0 => "-".into(),
        _ => format!("{:.4}, {:.2}", t.fared.tightness, t.fared.mean),
    });
    format!(
        "| {} | {} | {} | {} | {} | {} |",
        report.label(),
        report.cases,
        report.tally.comparisons,
        report.tally.decided_exactly,
        report.tally.violations,
        output::joined(ratios, " | ")
    )
}

/// One scene at one size in one format; the keys are stable.
#[derive(Serialize)]
struct Row {
    scene: PathBuf,
    #[serde(flatten)]
    headroom: Headroom,
}

/// All scenes, sizes and formats; the keys are stable.
#[derive(Serialize)]
struct Table {
    summary: Vec<Summary>,
    scenes: Vec<Row>,
}

fn show_headroom(options: &Bounds, json: bool) -> Result {
    let steps = options.scenes.len() * options.sizes.len() * options.formats.len();
    let bar = output::progress(steps as u64, "scenes, sizes, formats");
    let mut rows = vec![];
    for path in &options.scenes {
        let file = molecules::read_scene(path)?;
        for &size in &options.sizes {
            for &format in &options.formats {
                rows.push(row(path, &file, size, format)?);
                bar.inc(1);
            }
        }
    }
    bar.finish_and_clear();
    let all: Vec<Headroom> = rows.iter().map(|r| r.headroom.clone()).collect();
    let table = Table {
        summary: summaries(&all),
        scenes: rows,
    };
    let page = page(&table)?;
    output::report(json, &table, |_| output::text(page.trim_end()));
    Ok(())
}

fn row(path: &Path, file: &SceneFile, size: Size, format: u32) -> Result<Row> {
    let (_, prepared) = frame_in(file, Some(size), Format::new(format)?)?;
    if prepared.quadrics().next().is_none() {
        let problem = "no object is drawn by a quadric or patch processor, the ones whose roundings are bounded";
        return Err(Failure::at(path, problem));
    }
    Ok(Row {
        scene: path.to_path_buf(),
        headroom: headroom(&prepared),
    })
}

/// The tables with the names of the scenes.
fn page(table: &Table) -> Result<String, DrawError> {
    let stems = table.scenes.iter().map(|row| row.scene.file_stem());
    let names = stems.map(|stem| stem.unwrap_or_default().to_string_lossy());
    let names = json!({ "names": names.collect::<Vec<_>>() });
    text("no tables", include_str!("bounds.md"), with(table, names))
}
