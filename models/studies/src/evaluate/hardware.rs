//! Figures of the hardware: parts of the processors as they are emitted, and the table of resources.

use super::EvaluateError;
use imogene_plan::zone::clocks::ZoneTiming;
use serde_json::Value;

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

/// The device of the figures that have a clock.
pub const DEVICE: &str = "ecp5-45k";
/// A device without multipliers: they are made of its cells.
pub const PLAIN_DEVICE: &str = "ice40-hx8k";
pub const GATES: &str = "transistors";

/// The published table of resources, which is compiled in.
pub fn resources() -> Result<Value, EvaluateError> {
    let table = serde_json::from_str(include_str!("../../../../docs/resources.json"));
    table.map_err(|error| format!("docs/resources.json: {error}").into())
}

/// A figure of the table, by its name and its key, of a unit on a device, or of the unit with so many planes.
pub fn figure(
    table: &Value,
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
    let is_wanted = |row: &&Value| {
        let planes = planes.is_none_or(|n| row["parameters"]["planes"] == n);
        row["section"] == section && row["unit"] == unit && row["target"] == target && planes
    };
    let missing = |figure: &str| format!("no {figure} of `{unit}` for {target}");
    let mut rows = table["rows"].as_array().into_iter().flatten();
    let row = rows.find(is_wanted).ok_or_else(|| missing("row"))?;
    let figure = row["figures"][key].as_f64();
    figure.ok_or_else(|| missing(what).into())
}
