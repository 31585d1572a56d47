//! Figures of the hardware: parts of the processors as they are emitted, and the table of resources.

use super::EvaluateError;
use imogene_plan::zone::clocks::ZoneTiming;
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// The parts of a processor as it is emitted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parts {
    /// Unit.
    pub unit: String,
    /// Its parameters besides the format, such as `4 planes`.
    pub parameters: String,
    /// Elementary processors of the first and of the second degree, square root networks, multipliers.
    pub counts: [usize; 4],
}

/// What the counts need of the hardware.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hardware {
    /// The object processors in the base format.
    pub processors: Vec<Parts>,
    /// Clocks of a zone machine of [`MACHINE_PROCESSORS`] processors with four planes.
    pub zone_timing: ZoneTiming,
}

/// Object processors of the zone machine whose clocks are handed in.
pub const MACHINE_PROCESSORS: usize = 100;
/// Their cut planes.
pub const MACHINE_PLANES: usize = 4;

/// The published figures, compiled in.
const TABLE: &str = include_str!("../../../../docs/resources.json");
/// The device of the figures that have a clock.
pub const DEVICE: &str = "ecp5-45k";
/// A device without multipliers: they are made of its cells.
pub const PLAIN_DEVICE: &str = "ice40-hx8k";
pub const GATES: &str = "transistors";

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
    figures: BTreeMap<String, Value>,
}

impl Resources {
    /// The table that is compiled in.
    pub fn compiled_in() -> Result<Resources, EvaluateError> {
        serde_json::from_str(TABLE).map_err(|error| format!("docs/resources.json: {error}").into())
    }

    /// A figure, as it is called and by its key, of a unit on a device, in the table of all units or of those with so
    /// many planes.
    pub fn figure(
        &self,
        [what, key]: [&str; 2],
        unit: &str,
        target: &str,
        planes: Option<usize>,
    ) -> Result<f64, EvaluateError> {
        let section = match (target, planes) {
            (GATES, _) => "transistors",
            (_, Some(_)) => "planes",
            (_, None) => "units",
        };
        let is_wanted = |line: &&Line| {
            let planes = planes.is_none_or(|n| line.parameters.get("planes") == Some(&n));
            line.section == section && line.unit == unit && line.target == target && planes
        };
        let missing = |figure: &str| format!("no {figure} of `{unit}` for {target}");
        let line = self.rows.iter().find(is_wanted);
        let line = line.ok_or_else(|| missing("row"))?;
        let figure = line.figures.get(key).and_then(Value::as_f64);
        figure.ok_or_else(|| missing(what).into())
    }
}
