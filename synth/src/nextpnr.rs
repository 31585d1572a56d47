//! Packing, placing and routing with nextpnr, and its report.

use crate::error::SynthError;
use crate::report::{CriticalPath, thousandths};
use crate::target::PlaceAndRoute;
use crate::tools::Tool;
use imogene_tools::read;
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// What nextpnr reports.
#[derive(Clone, Debug, PartialEq)]
pub struct RouteReport {
    /// Cells used and available, by type.
    pub utilisation: BTreeMap<String, (u64, u64)>,
    /// Register-to-register clock in MHz; none after packing alone.
    pub fmax_mhz: Option<f64>,
    /// The path that limits it.
    pub critical_path: Option<CriticalPath>,
    /// Every clock by its net.
    pub clocks: BTreeMap<String, RoutedClock>,
    /// The longest path in ns from a rising edge of one clock to that of another, by both.
    pub crossings: BTreeMap<(String, String), f64>,
}

/// A clock of a routed design, in MHz.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
pub struct RoutedClock {
    /// What it reaches.
    pub achieved: f64,
    /// What was asked for.
    pub constraint: f64,
}

impl RouteReport {
    /// The cells the device has too few of, but for pins.
    pub fn excess(&self) -> Option<String> {
        // What Gowin calls dummies are the halves of pins that a serialiser takes with it.
        let is_pin = |name: &str| name.ends_with("_IO") || name.ends_with("_DUMMY");
        let mut cells = self.utilisation.iter();
        let (name, (used, available)) =
            cells.find(|(name, (used, available))| used > available && !is_pin(name))?;
        Some(format!("{used} {name} of {available}"))
    }
}

/// Runs nextpnr on a netlist of the folder: packs it and, with a seed, places and routes it too.
pub(crate) fn run(
    tool: &Tool,
    device: &PlaceAndRoute,
    folder: &Path,
    netlist: &str,
    seed: Option<usize>,
) -> Result<RouteReport, SynthError> {
    let seed = seed.map(|seed| seed.to_string());
    let name = format!("{netlist}.{}.report", seed.as_deref().unwrap_or("pack"));
    let goal = device.goal_mhz.to_string();
    let mut arguments = device.arguments.to_vec();
    arguments.extend(["--json", netlist, "--report", &name, "-q", "--freq", &goal]);
    arguments.push("--timing-allow-fail");
    match &seed {
        Some(seed) => arguments.extend(["--seed", seed]),
        None => arguments.push("--pack-only"),
    }
    tool.run(&arguments, folder)?;
    parse_report(&read(&folder.join(name))?)
}

#[derive(Deserialize)]
struct Document {
    critical_paths: Vec<ReportedPath>,
    fmax: BTreeMap<String, RoutedClock>,
    utilization: BTreeMap<String, Used>,
}

#[derive(Deserialize)]
struct Used {
    used: u64,
    available: u64,
}

#[derive(Deserialize)]
struct ReportedPath {
    from: String,
    to: String,
    path: Vec<Value>,
}

/// Reads a report of nextpnr. Fails when it is none.
pub fn parse_report(text: &str) -> Result<RouteReport, SynthError> {
    let document: Document =
        serde_json::from_str(text).map_err(|error| SynthError::report("nextpnr", error))?;
    let slowest = document.fmax.values().map(|clock| clock.achieved);
    let utilisation = document.utilization.into_iter();
    let utilisation = utilisation.map(|(name, cells)| (name, (cells.used, cells.available)));
    let paths = document.critical_paths.iter();
    // Both ends on the same clock edge; a path from or to a pin is `<async>` at one end.
    let is_between_registers =
        |path: &&ReportedPath| path.from == path.to && path.from.starts_with("posedge");
    Ok(RouteReport {
        utilisation: utilisation.collect(),
        fmax_mhz: slowest.reduce(f64::min).map(thousandths),
        critical_path: paths
            .clone()
            .find(is_between_registers)
            .map(ReportedPath::summary),
        crossings: paths.filter_map(ReportedPath::crossing).collect(),
        clocks: document.fmax,
    })
}

impl ReportedPath {
    /// Both clocks of a path from one to another, and its length.
    fn crossing(&self) -> Option<((String, String), f64)> {
        let clock = |edge: &str| edge.strip_prefix("posedge ").map(str::to_owned);
        let (from, to) = clock(&self.from).zip(clock(&self.to))?;
        let delays = self.path.iter().filter_map(|step| step["delay"].as_f64());
        (from != to).then(|| ((from, to), thousandths(delays.sum())))
    }

    fn summary(&self) -> CriticalPath {
        let cell = |step: Option<&Value>, end: &str| {
            let name = step.and_then(|step| step[end]["cell"].as_str());
            name.unwrap_or_default().to_owned()
        };
        let (mut logic_ns, mut routing_ns) = (0.0, 0.0);
        for step in &self.path {
            let delay = step["delay"].as_f64().unwrap_or_default();
            if step["type"] == "routing" {
                routing_ns += delay;
            } else {
                logic_ns += delay;
            }
        }
        CriticalPath {
            from: cell(self.path.first(), "from"),
            to: cell(self.path.last(), "to"),
            logic_ns: thousandths(logic_ns),
            routing_ns: thousandths(routing_ns),
        }
    }
}
