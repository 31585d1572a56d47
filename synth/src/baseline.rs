//! Syntheses against the figures of a resource table.

use crate::cache::Cache;
use crate::error::SynthError;
use crate::flow::synthesise;
use crate::regression::{Change, Tolerance, Verdict, compare, worst};
use crate::report::Figures;
use crate::table::{Measured, Row, Table};
use crate::tools::{Programs, listed};
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;

/// One row beside its baseline.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RowCheck {
    /// Unit.
    pub unit: String,
    /// Depth word and parameters.
    pub parameters: BTreeMap<String, usize>,
    /// Target.
    pub target: String,
    /// Whether the Verilog is that of the baseline.
    pub is_same_verilog: bool,
    /// Every figure.
    pub changes: Vec<Change>,
    /// The worst of them.
    pub verdict: Verdict,
}

/// How rows are checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckOptions {
    /// What may be worse.
    pub tolerance: Tolerance,
    /// Whether the clock is measured.
    pub clock: bool,
    /// Whether kept results count.
    pub cache: Cache,
}

/// Synthesises rows and compares them with their baseline; `done` is called after each. Fails when the baseline lacks
/// a row or was made with other tools, which is found before anything runs, or a synthesis fails.
pub fn check(
    rows: &[Row],
    baseline: &Table,
    options: &CheckOptions,
    done: impl Fn() + Sync,
) -> Result<Vec<RowCheck>, SynthError> {
    let pair = |row| Ok((row, comparable(row, baseline)?));
    let pairs: Vec<(&Row, &Measured)> = rows.iter().map(pair).collect::<Result<_, SynthError>>()?;
    let checked = |(row, known)| {
        let check = check_row(row, known, options)?;
        done();
        Ok(check)
    };
    pairs.into_par_iter().map(checked).collect()
}

/// The baseline of a row, if the tools are those it was made with.
fn comparable<'a>(row: &Row, baseline: &'a Table) -> Result<&'a Measured, SynthError> {
    let none = || SynthError::NoBaseline(row.name());
    let known = baseline.find(row).ok_or_else(none)?;
    let here = Programs::find(row.target)?.versions();
    let synthesis = row.synthesis();
    if known.tools == here && known.synthesis == synthesis {
        return Ok(known);
    }
    Err(SynthError::OtherTools {
        row: row.name(),
        baseline: format!("{} and `{}`", listed(&known.tools), known.synthesis),
        here: format!("{} and `{synthesis}`", listed(&here)),
    })
}

fn check_row(row: &Row, known: &Measured, options: &CheckOptions) -> Result<RowCheck, SynthError> {
    let seeds = if options.clock { row.seeds } else { 0 };
    let report = synthesise(&row.request, row.target, seeds, options.cache)?;
    let figures = Figures::from(&report);
    let (before, now) = ((known.latency, &known.figures), (report.latency, &figures));
    let changes = compare(before, now, seeds > 0, options.tolerance);
    Ok(RowCheck {
        is_same_verilog: report.verilog == known.verilog,
        verdict: worst(&changes),
        unit: report.unit,
        parameters: report.parameters,
        target: report.target,
        changes,
    })
}
