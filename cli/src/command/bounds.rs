//! `imogene bounds`.

use super::frame_scene;
use crate::arguments::{Bounds, Size};
use crate::failure::Failure;
use crate::output;
use imogene_models::check::headroom::{Headroom, headroom};
use imogene_models::check::trial::{self, FORMATS, TrialReport, format_of};
use imogene_models::scene::SceneFile;
use serde::Serialize;
use std::path::{Path, PathBuf};

const TRIAL_HEAD: &str = "\
| bound | comparisons | worst error / bound | mean error / bound | error | bound there |
|---|---|---|---|---|---|";

const HEADROOM_HEAD: &str = "\
| scene | size | depth word | pixels | silhouette errors | ties | depth max lsb | depth rms lsb | guard bits derived | confirmed | errors with one less |
|---|---|---|---|---|---|---|---|---|---|---|";

/// Tries the bounds on random cases, or shows the headroom of scenes.
pub fn run(options: &Bounds, json: bool) -> Result<(), Failure> {
    if options.scenes.is_empty() {
        try_bounds(options, json)
    } else {
        show_headroom(options, json)
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

fn try_bounds(options: &Bounds, json: bool) -> Result<(), Failure> {
    let bar = output::progress(options.cases * FORMATS.len() as u64, "random cases");
    let mut formats = vec![];
    for shape in FORMATS {
        let format = format_of(shape).map_err(Failure::input)?;
        let report = trial::run(&format, options.cases, options.seed, false, |n| bar.inc(n));
        if !json {
            bar.suspend(|| describe(&report));
        }
        formats.push(report);
    }
    bar.finish_and_clear();
    let trial = Trial {
        seed: options.seed,
        cases: options.cases,
        violations: formats.iter().map(|f| f.violations).sum(),
        formats,
    };
    if json {
        output::json(&trial);
    }
    verdict(&trial)
}

fn describe(report: &TrialReport) {
    output::text(format!(
        "\ndepth word {}, guard bits {}:{}: {} cases, {} pixels, {} comparisons ({} in exact integers): {} violations; \
         {} pixels with another sign of f2, {} normals undetermined",
        report.depth,
        report.guard_linear,
        report.guard_quadratic,
        report.cases,
        report.pixels,
        report.comparisons,
        report.decided_exactly,
        report.violations,
        report.sign_differences,
        report.normals_undetermined
    ));
    output::text(TRIAL_HEAD);
    for term in report.terms.iter().filter(|t| t.fared.bound > 0.0) {
        let f = &term.fared;
        output::text(format!(
            "| {} | {} | {:.4} | {:.4} | {:.4e} | {:.4e} |",
            term.term.name(),
            f.comparisons,
            f.tightness,
            f.mean,
            f.observed,
            f.bound
        ));
    }
}

fn verdict(trial: &Trial) -> Result<(), Failure> {
    if trial.violations == 0 {
        return Ok(());
    }
    let mut text = format!("{} errors are beyond their bounds", trial.violations);
    for format in &trial.formats {
        for v in &format.first_violations {
            text += &format!(
                "\n  depth word {}, guard bits {}:{}, case {} of seed {}, pixel {:?}: {} {:e} beyond {:e}",
                format.depth,
                format.guard_linear,
                format.guard_quadratic,
                v.case,
                trial.seed,
                v.pixel,
                v.term.name(),
                v.observed,
                v.bound
            );
        }
    }
    Err(Failure::Check(text))
}

/// One scene at one size in one format; the keys are stable.
#[derive(Serialize)]
struct Row {
    scene: PathBuf,
    #[serde(flatten)]
    headroom: Headroom,
}

fn show_headroom(options: &Bounds, json: bool) -> Result<(), Failure> {
    let steps = options.scenes.len() * options.sizes.len() * options.formats.len();
    let bar = output::progress(steps as u64, "scenes, sizes, formats");
    let mut rows = vec![];
    for path in &options.scenes {
        let file = SceneFile::read(path).map_err(Failure::input)?;
        for &size in &options.sizes {
            for &format in &options.formats {
                rows.push(row(path, &file, size, format)?);
                bar.inc(1);
            }
        }
    }
    bar.finish_and_clear();
    if json {
        output::json(&rows);
        return Ok(());
    }
    output::text(HEADROOM_HEAD);
    for row in &rows {
        output::text(line(row));
    }
    Ok(())
}

fn row(path: &Path, file: &SceneFile, size: Size, format: u32) -> Result<Row, Failure> {
    let (_, prepared) = frame_scene(file, Some(size), format)?;
    Ok(Row {
        scene: path.to_path_buf(),
        headroom: headroom(&prepared),
    })
}

fn line(row: &Row) -> String {
    let h = &row.headroom;
    let name = row.scene.file_stem().unwrap_or_default();
    format!(
        "| {} | {}x{} | {} | {} | {} | {} | {:.1} | {:.2} | {} | {} | {} |",
        name.display(),
        h.width,
        h.height,
        h.depth_word,
        h.pixels,
        h.silhouette_errors,
        h.ties,
        h.depth_max_lsb,
        h.depth_rms_lsb,
        h.derived,
        h.confirmed.map_or("-".into(), |bits| bits.to_string()),
        h.errors_with_one_less
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use imogene_models::check::trial::{Term, Violation};

    #[test]
    fn an_error_beyond_its_bound_fails_the_check_and_is_named() {
        let format = format_of(FORMATS[4]).unwrap();
        let mut report = trial::run(&format, 1, 1, false, |_| ());
        report.violations = 1;
        report.first_violations = vec![Violation {
            term: Term::Depth,
            case: 17,
            pixel: (3, 4),
            observed: 2.5,
            bound: 2.0,
        }];
        let trial = Trial {
            seed: 9,
            cases: 1,
            violations: 1,
            formats: vec![report],
        };
        let Err(Failure::Check(message)) = verdict(&trial) else {
            panic!("not a failed check");
        };
        for part in [
            "depth word 20, guard bits 2:4",
            "case 17 of seed 9",
            "(3, 4)",
            "2.5e0 beyond 2e0",
        ] {
            assert!(message.contains(part), "no '{part}' in: {message}");
        }
    }
}
