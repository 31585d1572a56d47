//! One synthesis from request to report.

use crate::bench::Bench;
use crate::cache::{Cache, digest, kept};
use crate::error::SynthError;
use crate::harness;
use crate::report::{SynthReport, thousandths};
use crate::target::Target;
use crate::tools::Programs;
use imogene_contract::Request;
use imogene_rtl::emit::{Emitted, emit};
use imogene_tools::scratch;
use std::collections::BTreeMap;
use std::time::Instant;

/// Synthesises a unit for a target, and places and routes it with so many seeds, from 1; with none the clock is not
/// measured. Fails when the request is not legal, a tool is missing or fails, or its report cannot be read.
pub fn synthesise(
    request: &Request,
    target: Target,
    seeds: usize,
    cache: Cache,
) -> Result<SynthReport, SynthError> {
    let report = synthesise_design(&emit(request)?, target, seeds, cache)?;
    Ok(SynthReport {
        parameters: parameters(request),
        ..report
    })
}

/// The same of any design, whose parameters are not known. Fails when a tool is missing or fails, or its report cannot
/// be read.
pub fn synthesise_design(
    emitted: &Emitted,
    target: Target,
    seeds: usize,
    cache: Cache,
) -> Result<SynthReport, SynthError> {
    let text = emitted.bundle();
    let programs = Programs::find(target)?;
    let tools = programs.versions();
    let verilog = digest(&text);
    let harness = harness::verilog(emitted);
    let entry = kept(&[
        &verilog,
        target.name(),
        &target.synthesis(harness::TOP),
        &format!(
            "Options {{ seeds: {seeds} }} {:?} {tools:?}{}",
            target.place_and_route(),
            target.steps()
        ),
        &harness,
        env!("CARGO_PKG_VERSION"),
    ]);
    if let Some(report) = entry.load().filter(|_| cache == Cache::Use) {
        return Ok(report);
    }

    let start = Instant::now();
    let folder = scratch()?;
    let bench = Bench::of(&programs, target, folder.path(), emitted, &harness)?;
    let measured = bench.report(seeds)?;
    let report = SynthReport {
        latency: emitted.latency,
        tools,
        verilog,
        seconds: thousandths(start.elapsed().as_secs_f64()),
        ..measured
    };
    entry.store(&report)?;
    Ok(report)
}

/// Depth word and parameters of a request, by option of the command line.
pub(crate) fn parameters(request: &Request) -> BTreeMap<String, usize> {
    std::iter::once(("format", request.depth_word))
        .chain(request.options())
        .map(|(option, value)| (option.to_owned(), value as usize))
        .collect()
}
