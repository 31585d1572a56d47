//! The resource table of the documentation: which syntheses it is made of, and its text.

mod agreement;
mod markdown;
mod picture;
mod rows;
#[cfg(test)]
mod tests;
mod transistors;

use crate::cache::digest;
use crate::error::SynthError;
use crate::flow::synthesise;
use crate::report::SynthReport;
use imogene_rtl::emit::emit;
use rayon::prelude::*;

pub use agreement::disagreements;
pub use markdown::PICTURE;
pub use rows::{Row, Section, Table, rows, select};

/// Synthesises all rows; `done` is called after each.
///
/// # Errors
///
/// When one of the syntheses fails.
pub fn make(rows: &[Row], done: impl Fn(&Row) + Sync) -> Result<Table, SynthError> {
    let digest = verilog_digest(rows)?;
    let reports: Vec<(Row, SynthReport)> = rows
        .par_iter()
        .map(|row| {
            let report = synthesise(&row.request, row.target, &row.options)?;
            done(row);
            Ok((*row, report))
        })
        .collect::<Result<_, SynthError>>()?;
    Ok(Table {
        rows: reports,
        digest,
    })
}

impl Table {
    /// The table as Markdown.
    pub fn markdown(&self) -> String {
        markdown::write(self)
    }

    /// The networks over their rows per stage as an SVG picture; none without a clock of each.
    ///
    /// # Errors
    ///
    /// When it cannot be drawn.
    pub fn picture(&self) -> Result<Option<String>, SynthError> {
        picture::draw(self)
    }
}

/// Whether a written table was made of the Verilog that is emitted now. Needs no tool.
///
/// # Errors
///
/// When a unit of the table cannot be emitted.
pub fn is_current(text: &str) -> Result<bool, SynthError> {
    Ok(text.contains(&verilog_digest(&rows())?))
}

/// Digest of the Verilog of all rows.
fn verilog_digest(rows: &[Row]) -> Result<String, SynthError> {
    let mut all = String::new();
    for row in rows {
        all += &digest(&emit(&row.request)?.bundle());
        all += "\n";
    }
    Ok(digest(&all))
}
