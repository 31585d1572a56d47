//! `imogene terrain`.

use crate::arguments::Terrain;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_import::terrain::heights_text;
use imogene_import::terrain::random_field::{FieldOptions, field};
use serde::Serialize;
use std::path::PathBuf;

/// What was made; the keys are stable.
#[derive(Serialize)]
struct TerrainReport {
    side: usize,
    lowest: f64,
    highest: f64,
    most_vertices: usize,
    most_edges: usize,
    files: Vec<PathBuf>,
}

pub fn run(options: &Terrain, json: bool) -> Result {
    let distance = options.node_distance;
    if !(distance > 0.0 && distance <= 1e6) {
        return Err(Failure::Input(format!(
            "a node distance of {distance}; more than 0 and up to 1000000 is accepted"
        )));
    }
    let asked = FieldOptions {
        levels: options.levels,
        smoothness: options.roughness,
        relief: options.relief,
        seed: options.seed,
    };
    let made = field(&asked).map_err(Failure::Input)?;
    let text = heights_text(&made, &asked, distance);
    output::write_text(&options.output, &text)?;
    let heights = || made.heights.iter().copied();
    let report = TerrainReport {
        side: made.side,
        lowest: heights().fold(f64::INFINITY, f64::min),
        highest: heights().fold(f64::NEG_INFINITY, f64::max),
        most_vertices: made.most_vertices,
        most_edges: made.most_edges,
        files: vec![options.output.clone()],
    };
    output::report(json, &report, |report| {
        let (side, path) = (report.side, options.output.display());
        let (lowest, highest) = (report.lowest, report.highest);
        output::text(format!(
            "{side} x {side} nodes, heights {lowest:.1} to {highest:.1}; wrote {path}"
        ));
    });
    Ok(())
}
