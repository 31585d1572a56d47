//! The figures of the resource table as a file, and syntheses against it.

use crate::cache::{Cache, digest};
use crate::error::SynthError;
use crate::figures::Figures;
use crate::flow::{parameters, synthesise_with, tools};
use crate::regression::{Change, Tolerance, Verdict, compare, worst};
use crate::report::SynthReport;
use crate::table::{Row, Section, Table, rows};
use imogene_contract::Unit;
use imogene_rtl::emit::emit;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// Version of the file.
const VERSION: u32 = 1;

/// Figures to compare with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Baseline {
    version: u32,
    /// Digest of the Verilog of all rows, as it stands on the page of the table.
    pub verilog: String,
    /// The rows of the table, in its order.
    pub rows: Vec<BaselineRow>,
}

/// One row of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BaselineRow {
    /// Where it is shown.
    pub section: Section,
    /// Unit.
    pub unit: String,
    /// Depth word and parameters.
    pub parameters: BTreeMap<String, usize>,
    /// Target.
    pub target: String,
    /// Seeds of place and route.
    pub seeds: usize,
    /// Tools and versions.
    pub tools: BTreeMap<String, String>,
    /// Latency in clocks.
    pub latency: usize,
    /// Resources and clock.
    pub figures: Figures,
    /// Digest of the Verilog.
    pub verilog: String,
}

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

/// Most bytes of a baseline, which has tens of thousands.
const MAX_BYTES: u64 = 16 << 20;

impl Baseline {
    /// The figures of a table.
    pub fn of(table: &Table) -> Self {
        let rows = table.rows().iter();
        Self {
            version: VERSION,
            verilog: table.digest().to_owned(),
            rows: rows
                .map(|(row, report)| BaselineRow::of(row, report))
                .collect(),
        }
    }

    /// Reads a file.
    ///
    /// # Errors
    ///
    /// When there is none, or it is not a baseline of this version.
    pub fn read(path: &Path) -> Result<Self, SynthError> {
        let bad = |problem: String| SynthError::Baseline {
            path: path.display().to_string(),
            problem,
        };
        let text =
            imogene_files::read_text(path, MAX_BYTES).map_err(|error| match error.kind() {
                std::io::ErrorKind::NotFound => {
                    bad("there is no such file; `imogene synth --table` writes it".into())
                }
                _ => bad(error.to_string()),
            })?;
        let baseline: Self = serde_json::from_str(&text)
            .map_err(|error| bad(format!("{error}; `imogene synth --table` writes it again")))?;
        if baseline.version == VERSION {
            Ok(baseline)
        } else {
            let found = baseline.version;
            Err(bad(format!("version {found}, expected {VERSION}")))
        }
    }

    /// The text of its file; the same for the same figures.
    pub fn json(&self) -> String {
        let text = serde_json::to_string_pretty(self);
        text.expect("a baseline has no unserialisable keys") + "\n"
    }

    /// What it has of a row.
    pub fn find(&self, row: &Row) -> Option<&BaselineRow> {
        self.rows.iter().find(|known| known.is_of(row))
    }

    /// Whether it has any row of a unit.
    pub fn has(&self, unit: Unit) -> bool {
        self.rows.iter().any(|known| known.unit == unit.name())
    }

    /// Where it differs from the rows and the Verilog of today; nothing if it is current. Needs no tool.
    ///
    /// # Errors
    ///
    /// When a unit of the table cannot be emitted.
    pub fn out_of_date(&self) -> Result<Vec<String>, SynthError> {
        let today = rows();
        let mut problems = Vec::new();
        for row in &today {
            let name = name(&parameters(&row.request), row);
            match self.find(row) {
                None => problems.push(format!("{name}: no row")),
                Some(known) if known.verilog != digest(&emit(&row.request)?.bundle()) => {
                    problems.push(format!("{name}: other Verilog"));
                }
                Some(_) => {}
            }
        }
        if self.rows.len() != today.len() {
            problems.push(format!("{} rows of {}", self.rows.len(), today.len()));
        }
        Ok(problems)
    }
}

impl BaselineRow {
    fn of(row: &Row, report: &SynthReport) -> Self {
        Self {
            section: row.section,
            unit: report.unit.clone(),
            parameters: report.parameters.clone(),
            target: report.target.clone(),
            seeds: row.options.seeds,
            tools: report.tools.clone(),
            latency: report.latency,
            figures: Figures::from(report),
            verilog: report.verilog.clone(),
        }
    }

    fn is_of(&self, row: &Row) -> bool {
        self.section == row.section
            && self.unit == row.request.unit.name()
            && self.target == row.target.name()
            && self.seeds == row.options.seeds
            && self.parameters == parameters(&row.request)
    }
}

/// Synthesises rows and compares them with their baseline; `done` is called after each.
///
/// # Errors
///
/// When the baseline lacks a row or was made with other tools, which is found before anything runs, or a synthesis
/// fails.
pub fn check(
    rows: &[Row],
    baseline: &Baseline,
    options: &CheckOptions,
    done: impl Fn() + Sync,
) -> Result<Vec<RowCheck>, SynthError> {
    let known: Vec<&BaselineRow> = rows
        .iter()
        .map(|row| comparable(row, baseline))
        .collect::<Result<_, _>>()?;
    let pairs: Vec<(&Row, &BaselineRow)> = rows.iter().zip(known).collect();
    pairs
        .par_iter()
        .map(|(row, known)| {
            let check = check_row(row, known, options)?;
            done();
            Ok(check)
        })
        .collect()
}

/// The baseline of a row, if the tools are those it was made with.
fn comparable<'a>(row: &Row, baseline: &'a Baseline) -> Result<&'a BaselineRow, SynthError> {
    let name = || name(&parameters(&row.request), row);
    let known = baseline
        .find(row)
        .ok_or_else(|| SynthError::NoBaseline { row: name() })?;
    let here = tools(row.target)?;
    if known.tools == here {
        return Ok(known);
    }
    let list = |tools: &BTreeMap<String, String>| {
        let tools = tools
            .iter()
            .map(|(tool, version)| format!("{tool} {version}"));
        tools.collect::<Vec<_>>().join(", ")
    };
    Err(SynthError::OtherTools {
        row: name(),
        baseline: list(&known.tools),
        here: list(&here),
    })
}

fn check_row(
    row: &Row,
    known: &BaselineRow,
    options: &CheckOptions,
) -> Result<RowCheck, SynthError> {
    let mut flow = row.options;
    if !options.clock {
        flow.seeds = 0;
    }
    let report = synthesise_with(&row.request, row.target, &flow, options.cache)?;
    let changes = compare(
        (known.latency, &known.figures),
        (report.latency, &Figures::from(&report)),
        flow.seeds > 0,
        options.tolerance,
    );
    Ok(RowCheck {
        is_same_verilog: report.verilog == known.verilog,
        verdict: worst(&changes),
        unit: report.unit,
        parameters: report.parameters,
        target: report.target,
        changes,
    })
}

fn name(parameters: &BTreeMap<String, usize>, row: &Row) -> String {
    let parameters: Vec<String> = parameters
        .iter()
        .map(|(option, value)| format!("--{option} {value}"))
        .collect();
    format!(
        "{} {} for {}",
        row.request.unit.name(),
        parameters.join(" "),
        row.target.name()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Baseline, SynthError> {
        let file = tempfile::NamedTempFile::new().expect("a temporary file");
        std::fs::write(file.path(), text).expect("a file");
        Baseline::read(file.path())
    }

    fn baseline() -> Baseline {
        let row = &rows()[0];
        Baseline {
            version: VERSION,
            verilog: "abc".into(),
            rows: vec![BaselineRow {
                section: row.section,
                unit: row.request.unit.name().into(),
                parameters: parameters(&row.request),
                target: row.target.name().into(),
                seeds: row.options.seeds,
                tools: BTreeMap::from([("yosys".into(), "0.1".into())]),
                latency: 1,
                figures: Figures::default(),
                verilog: "def".into(),
            }],
        }
    }

    #[test]
    fn what_is_written_is_read() {
        let written = baseline();
        assert_eq!(read(&written.json()).expect("a baseline"), written);
    }

    #[test]
    fn a_file_that_is_not_there_or_none_is_one_message() {
        let missing = Baseline::read(Path::new("no/resources.json")).expect_err("no file");
        let message = missing.to_string();
        assert!(
            message.contains("no/resources.json") && message.contains("imogene synth --table"),
            "{message}"
        );
        let whole = baseline().json();
        for text in ["", "{", "[1]", &whole[..whole.len() / 2]] {
            let message = read(text).expect_err("no baseline").to_string();
            assert!(message.contains("line "), "{message}");
        }
        let misspelt = whole.replace("\"lut\"", "\"luts\"");
        let message = read(&misspelt).expect_err("no baseline").to_string();
        assert!(message.contains("luts"), "{message}");
        let newer = whole.replace("\"version\": 1", "\"version\": 2");
        let message = read(&newer).expect_err("no baseline").to_string();
        assert!(message.contains("version 2"), "{message}");
    }

    #[test]
    fn a_row_is_found_by_all_that_it_is() {
        let known = baseline();
        let mut row = rows()[0];
        assert_eq!(known.find(&row), Some(&known.rows[0]));
        row.options.seeds += 1;
        assert_eq!(known.find(&row), None);
        row = rows()[0];
        row.request.depth_word = 16;
        assert_eq!(known.find(&row), None);
        assert_eq!(known.find(&rows()[1]), None);
    }

    #[test]
    fn a_baseline_of_other_verilog_and_too_few_rows_is_out_of_date() {
        let problems = baseline().out_of_date().expect("every unit is emitted");
        assert!(problems[0].contains("other Verilog"), "{problems:?}");
        assert_eq!(problems.len(), rows().len() + 1);
    }

    #[test]
    fn a_row_that_is_missing_is_an_error_before_any_tool_runs() {
        let options = CheckOptions {
            tolerance: Tolerance::default(),
            clock: true,
            cache: Cache::Use,
        };
        let last = *rows().last().expect("rows");
        let error = check(&[last], &baseline(), &options, || ()).expect_err("no baseline");
        assert!(matches!(error, SynthError::NoBaseline { .. }), "{error}");
    }
}
