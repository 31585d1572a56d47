//! `imogene cracks`.

use super::{frame_in, read_scene, render::golden_frame};
use crate::arguments::Cracks;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_files::text::counted;
use imogene_oracle::crack::{Buffers, Crack, Rule, cracks, mark_openings, two_pixels};
use imogene_oracle::inject::{Breakable, Score, Sort};
use imogene_oracle::paint;
use imogene_oracle::plot::plot;
use imogene_oracle::trace::Tracer;
use serde::Serialize;

/// Minimum distances that are tried with cracks made on purpose, as powers of two of the one asked for.
const POWERS: std::ops::RangeInclusive<i32> = -2..=6;

/// What was found; the keys are stable.
#[derive(Serialize)]
struct CrackReport {
    width: u32,
    height: u32,
    min_distance: f64,
    crack_width: usize,
    cracks: Vec<Crack>,
    scores: Vec<ScoreRow>,
}

#[derive(Serialize)]
struct ScoreRow {
    #[serde(flatten)]
    score: Score,
    recall: f64,
    precision: f64,
}

pub fn run(options: &Cracks, json: bool) -> Result {
    let file = read_scene(&options.scene.scene, &options.scene.view)?;
    let (framed, prepared) = frame_in(&file, options.scene.size, options.scene.format()?)?;
    let least = options.min_distance;
    let rule = Rule {
        min_distance: least.unwrap_or_else(|| two_pixels(file.active(), prepared.height as usize)),
        width: usize::from(options.width),
    };
    let frame = golden_frame(&prepared);
    let z_max = prepared.format.z_max();
    let mut found = cracks(&Buffers::new(&frame, &framed.range, z_max), &rule);
    if found.iter().any(|crack| !crack.notch) {
        let tracer = Tracer::new(&file, &framed.range, prepared.width, prepared.height);
        mark_openings(&mut found, &tracer);
    }
    let mut files = output::files();
    if let Some(path) = &options.output {
        let flagged = found.iter().map(|c| c.y * frame.width + c.x);
        let rgb = paint::pixels(&frame, z_max, flagged, paint::FORBIDDEN, true);
        output::add_picture(&mut files, path, [frame.width, frame.height], &rgb)?;
    }
    let scores = options.inject.map_or(vec![], |count| {
        let breakable = Breakable::new(&prepared);
        let sorts = [Sort::Points, Sort::Lines, Sort::Joints];
        let all = sorts.map(|sort| POWERS.map(move |power| (sort, power)));
        let score = |(sort, power)| {
            let rule = Rule {
                min_distance: rule.min_distance * 2f64.powi(power),
                ..rule
            };
            let (range, count) = (&framed.range, count as usize);
            let score = breakable.score(range, sort, count, options.seed, &rule);
            ScoreRow {
                recall: score.recall(),
                precision: score.precision(),
                score,
            }
        };
        all.into_iter().flatten().map(score).collect()
    });
    if let Some(path) = &options.plot {
        let scores: Vec<Score> = scores.iter().map(|row| row.score).collect();
        files.add_text(path, &plot(&scores)?)?;
    }
    let report = CrackReport {
        width: prepared.width,
        height: prepared.height,
        min_distance: rule.min_distance,
        crack_width: rule.width,
        cracks: found,
        scores,
    };
    output::written(json, &report, files.finish()?, include_str!("cracks.md"))?;
    if options.inject.is_some() {
        // With cracks made on purpose the check is that every deep one is found.
        let missed = |s: &ScoreRow| s.score.deep - s.score.deep_found;
        let missed: usize = report.scores.iter().map(missed).sum();
        return Failure::unless(missed == 0, || {
            format!("{missed} deep cracks were not found")
        });
    }
    let open = report.cracks.iter().filter(|c| c.is_of_the_drawing());
    let pixels = open.count();
    Failure::unless(pixels == 0, || {
        format!("cracks: {}", counted(pixels, "pixel"))
    })
}
