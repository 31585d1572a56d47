//! `imogene shading`.

use super::{frame_in, read_scene};
use crate::arguments::{Shading, View};
use crate::failure::{Failure, Result};
use crate::output;
use imogene::verdict;
use imogene_golden::format::Format;
use imogene_golden::machine::shader::ShaderWidths;
use imogene_studies::shading_trial::{
    LevelErrors, ShadingErrors, SphereErrors, errors, sphere_errors,
};
use serde::Serialize;
use std::path::PathBuf;

const HEAD: &str = "\
| widths | multiplier bits, one light | four lights | cases | searched | off by 1 | beyond 1 | max error, random | max error, searched |
|---|---|---|---|---|---|---|---|---|";

const SPHERE_HEAD: &str = "\
| scene | side | table: mean | of 99.9 % | greatest | all: mean | of 99.9 % | greatest |
|---|---|---|---|---|---|---|---|";

/// Bits that are taken of each width by the sweep.
const MOST_LESS: u32 = 4;

/// One set of widths; the keys are stable.
#[derive(Serialize)]
struct Row {
    name: String,
    widths: ShaderWidths,
    multiplier_bits: u32,
    multiplier_bits_of_4_lights: u32,
    #[serde(flatten)]
    errors: ShadingErrors,
}

/// All sets of widths; the keys are stable.
#[derive(Serialize)]
struct Table {
    seed: u64,
    rows: Vec<Row>,
}

/// Compares the shading processor with its formula on random cases, or lit-sphere shading with both on scenes.
pub fn run(options: &Shading, json: bool) -> Result {
    if !options.scenes.is_empty() {
        return on_scenes(&options.scenes, options.nearest, json);
    }
    let widths = ShaderWidths::default();
    let mut sets = vec![("of the hardware".to_string(), widths)];
    if options.sweep {
        for (name, width) in widths.named() {
            let called = |less| format!("{name} {width} - {less}");
            let shorter = |less| (called(less), widths.shorter(name, less));
            sets.extend((1..=MOST_LESS).map(shorter));
        }
    }
    let bar = output::progress(options.cases * sets.len() as u64, "random cases");
    let mut rows = vec![];
    if !json {
        output::text(HEAD);
    }
    for (name, widths) in sets {
        let row = Row {
            name,
            widths,
            multiplier_bits: widths.multiplier_bits(1),
            multiplier_bits_of_4_lights: widths.multiplier_bits(4),
            errors: errors(&widths, options.cases, options.seed, |n| bar.inc(n)),
        };
        if !json {
            bar.suspend(|| output::text(line(&row)));
        }
        rows.push(row);
    }
    bar.finish_and_clear();
    let seed = options.seed;
    let table = Table { seed, rows };
    if json {
        output::json(&table);
    }
    verdict::of_levels(&table.rows[0].errors)
}

/// Lit-sphere shading of a scene; the keys are stable.
#[derive(Serialize)]
struct SphereScene {
    scene: PathBuf,
    materials: usize,
    tables: Vec<SphereErrors>,
}

fn on_scenes(paths: &[PathBuf], nearest: bool, json: bool) -> Result {
    let scene = |path: &PathBuf| {
        let file = read_scene(path, &View::default())?;
        let (framed, prepared) = frame_in(&file, None, Format::BASE)?;
        let tables = sphere_errors(&framed, &prepared, nearest);
        Ok(SphereScene {
            scene: path.clone(),
            materials: framed.materials.len(),
            tables: tables.map_err(Failure::in_file(path))?,
        })
    };
    let scenes: Vec<SphereScene> = paths.iter().map(scene).collect::<Result<_>>()?;
    output::report(json, &scenes, |scenes| {
        let mut lines = vec![SPHERE_HEAD.to_owned()];
        for scene in scenes {
            let row = |errors: &SphereErrors| {
                let figures = |e: &LevelErrors| {
                    format!("{:.2} | {} | {}", e.mean, e.most_of_1000, e.greatest)
                };
                let (side, name) = (errors.side, scene.scene.display());
                let [table, all] = [&errors.table, &errors.all].map(figures);
                format!("| {name} | {side} | {table} | {all} |")
            };
            lines.extend(scene.tables.iter().map(row));
        }
        output::text(lines.join("\n"));
    });
    Ok(())
}

fn line(row: &Row) -> String {
    let e = &row.errors;
    format!(
        "| {} | {} | {} | {} | {} | {:.3} % | {} | {:.3} | {:.3} |",
        row.name,
        row.multiplier_bits,
        row.multiplier_bits_of_4_lights,
        e.cases,
        e.searched,
        100.0 * e.differing as f64 / e.levels as f64,
        e.beyond,
        e.random_error,
        e.error
    )
}
