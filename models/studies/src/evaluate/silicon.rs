//! Transistors of the source beside transistors, cells and clocks of the same units here (source: 5.2.1, Table 5.10).

use super::EvaluateError;
use super::row::{Group, Row};
use serde::Deserialize;
use std::collections::BTreeMap;

/// The published figures, compiled in.
const TABLE: &str = include_str!("../../../../docs/resources.json");
/// The device of the figures that have a clock.
pub const DEVICE: &str = "ecp5-45k";
/// A device without multipliers: they are made of its cells.
pub const PLAIN_DEVICE: &str = "ice40-hx8k";
/// Gates, in transistors.
const GATES: &str = "transistors";

/// The resource table, as far as it is needed.
#[derive(Clone, Debug, Deserialize)]
pub struct Resources {
    rows: Vec<Line>,
}

#[derive(Clone, Debug, Deserialize)]
struct Line {
    section: String,
    unit: String,
    parameters: BTreeMap<String, usize>,
    target: String,
    figures: Figures,
}

/// Figures of a unit.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Figures {
    /// Flip-flops.
    pub ff: Option<u64>,
    /// Logic cells.
    pub cells: Option<u64>,
    /// Transistors.
    pub transistors: Option<u64>,
    /// Clock.
    pub fmax_mhz: Option<f64>,
}

impl Resources {
    /// The table that is compiled in.
    ///
    /// # Errors
    ///
    /// When it is no such table: a defect.
    pub fn compiled_in() -> Result<Resources, EvaluateError> {
        Ok(serde_json::from_str(TABLE)?)
    }

    /// A row of the table of all units, or with so many planes.
    fn figures(
        &self,
        unit: &str,
        target: &str,
        planes: Option<usize>,
    ) -> Result<Figures, EvaluateError> {
        let section = match (target, planes) {
            (GATES, _) => "transistors",
            (_, Some(_)) => "planes",
            (_, None) => "units",
        };
        let is_wanted = |line: &&Line| {
            let planes = planes.is_none_or(|n| line.parameters.get("planes") == Some(&n));
            line.section == section && line.unit == unit && line.target == target && planes
        };
        let found = self.rows.iter().find(is_wanted);
        found
            .map(|line| line.figures)
            .ok_or_else(|| missing(unit, target, "row"))
    }

    /// Clock in MHz of a unit on [`DEVICE`].
    ///
    /// # Errors
    ///
    /// When the table does not have it.
    pub fn fmax(&self, unit: &str) -> Result<f64, EvaluateError> {
        let found = self.figures(unit, DEVICE, None)?.fmax_mhz;
        found.ok_or_else(|| missing(unit, DEVICE, "clock"))
    }

    /// Transistors of a unit.
    ///
    /// # Errors
    ///
    /// When the table does not have them.
    pub fn transistors(&self, unit: &str) -> Result<f64, EvaluateError> {
        let found = self.figures(unit, GATES, None)?.transistors;
        found
            .map(|v| v as f64)
            .ok_or_else(|| missing(unit, GATES, "transistors"))
    }

    /// Logic cells of a unit on a device.
    ///
    /// # Errors
    ///
    /// When the table does not have them.
    pub fn cells(&self, unit: &str, device: &str) -> Result<f64, EvaluateError> {
        let found = self.figures(unit, device, None)?.cells;
        found
            .map(|v| v as f64)
            .ok_or_else(|| missing(unit, device, "cells"))
    }

    /// Flip-flops of a unit on [`DEVICE`].
    ///
    /// # Errors
    ///
    /// When the table does not have them.
    pub fn flip_flops(&self, unit: &str) -> Result<f64, EvaluateError> {
        let found = self.figures(unit, DEVICE, None)?.ff;
        found
            .map(|v| v as f64)
            .ok_or_else(|| missing(unit, DEVICE, "flip-flops"))
    }

    /// Logic cells of a quadric processor with so many planes.
    fn cells_with_planes(&self, unit: &str, planes: usize) -> Result<f64, EvaluateError> {
        let found = self.figures(unit, DEVICE, Some(planes))?.cells;
        found
            .map(|v| v as f64)
            .ok_or_else(|| missing(unit, DEVICE, "cells"))
    }
}

fn missing(unit: &str, target: &str, figure: &'static str) -> EvaluateError {
    EvaluateError::Missing {
        unit: unit.into(),
        target: target.into(),
        figure,
    }
}

/// The rows.
///
/// # Errors
///
/// When a figure is not in the table: a defect.
pub fn group(resources: &Resources) -> Result<Group, EvaluateError> {
    let gates = |unit: &str| resources.transistors(unit);
    let on = |unit: &str, device: &str| resources.cells(unit, device);
    let patch = on("patch_processor", DEVICE)?;
    let share = |unit: &str, times: f64| {
        Ok::<f64, EvaluateError>(100.0 * times * on(unit, DEVICE)? / patch)
    };
    let row = |name: &str, printed: f64, ours: f64| {
        Row::new(name, "Table 5.10", printed, ours, "transistors")
    };
    let percent =
        |name: &str, printed: f64, ours: f64| Row::new(name, "Table 5.10", printed, ours, "%");
    let (adder, multipliers) = (19_344.0 / 13.0, 47_616.0);
    let ratio = |name: &str, printed: f64, unit: &str, device: &str| {
        let ours = on(unit, device)? / on("facet_processor", device)?;
        Ok::<Row, EvaluateError>(Row::new(name, "5.2.1", printed, ours, "times"))
    };
    let by_cells = "logic cells; three multiplier blocks of the device are not among them";
    let plain = "logic cells of a device without multipliers: they are in it";
    let planes = |n: usize| resources.cells_with_planes("quadric_processor", n);
    Ok(Group {
        name: "silicon",
        title: "Transistors, cells, clocks",
        about: format!(
            "The source counts library cells of ES2 (SOLO 1400, ECPD15): a full adder of 36 and a flip-flop of 26 transistors. Ours are static CMOS gates and the logic cells of {DEVICE} and {PLAIN_DEVICE}, all from \
             docs/resources.json, which `imogene synth --table` makes."
        ),
        rows: vec![
            row("eight PE1", 32_928.0, 8.0 * gates("pe1")?)
                .why("26 bits in place of 24, and an enable in every bit of a register"),
            row("PE2", 15_120.0, gates("pe2")?).why("48 bits there and here; an enable in every bit of a register"),
            row("root", 96_598.0, gates("square_root")?)
                .why("rows grow with the root, 347 cells in all, and of the remainder only the bits that can be set are kept; the source's sum is 278 for a cell"),
            row("three multipliers and three adders", multipliers + 3.0 * adder, gates("normal_unit")?)
                .why("the normal unit also shifts the root, takes its sign and selects the normals of planes"),
            row("PE1, PE2, root and two adders: both depths", 32_928.0 / 8.0 + 15_120.0 + 96_598.0 + 2.0 * adder, gates("quadric_pe")?)
                .why("the print's lines added up"),
            percent("share of the root in a patch processor", 42.8, share("square_root", 1.0)?).why("of logic cells"),
            percent("share of PE2", 6.7, share("pe2", 1.0)?).why("of logic cells"),
            percent("share of eight PE1", 14.6, share("pe1", 8.0)?).why("of logic cells; each PE1 alone, of 26 bits, where those of planes have 36"),
            percent("share of the normal unit", 100.0 * (multipliers + 3.0 * adder) / 225_732.0, share("normal_unit", 1.0)?)
                .why("its multipliers are blocks of the device"),
            ratio("patch processor over facet processor", 7.0, "patch_processor", DEVICE)?
                .corrected(225_732.0 / 35_000.0)
                .why(by_cells),
            ratio("the same, multipliers of logic", 7.0, "patch_processor", PLAIN_DEVICE)?
                .corrected(225_732.0 / 35_000.0)
                .why(plain),
            Row::new("quadric processor over facet processor", "5.2.1", "more than 10", on("quadric_processor", DEVICE)? / on("facet_processor", DEVICE)?, "times")
                .corrected(325_000.0 / 35_000.0)
                .why(format!("{by_cells}; the source estimates 300 000 to 350 000 transistors, of which the middle is taken")),
            Row::new("the same, multipliers of logic", "5.2.1", "more than 10", on("quadric_processor", PLAIN_DEVICE)? / on("facet_processor", PLAIN_DEVICE)?, "times")
                .corrected(325_000.0 / 35_000.0)
                .why(plain),
            Row::new("a third plane in a quadric processor", "5.2.1", "nothing", planes(3)? - planes(2)?, "logic cells").why("an expression and a cut module for both intervals"),
            Row::new("clock of a patch processor", "chapter 5", 33.0, resources.fmax("patch_processor")?, "MHz").why(format!("median of three placements on {DEVICE}, worst case of the tools")),
            Row::new("clock of a quadric processor", "chapter 5", 33.0, resources.fmax("quadric_processor")?, "MHz").why("the same"),
        ],
    })
}
