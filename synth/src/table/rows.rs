//! The rows of the resource table and its figures.

use crate::target::Target;
use imogene_contract::{Request, Unit};
use serde::{Deserialize, Serialize};

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
    /// Seeds of place and route; with none the clock is not measured.
    pub seeds: usize,
}

/// Seeds of a clock in the table.
pub(super) const SEEDS: usize = 3;

/// Devices of the table.
pub const DEVICES: [Target; 2] = [Target::Ecp5With45k, Target::Ice40Hx8k];

/// Cut planes of the object processors.
pub(super) const PLANES: [usize; 7] = [0, 1, 2, 3, 4, 8, 12];

/// The object processors whose planes are counted.
const CUT: [Unit; 2] = [Unit::QuadricProcessor, Unit::PatchProcessor];

/// The object processors beside the quadric processor.
const OTHER_PROCESSORS: [Unit; 10] = [
    Unit::PatchProcessor,
    Unit::FirstGenerationProcessor,
    Unit::PolyhedronProcessor,
    Unit::FacetProcessor,
    Unit::CurvedFacetProcessor,
    Unit::SphereProcessor,
    Unit::CylinderProcessor,
    Unit::QuotientProcessor,
    Unit::QuadricVolume,
    Unit::PolyhedralVolume,
];

/// Rows per stage of the root networks; the last is the whole network of the base format.
pub const ROWS_PER_STAGE: [usize; 4] = [1, 2, 4, 24];

/// The root networks that can be cut into stages of any number of rows.
pub const ROOTS: [Unit; 2] = [Unit::SquareRoot, Unit::SquareRootNonRestoring];

/// Units that have transistors of their own in the source, or are made of such.
pub const GATES: [Unit; 5] = [
    Unit::Pe1,
    Unit::Pe2,
    Unit::SquareRoot,
    Unit::QuadricPe,
    Unit::NormalUnit,
];

/// The units the machine is made of; the other forms of the root have a page of their own.
pub fn units() -> impl Iterator<Item = Unit> {
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
    // A plane adds a stage of its own beside the others: it costs cells, and the clock is that of the units table.
    let cells = |section, target| move |request| row(section, request, target, 0);
    let over_planes = |unit| {
        let planes = PLANES.map(|planes| planes as u32).into_iter();
        planes.map(move |planes| Request {
            planes,
            ..Request::new(unit)
        })
    };
    let sides = [3, 4].map(|sides| Request {
        sides,
        ..Request::new(Unit::FacetProcessor)
    });
    let planes = CUT.into_iter().flat_map(over_planes).chain(sides);
    let planes = planes.map(cells(Section::Planes, Target::Ecp5With45k));
    let rooted = |unit, target| {
        ROWS_PER_STAGE.map(|rows| {
            let request = Request {
                rows_per_stage: rows as u32,
                ..Request::new(unit)
            };
            row(Section::Rows, request, target, SEEDS)
        })
    };
    let roots = DEVICES
        .into_iter()
        .flat_map(|target| ROOTS.into_iter().flat_map(move |unit| rooted(unit, target)));
    let transistors = GATES.map(Request::new).into_iter();
    let transistors = transistors.map(cells(Section::Transistors, Target::Transistors));
    units
        .chain(planes)
        .chain(roots)
        .chain(transistors)
        .collect()
}

fn row(section: Section, request: Request, target: Target, seeds: usize) -> Row {
    Row {
        section,
        request,
        target,
        seeds,
    }
}

fn unit_row(unit: Unit, target: Target) -> Row {
    // The machine is its units side by side; placing it takes longer than everything else together. So does placing the
    // object processors beside the quadric processor on the small device, of which they fill most.
    let is_too_long =
        unit == Unit::Beam || target == Target::Ice40Hx8k && OTHER_PROCESSORS.contains(&unit);
    let seeds = if is_too_long { 0 } else { SEEDS };
    row(Section::Units, Request::new(unit), target, seeds)
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

impl Row {
    /// What it is, for messages.
    pub(crate) fn name(&self) -> String {
        let parameters: Vec<String> = crate::flow::parameters(&self.request)
            .iter()
            .map(|(option, value)| format!("--{option} {value}"))
            .collect();
        format!(
            "{} {} for {}",
            self.request.unit.name(),
            parameters.join(" "),
            self.target.name()
        )
    }

    /// How it is synthesised in its harness, placed and routed.
    pub fn synthesis(&self) -> String {
        let target = self.target;
        let routed = target.place_and_route().filter(|_| self.seeds > 0);
        let mut parts = vec![target.synthesis(crate::harness::TOP)];
        parts.push(target.steps().trim().to_owned());
        parts.extend(routed.map(|route| route.arguments.join(" ")));
        parts.retain(|part| !part.is_empty());
        parts.join("; ")
    }
}
