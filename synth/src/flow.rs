//! One synthesis from request to report.

use crate::bench::{Bench, Clock};
use crate::cache::{Cache, Kept, digest};
use crate::error::SynthError;
use crate::harness;
use crate::report::{SynthReport, thousandths};
use crate::target::{Family, Target};
use crate::tools::{Program, Tool};
use imogene_contract::Request;
use imogene_rtl::emit::{Emitted, emit};
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

/// Synthesises a unit for a target, or takes the result that was kept.
///
/// # Errors
///
/// When the request is not legal, a tool is missing or fails, or its report cannot be read.
pub fn synthesise(
    request: &Request,
    target: Target,
    options: &Options,
) -> Result<SynthReport, SynthError> {
    synthesise_with(request, target, options, Cache::Use)
}

/// Synthesises a unit for a target.
///
/// # Errors
///
/// When the request is not legal, a tool is missing or fails, or its report cannot be read.
pub fn synthesise_with(
    request: &Request,
    target: Target,
    options: &Options,
    cache: Cache,
) -> Result<SynthReport, SynthError> {
    let emitted = emit(request)?;
    let text = emitted.bundle();
    let programs = Programs::find(target)?;
    let tools = programs.versions();
    let verilog = digest(&text);
    let harness = harness::verilog(&emitted);
    let entry = Kept::new(&[
        &verilog,
        target.name(),
        &target.synthesis(harness::TOP),
        &format!("{options:?} {:?} {tools:?}", target.place_and_route()),
        &harness,
        env!("CARGO_PKG_VERSION"),
    ]);
    if let Some(report) = entry.load().filter(|_| cache == Cache::Use) {
        return Ok(report);
    }

    let start = Instant::now();
    let folder = tempfile::tempdir().map_err(SynthError::file(&std::env::temp_dir()))?;
    write(folder.path(), "unit.v", &text)?;
    write(folder.path(), "harness.v", &harness)?;
    let bench = Bench {
        programs: &programs,
        target,
        folder: folder.path(),
        top: &emitted.top,
        read: "read_verilog unit.v",
        read_with_harness: "read_verilog unit.v harness.v",
    };
    let mut report = resources(&bench, &emitted)?;
    report.parameters = parameters(request);
    report.tools = tools;
    report.verilog = verilog;
    add_clock(&mut report, bench.clock(options)?);
    report.seconds = thousandths(start.elapsed().as_secs_f64());
    entry.store(&report)?;
    Ok(report)
}

/// The programs of a target.
pub(crate) struct Programs {
    pub yosys: Tool,
    /// None where only resources are reported.
    pub router: Option<Tool>,
}

impl Programs {
    pub fn find(target: Target) -> Result<Self, SynthError> {
        Ok(Self {
            yosys: Program::Yosys.find()?,
            router: Program::router(target.family())
                .map(Program::find)
                .transpose()?,
        })
    }

    /// Yosys alone, for resources.
    pub fn find_yosys() -> Result<Self, SynthError> {
        Ok(Self {
            yosys: Program::Yosys.find()?,
            router: None,
        })
    }

    /// Versions by name.
    pub fn versions(&self) -> BTreeMap<String, String> {
        let tools = std::iter::once(&self.yosys).chain(&self.router);
        tools
            .map(|tool| (tool.name.to_owned(), tool.version.clone()))
            .collect()
    }
}

/// Versions of the tools of a target.
pub(crate) fn tools(target: Target) -> Result<BTreeMap<String, String>, SynthError> {
    Ok(Programs::find(target)?.versions())
}

/// Depth word and parameters of a request, by option of the command line.
pub(crate) fn parameters(request: &Request) -> BTreeMap<String, usize> {
    std::iter::once(("format", request.depth_word))
        .chain(request.options())
        .map(|(option, value)| (option.to_owned(), value as usize))
        .collect()
}

/// A report of the resources of a unit alone.
fn resources(bench: &Bench, unit: &Emitted) -> Result<SynthReport, SynthError> {
    let (statistics, resources) = bench.resources()?;
    let counted = |count: u64| (bench.target.family() != Family::Gates).then_some(count);
    Ok(SynthReport {
        unit: unit.top.clone(),
        target: bench.target.name().to_owned(),
        parameters: BTreeMap::new(),
        latency: unit.latency,
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

fn add_clock(report: &mut SynthReport, clock: Clock) {
    report.logic_cells = clock.logic_cells;
    report.goal_mhz = clock.goal_mhz;
    report.does_not_fit = clock.does_not_fit;
    report.fmax_mhz = clock.fmax_mhz;
    report.seeds = clock.seeds;
}

/// Writes a file of a bench.
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
