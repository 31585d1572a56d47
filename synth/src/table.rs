//! The resource table of the documentation: which syntheses it is made of, and its text.

mod markdown;

use crate::cache::digest;
use crate::error::SynthError;
use crate::flow::{Options, synthesise};
use crate::report::SynthReport;
use crate::target::Target;
use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::{EmitRequest, emit};
use rayon::prelude::*;

/// Section of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// Every unit of the machine at the base format.
    Units,
    /// The object processor over the number of its cut planes.
    Planes,
    /// The root network over its rows per stage.
    Rows,
    /// Transistors beside those of the source.
    Transistors,
}

/// One synthesis of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Where it is shown.
    pub section: Section,
    /// Unit.
    pub request: EmitRequest,
    /// Target.
    pub target: Target,
    /// Options.
    pub options: Options,
}

/// The table with its figures.
#[derive(Clone, Debug)]
pub struct Table {
    rows: Vec<(Row, SynthReport)>,
    digest: String,
}

/// Seeds of a clock in the table.
const SEEDS: usize = 3;

/// Devices of the table.
const DEVICES: [Target; 2] = [Target::Ecp5With45k, Target::Ice40Hx8k];

/// Cut planes of the object processors.
const PLANES: [usize; 5] = [0, 1, 2, 3, 4];

/// Rows per stage of the root networks; the last is the whole network of the base format.
const ROWS_PER_STAGE: [usize; 4] = [1, 2, 4, 24];

/// The units the machine is made of; the other forms of the root have a page of their own.
fn units() -> impl Iterator<Item = Unit> {
    let is_root_form = |unit: &Unit| unit.name().starts_with("square_root_");
    Unit::ALL
        .into_iter()
        .filter(move |unit| !is_root_form(unit))
}

/// All rows, in their order.
pub fn rows() -> Vec<Row> {
    let units = DEVICES
        .into_iter()
        .flat_map(|target| units().map(move |unit| unit_row(unit, target)));
    let planes = PLANES.map(|planes| Row {
        section: Section::Planes,
        request: EmitRequest {
            planes,
            ..EmitRequest::new(Unit::QuadricProcessor)
        },
        target: Target::Ecp5With45k,
        // A plane adds a stage of its own beside the others: it costs cells, and the clock is that of the units table.
        options: Options { seeds: 0 },
    });
    let roots = DEVICES
        .into_iter()
        .flat_map(|target| ROWS_PER_STAGE.map(|rows| root_row(rows, target)));
    let transistors = [Unit::Pe1, Unit::Pe2, Unit::SquareRoot, Unit::QuadricPe];
    let transistors = transistors.map(|unit| Row {
        section: Section::Transistors,
        request: EmitRequest::new(unit),
        target: Target::Transistors,
        options: Options { seeds: 0 },
    });
    units
        .chain(planes)
        .chain(roots)
        .chain(transistors)
        .collect()
}

fn unit_row(unit: Unit, target: Target) -> Row {
    // The machine is its units side by side; placing it takes longer than everything else together.
    let seeds = if unit == Unit::Beam { 0 } else { SEEDS };
    Row {
        section: Section::Units,
        request: EmitRequest::new(unit),
        target,
        options: Options { seeds },
    }
}

fn root_row(rows_per_stage: usize, target: Target) -> Row {
    Row {
        section: Section::Rows,
        request: EmitRequest {
            rows_per_stage,
            ..EmitRequest::new(Unit::SquareRoot)
        },
        target,
        options: Options { seeds: SEEDS },
    }
}

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

    /// The reports behind the table.
    pub fn reports(&self) -> Vec<&SynthReport> {
        self.rows.iter().map(|(_, report)| report).collect()
    }

    fn section(&self, section: Section, target: Target) -> impl Iterator<Item = &SynthReport> {
        let rows = self.rows.iter();
        rows.filter(move |(row, _)| row.section == section && row.target == target)
            .map(|(_, report)| report)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unit_of_the_machine_is_in_the_table_for_every_device() {
        let rows = rows();
        for target in DEVICES {
            for unit in units() {
                let shown = |row: &&Row| row.target == target && row.request.unit == unit;
                assert!(rows.iter().any(|row| shown(&row)), "{}", unit.name());
            }
        }
    }

    #[test]
    fn every_request_is_legal() {
        for row in rows() {
            row.request.check().expect("a legal request");
        }
    }

    #[test]
    fn another_text_is_not_current() {
        assert!(!is_current("# Resources").expect("every unit is emitted"));
    }
}
