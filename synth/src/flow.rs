//! One synthesis from request to report.

pub use crate::bench::Options;
use crate::bench::{Bench, Clock};
use crate::cache::{Cache, digest, kept};
use crate::error::SynthError;
use crate::harness;
use crate::report::{SynthReport, thousandths};
use crate::target::{Family, Target};
use crate::tools::Programs;
use imogene_contract::Request;
use imogene_rtl::emit::{Emitted, emit};
use imogene_tools::scratch;
use std::collections::BTreeMap;
use std::time::Instant;

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
    let entry = kept(&[
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
    let folder = scratch()?;
    let bench = Bench::of(&programs, target, folder.path(), &emitted, &harness)?;
    let mut report = resources(&bench, &emitted)?;
    report.parameters = parameters(request);
    report.tools = tools;
    report.verilog = verilog;
    add_clock(&mut report, bench.clock(options)?);
    report.seconds = thousandths(start.elapsed().as_secs_f64());
    entry.store(&report)?;
    Ok(report)
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
