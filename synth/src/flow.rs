//! One synthesis from request to report.

use crate::cache::{Entry, digest};
use crate::error::SynthError;
use crate::nextpnr::{self, RouteReport, Run};
use crate::report::{SeedResult, SynthReport, median, thousandths};
use crate::target::{Family, PlaceAndRoute, Target};
use crate::tools::{Program, Tool};
use crate::{harness, yosys};
use imogene_rtl::emit::{EmitRequest, Emitted, emit};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

/// How a synthesis is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Seeds of place and route, from 1; with 0 the clock is not measured.
    pub seeds: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { seeds: 3 }
    }
}

/// Synthesises a unit for a target.
///
/// # Errors
///
/// When the request is not legal, a tool is missing or fails, or its report cannot be read.
pub fn synthesise(
    request: &EmitRequest,
    target: Target,
    options: &Options,
) -> Result<SynthReport, SynthError> {
    let emitted = emit(request)?;
    let text = emitted.bundle();
    let yosys = Program::Yosys.find()?;
    let router = Program::router(target.family())
        .map(Program::find)
        .transpose()?;
    let tools: BTreeMap<String, String> = std::iter::once(&yosys)
        .chain(&router)
        .map(|tool| (tool.name.to_owned(), tool.version.clone()))
        .collect();
    let verilog = digest(&text);
    let entry = Entry::new(&[
        &verilog,
        target.name(),
        &target.synthesis(harness::TOP),
        &format!("{options:?} {:?} {tools:?}", target.place_and_route()),
        &harness::verilog(&emitted),
        env!("CARGO_PKG_VERSION"),
    ]);
    if let Some(report) = entry.load() {
        return Ok(report);
    }

    let start = Instant::now();
    let bench = Bench::new(&yosys, target, &emitted, &text)?;
    let mut report = bench.resources()?;
    report.parameters = parameters(request);
    report.tools = tools;
    report.verilog = verilog;
    if let (Some(router), Some(device)) = (&router, target.place_and_route()) {
        bench.clock(router, &device, options, &mut report)?;
    }
    report.seconds = thousandths(start.elapsed().as_secs_f64());
    entry.store(&report)?;
    Ok(report)
}

fn parameters(request: &EmitRequest) -> BTreeMap<String, usize> {
    std::iter::once(("format", request.depth_word))
        .chain(request.options())
        .map(|(option, value)| (option.to_owned(), value))
        .collect()
}

/// Names of the netlists in the folder of a synthesis.
const UNIT_NETLIST: &str = "unit.json";
const HARNESS_NETLIST: &str = "harness.json";

/// A folder with the Verilog of a unit and its harness.
struct Bench<'a> {
    yosys: &'a Tool,
    target: Target,
    unit: &'a Emitted,
    folder: tempfile::TempDir,
}

impl<'a> Bench<'a> {
    fn new(
        yosys: &'a Tool,
        target: Target,
        unit: &'a Emitted,
        text: &str,
    ) -> Result<Self, SynthError> {
        let folder = tempfile::tempdir().map_err(SynthError::file(&std::env::temp_dir()))?;
        write(folder.path(), "unit.v", text)?;
        write(folder.path(), "harness.v", &harness::verilog(unit))?;
        Ok(Self {
            yosys,
            target,
            unit,
            folder,
        })
    }

    /// Resources of the unit alone.
    fn resources(&self) -> Result<SynthReport, SynthError> {
        let script = format!(
            "read_verilog unit.v; {}; delete t:$scopeinfo; write_json {UNIT_NETLIST}; tee -q -o unit.stat {}",
            self.target.synthesis(&self.unit.top),
            self.target.statistics()
        );
        yosys::run(self.yosys, self.folder.path(), &script)?;
        let path = self.folder.path().join("unit.stat");
        let text = std::fs::read_to_string(&path).map_err(SynthError::file(&path))?;
        let statistics = yosys::parse_statistics(&text)?;
        let resources = yosys::resources(self.target.family(), &statistics.cells);
        let counted = |count: u64| (self.target.family() != Family::Gates).then_some(count);
        Ok(SynthReport {
            unit: self.unit.top.clone(),
            target: self.target.name().to_owned(),
            parameters: BTreeMap::new(),
            latency: self.unit.latency,
            lut: counted(resources.lut),
            ff: counted(resources.ff),
            carry: counted(resources.carry),
            dsp: counted(resources.dsp),
            bram: counted(resources.bram),
            logic_cells: None,
            transistors: statistics.transistors,
            fmax_mhz: None,
            does_not_fit: None,
            seeds: Vec::new(),
            goal_mhz: None,
            cells: statistics.cells,
            tools: BTreeMap::new(),
            verilog: String::new(),
            seconds: 0.0,
        })
    }

    /// Packs the unit alone, and places and routes it in its harness with every seed.
    fn clock(
        &self,
        router: &Tool,
        device: &PlaceAndRoute,
        options: &Options,
        report: &mut SynthReport,
    ) -> Result<(), SynthError> {
        let run = |netlist, run| nextpnr::run(router, device, self.folder.path(), netlist, run);
        let packed = run(UNIT_NETLIST, Run::Pack)?;
        report.logic_cells = packed
            .utilisation
            .get(device.logic_cell)
            .map(|cells| cells.0);
        if options.seeds == 0 {
            return Ok(());
        }
        report.goal_mhz = Some(device.goal_mhz);
        self.synthesise_harness()?;
        report.does_not_fit = run(HARNESS_NETLIST, Run::Pack)?.excess();
        if report.does_not_fit.is_some() {
            return Ok(());
        }
        let seeds = (1..=options.seeds).into_par_iter();
        report.seeds = seeds
            .map(|seed| seed_result(seed, run(HARNESS_NETLIST, Run::Route { seed })?))
            .collect::<Result<_, _>>()?;
        report.fmax_mhz = median(&report.seeds);
        Ok(())
    }

    fn synthesise_harness(&self) -> Result<(), SynthError> {
        let script = format!(
            "read_verilog unit.v harness.v; {}; delete t:$scopeinfo; write_json {HARNESS_NETLIST}",
            self.target.synthesis(harness::TOP)
        );
        yosys::run(self.yosys, self.folder.path(), &script)
    }
}

fn seed_result(seed: usize, report: RouteReport) -> Result<SeedResult, SynthError> {
    let fmax_mhz = report.fmax_mhz.ok_or_else(|| SynthError::Report {
        tool: "nextpnr",
        problem: "it has no clock".into(),
    })?;
    Ok(SeedResult {
        seed,
        fmax_mhz,
        critical_path: report.critical_path,
    })
}

pub(crate) fn write(folder: &Path, name: &str, text: &str) -> Result<(), SynthError> {
    let path = folder.join(name);
    std::fs::write(&path, text).map_err(SynthError::file(&path))
}

/// The last lines of what a tool said, enough to see its error.
pub(crate) fn last_lines(text: &str) -> String {
    let lines: Vec<&str> = text
        .lines()
        .filter(|line| !line.trim().is_empty())
        .collect();
    lines[lines.len().saturating_sub(6)..].join("\n")
}
