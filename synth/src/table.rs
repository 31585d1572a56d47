//! The resource table of the documentation: its rows, its file of figures, its page.

mod markdown;
mod picture;
pub mod rows;
pub mod transistors;

use crate::cache::{Cache, digest};
use crate::error::SynthError;
use crate::flow::{parameters, synthesise};
use crate::report::{CriticalPath, Figures, SynthReport};
use crate::target::Target;
use crate::tools::Programs;
use imogene_contract::Unit;
use imogene_rtl::emit::emit;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

pub use rows::{Row, Section, rows, select};

/// Where the picture lies, seen from the page.
pub const PICTURE: &str = "images/rows-per-stage.svg";

/// Version of the file.
const VERSION: u32 = 3;

/// Most bytes of the file, which has tens of thousands.
const MAX_BYTES: u64 = 16 << 20;

/// The table with its figures, as its file has it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    version: u32,
    /// Digest of the Verilog of all rows.
    pub verilog: String,
    /// Its rows, in their order.
    pub rows: Vec<Measured>,
}

/// One row with its figures.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Measured {
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
    /// Commands of synthesis, and options of place and route.
    pub synthesis: String,
    /// Latency in clocks.
    pub latency: usize,
    /// Resources and clock.
    pub figures: Figures,
    /// The path that limits the clock of the median seed.
    pub slowest_path: Option<CriticalPath>,
    /// Digest of the Verilog.
    pub verilog: String,
}

/// Measures all rows; `done` is called after each. A row whose Verilog and tools are those of `known` is taken from
/// it, unless kept results do not count. Fails when one of the syntheses fails.
pub fn make(
    rows: &[Row],
    known: Option<&Table>,
    cache: Cache,
    done: impl Fn(&Row) + Sync,
) -> Result<Table, SynthError> {
    let known = known.filter(|_| cache == Cache::Use);
    let rows = rows.par_iter().map(|row| {
        let measured = match known.map_or(Ok(None), |known| known.current(row))? {
            Some(measured) => measured.clone(),
            None => Measured::of(row, synthesise(&row.request, row.target, row.seeds, cache)?),
        };
        done(row);
        Ok(measured)
    });
    Ok(Table::of(rows.collect::<Result<_, SynthError>>()?))
}

impl Table {
    /// A table of these rows.
    pub fn of(rows: Vec<Measured>) -> Self {
        let all: String = rows.iter().map(|row| row.verilog.clone() + "\n").collect();
        Self {
            version: VERSION,
            verilog: digest(&all),
            rows,
        }
    }

    /// Reads its file. Fails when there is none, or it is no table of this version.
    pub fn read(path: &Path) -> Result<Self, SynthError> {
        let bad = |problem: String| SynthError::Baseline(path.display().to_string(), problem);
        let text =
            imogene_files::read_text(path, MAX_BYTES).map_err(|error| match error.kind() {
                std::io::ErrorKind::NotFound => {
                    bad("there is no such file; `imogene synth --table` writes it".into())
                }
                _ => bad(error.to_string()),
            })?;
        let table: Self = serde_json::from_str(&text)
            .map_err(|error| bad(format!("{error}; `imogene synth --table` writes it again")))?;
        match table.version {
            VERSION => Ok(table),
            found => Err(bad(format!("version {found}, expected {VERSION}"))),
        }
    }

    /// The text of its file; the same for the same figures.
    pub fn json(&self) -> String {
        let text = serde_json::to_string_pretty(self);
        text.expect("a table has no unserialisable keys") + "\n"
    }

    /// What it has of a row.
    pub fn find(&self, row: &Row) -> Option<&Measured> {
        self.rows.iter().find(|known| known.is_of(row))
    }

    /// Whether it has any row of a unit.
    pub fn has(&self, unit: Unit) -> bool {
        self.rows.iter().any(|known| known.unit == unit.name())
    }

    /// What it has of a row, if today's Verilog and tools would give the same.
    fn current(&self, row: &Row) -> Result<Option<&Measured>, SynthError> {
        let verilog = digest(&emit(&row.request)?.bundle());
        let tools = Programs::find(row.target)?.versions();
        let known = self.find(row).filter(|known| known.verilog == verilog);
        Ok(known.filter(|known| known.tools == tools && known.synthesis == row.synthesis()))
    }

    fn section(&self, section: Section, target: Target) -> impl Iterator<Item = &Measured> {
        let rows = self.rows.iter();
        rows.filter(move |row| row.section == section && row.target == target.name())
    }
}

impl Measured {
    fn of(row: &Row, report: SynthReport) -> Self {
        let median = report.median_seed();
        Self {
            section: row.section,
            seeds: row.seeds,
            synthesis: row.synthesis(),
            figures: Figures::from(&report),
            slowest_path: median.and_then(|run| run.critical_path.clone()),
            unit: report.unit,
            parameters: report.parameters,
            target: report.target,
            tools: report.tools,
            latency: report.latency,
            verilog: report.verilog,
        }
    }

    fn is_of(&self, row: &Row) -> bool {
        self.section == row.section
            && self.unit == row.request.unit.name()
            && self.target == row.target.name()
            && self.seeds == row.seeds
            && self.parameters == parameters(&row.request)
    }
}
