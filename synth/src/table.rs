//! The resource table of the documentation: which syntheses it is made of, and its text.

mod agreement;
mod markdown;
mod picture;
mod transistors;

use crate::cache::digest;
use crate::error::SynthError;
use crate::flow::{Options, synthesise};
use crate::report::SynthReport;
use crate::target::Target;
use imogene_contract::{Request, Unit};
use imogene_rtl::emit::emit;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

pub use agreement::disagreements;
pub use markdown::PICTURE;

/// Section of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Section {
    /// Every unit of the machine at the base format.
    Units,
    /// The object processors over the number of their cut planes or sides.
    Planes,
    /// Both pipelined root networks over their rows per stage.
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
    pub request: Request,
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
const PLANES: [usize; 7] = [0, 1, 2, 3, 4, 8, 12];

/// The object processors whose planes are counted.
const CUT: [Unit; 2] = [Unit::QuadricProcessor, Unit::PatchProcessor];

/// The object processors beside the quadric processor.
const OTHER_PROCESSORS: [Unit; 9] = [
    Unit::PatchProcessor,
    Unit::FirstGenerationProcessor,
    Unit::PolyhedronProcessor,
    Unit::FacetProcessor,
    Unit::CurvedFacetProcessor,
    Unit::SphereProcessor,
    Unit::CylinderProcessor,
    Unit::QuadricVolume,
    Unit::PolyhedralVolume,
];

/// Rows per stage of the root networks; the last is the whole network of the base format.
const ROWS_PER_STAGE: [usize; 4] = [1, 2, 4, 24];

/// The root networks that can be cut into stages of any number of rows.
const ROOTS: [Unit; 2] = [Unit::SquareRoot, Unit::SquareRootNonRestoring];

/// Units that have transistors of their own in the source, or are made of such.
const GATES: [Unit; 5] = [
    Unit::Pe1,
    Unit::Pe2,
    Unit::SquareRoot,
    Unit::QuadricPe,
    Unit::NormalUnit,
];

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
    let over_planes = |unit| PLANES.map(move |planes| planes_row(unit, planes as u32));
    let sides = [3, 4].map(sides_row);
    let planes = CUT.into_iter().flat_map(over_planes).chain(sides);

    let roots = DEVICES.into_iter().flat_map(|target| {
        let rows = move |unit| ROWS_PER_STAGE.map(|rows| root_row(unit, rows as u32, target));
        ROOTS.into_iter().flat_map(rows)
    });
    let transistors = GATES.map(|unit| Row {
        section: Section::Transistors,
        request: Request::new(unit),
        target: Target::Transistors,
        options: Options { seeds: 0 },
    });
    units
        .chain(planes)
        .chain(roots)
        .chain(transistors)
        .collect()
}

fn planes_row(unit: Unit, planes: u32) -> Row {
    Row {
        section: Section::Planes,
        request: Request {
            planes,
            ..Request::new(unit)
        },
        target: Target::Ecp5With45k,
        // A plane adds a stage of its own beside the others: it costs cells, and the clock is that of the units table.
        options: Options { seeds: 0 },
    }
}

fn sides_row(sides: u32) -> Row {
    Row {
        section: Section::Planes,
        request: Request {
            sides,
            ..Request::new(Unit::FacetProcessor)
        },
        target: Target::Ecp5With45k,
        options: Options { seeds: 0 },
    }
}

fn unit_row(unit: Unit, target: Target) -> Row {
    // The machine is its units side by side; placing it takes longer than everything else together. So does placing the object processors
    // beside the quadric processor on the small device, of which they fill most.
    let is_too_long =
        unit == Unit::Beam || target == Target::Ice40Hx8k && OTHER_PROCESSORS.contains(&unit);
    let seeds = if is_too_long { 0 } else { SEEDS };
    Row {
        section: Section::Units,
        request: Request::new(unit),
        target,
        options: Options { seeds },
    }
}

fn root_row(unit: Unit, rows_per_stage: u32, target: Target) -> Row {
    Row {
        section: Section::Rows,
        request: Request {
            rows_per_stage,
            ..Request::new(unit)
        },
        target,
        options: Options { seeds: SEEDS },
    }
}

/// The rows of a unit and of a target, or of all of them.
pub fn select(unit: Option<Unit>, target: Option<Target>) -> Vec<Row> {
    let mut rows = rows();
    rows.retain(|row| {
        unit.is_none_or(|unit| row.request.unit == unit)
            && target.is_none_or(|target| row.target == target)
    });
    rows
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

    /// The networks over their rows per stage as an SVG picture; none without a clock of each.
    ///
    /// # Errors
    ///
    /// When it cannot be drawn.
    pub fn picture(&self) -> Result<Option<String>, SynthError> {
        picture::draw(self)
    }

    /// The rows and their reports.
    pub fn rows(&self) -> &[(Row, SynthReport)] {
        &self.rows
    }

    /// Digest of the Verilog of all rows.
    pub fn digest(&self) -> &str {
        &self.digest
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
    use std::collections::BTreeMap;

    /// A table of all rows with figures that are none of any tool, all different.
    pub fn invented() -> Table {
        let rows = rows().into_iter().enumerate();
        Table {
            rows: rows
                .map(|(index, row)| (row, report(&row, index)))
                .collect(),
            digest: "0123".repeat(16),
        }
    }

    fn report(row: &Row, index: usize) -> SynthReport {
        let count = |base: u64| (row.target != Target::Transistors).then_some(base + index as u64);
        SynthReport {
            unit: row.request.unit.name().to_owned(),
            target: row.target.name().to_owned(),
            parameters: crate::flow::parameters(&row.request),
            latency: row.request.latency(),
            lut: count(1_000),
            ff: count(2_000),
            carry: count(300),
            dsp: count(0),
            bram: count(0),
            logic_cells: count(4_000),
            transistors: (row.target == Target::Transistors).then_some(50_000 + index as u64),
            fmax_mhz: (row.options.seeds > 0).then_some(100.5 + index as f64),
            does_not_fit: None,
            seeds: Vec::new(),
            goal_mhz: Some(300),
            cells: BTreeMap::new(),
            tools: BTreeMap::from([("yosys".to_owned(), "0.70".to_owned())]),
            verilog: format!("{index:064}"),
            seconds: 1.0,
        }
    }

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
    fn rows_are_selected_by_unit_and_target() {
        let both = select(Some(Unit::CutPlane), None);
        let targets: Vec<Target> = both.iter().map(|row| row.target).collect();
        assert_eq!(targets, DEVICES);
        let one = select(Some(Unit::CutPlane), Some(Target::Ice40Hx8k));
        assert_eq!(one, both[1..]);
        assert_eq!(select(None, None), rows());
        assert!(select(None, Some(Target::Gowin)).is_empty());
    }

    #[test]
    fn another_text_is_not_current() {
        assert!(!is_current("# Resources").expect("every unit is emitted"));
    }
}
