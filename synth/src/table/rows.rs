//! The rows of the resource table and its figures.

use crate::flow::parameters;
use crate::target::Target;
use imogene_contract::{Request, Unit};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

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
    let mut rows = vec![];
    let mut add = |section, request, target, seeds| {
        rows.push(Row {
            section,
            request,
            target,
            seeds,
        });
    };
    for target in DEVICES {
        for unit in units() {
            // The machine is its units side by side; placing it takes longer than everything else together. So does
            // placing the object processors beside the quadric processor on the small device, of which they fill most.
            let is_small = target == Target::Ice40Hx8k;
            let is_too_long = unit == Unit::Beam || is_small && OTHER_PROCESSORS.contains(&unit);
            let seeds = if is_too_long { 0 } else { SEEDS };
            add(Section::Units, Request::new(unit), target, seeds);
        }
    }
    // A plane adds a stage of its own beside the others: it costs cells, and the clock is that of the units table.
    let mut add_planes = |request| add(Section::Planes, request, Target::Ecp5With45k, 0);
    for of in CUT.map(Request::new) {
        for planes in PLANES.map(|planes| planes as u32) {
            add_planes(Request { planes, ..of });
        }
    }
    let facets = Request::new(Unit::FacetProcessor);
    for sides in [3, 4] {
        add_planes(Request { sides, ..facets });
    }
    for target in DEVICES {
        for of in ROOTS.map(Request::new) {
            for rows_per_stage in ROWS_PER_STAGE.map(|rows| rows as u32) {
                let request = Request {
                    rows_per_stage,
                    ..of
                };
                add(Section::Rows, request, target, SEEDS);
            }
        }
    }
    let target = Target::Transistors;
    for unit in GATES {
        add(Section::Transistors, Request::new(unit), target, 0);
    }
    rows
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

/// What messages call a unit with parameters and a target.
pub fn called(unit: &str, parameters: &BTreeMap<String, usize>, target: &str) -> String {
    let option = |(option, value): (&String, &usize)| format!("--{option} {value}");
    let options: Vec<String> = parameters.iter().map(option).collect();
    format!("{unit} {} for {target}", options.join(" "))
}

impl Row {
    /// What it is, for messages.
    pub(crate) fn name(&self) -> String {
        let parameters = parameters(&self.request);
        called(self.request.unit.name(), &parameters, self.target.name())
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
