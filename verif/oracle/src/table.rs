//! Comparisons of many scenes as a table.

use crate::compare::Comparison;
use crate::run::Compared;
use serde::Serialize;
use std::fmt::Write;

/// One scene.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Its file.
    pub scene: String,
    /// Columns.
    pub width: u32,
    /// Lines.
    pub height: u32,
    /// Seconds of the tracer.
    pub trace_seconds: f64,
    /// Why the preparation refuses it, if it does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<String>,
    /// The comparison else.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub comparison: Option<Comparison>,
}

impl Row {
    /// A scene that was compared, or that has no golden picture, for this reason.
    pub fn new(scene: String, size: (u32, u32), found: Result<&Compared, String>) -> Row {
        Row {
            scene,
            width: size.0,
            height: size.1,
            trace_seconds: found.as_ref().map_or(0.0, |found| found.trace_seconds),
            comparison: found.as_ref().ok().map(|found| found.comparison.clone()),
            refused: found.err(),
        }
    }

    /// True unless something differs that must not.
    pub fn holds(&self) -> bool {
        self.comparison.as_ref().is_none_or(Comparison::holds)
    }
}

/// The table (Markdown).
pub fn table(rows: &[Row]) -> String {
    let mut text = String::from(
        "| scene | size | covered | solved exactly | band | differ in it | tied | announced | differ outside | depth error, words | of its bound | beyond it | colours | known to 4 levels | off, levels | beyond |\n\
         |---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    for row in rows {
        let (scene, size) = (&row.scene, format!("{} x {}", row.width, row.height));
        let written = match &row.comparison {
            None => writeln!(
                text,
                "| {scene} | {size} | refused | | | | | | | | | | | | | |"
            ),
            Some(c) => writeln!(
                text,
                "| {scene} | {size} | {} | {} | {} | {} | {} | {} | {} | {:.2} | {:.0} % | {} | {} | {} | {:.2} | {} |",
                c.covered,
                c.solved_exactly,
                c.band,
                c.differences_inside,
                c.tied,
                c.announced,
                c.differences_outside,
                c.depth_error,
                100.0 * c.depth_ratio,
                c.depths_beyond_bound,
                c.colours,
                c.colours_known,
                c.colour_error,
                c.colours_beyond_bound
            ),
        };
        written.expect("a string takes all");
    }
    text
}
