//! A design of another project beside a unit: same scripts, same harness, same seeds, in one run.

mod design;
pub mod source;

use crate::bench::Bench;
use crate::cache::Cache;
pub use crate::error::PeerError;
use crate::error::SynthError;
use crate::flow::synthesise;
use crate::harness;
use crate::report::{Figures, SeedResult};
use crate::target::Target;
use crate::tools::Programs;
pub use design::Peer;
use imogene_contract::Request;
use imogene_tools::{scratch, write};
use serde::Serialize;
use source::Source;
use std::collections::BTreeMap;

/// A peer and a unit, measured alike.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// Target.
    pub target: String,
    /// Seeds of place and route.
    pub seeds: usize,
    /// Tools and versions.
    pub tools: BTreeMap<String, String>,
    /// The peer.
    pub peer: Measured,
    /// The unit.
    pub unit: Measured,
    /// Figures of the peer divided by those of the unit; none where one of them is none or the unit's is 0.
    pub ratios: BTreeMap<&'static str, Option<f64>>,
}

/// One of the two designs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Measured {
    /// Name of the module.
    pub top: String,
    /// Parameters.
    pub parameters: BTreeMap<String, String>,
    /// Clock port.
    pub clock: String,
    /// Latency in clocks; that of a peer is not known.
    pub latency: Option<usize>,
    /// Resources and clock.
    pub figures: Figures,
    /// Every run of place and route.
    pub seeds: Vec<SeedResult>,
    /// Digest of the Verilog.
    pub verilog: String,
}

/// Measures a peer and a unit. Fails when a file of the peer is missing, Yosys refuses it, it has no such top or
/// clock, the request is not legal or a tool fails.
pub fn compare(
    peer: &Peer,
    request: &Request,
    target: Target,
    seeds: usize,
) -> Result<Comparison, SynthError> {
    peer.check()?;
    let programs = Programs::find(target)?;
    let measured = measure(peer, &programs, target, seeds)?;
    let report = synthesise(request, target, seeds, Cache::Use)?;
    let parameters = report.parameters.iter();
    let parameters = parameters.map(|(option, value)| (option.clone(), value.to_string()));
    let unit = Measured {
        top: report.unit.clone(),
        parameters: parameters.collect(),
        clock: "clock".into(),
        latency: Some(report.latency),
        figures: Figures::from(&report),
        seeds: report.seeds,
        verilog: report.verilog,
    };
    Ok(Comparison {
        target: target.name().to_owned(),
        seeds,
        tools: programs.versions(),
        ratios: ratios(&measured.figures, &unit.figures),
        peer: measured,
        unit,
    })
}

fn measure(
    peer: &Peer,
    programs: &Programs,
    target: Target,
    seeds: usize,
) -> Result<Measured, SynthError> {
    let folder = scratch()?;
    let source = Source::new(peer, folder.path())?;
    let (ports, clock) = source.ports(&programs.yosys)?;
    let text = harness::around(&peer.top, &ports, Some(&clock));
    write(&folder.path().join("harness.v"), &text)?;
    let bench = Bench {
        programs,
        target,
        folder: folder.path(),
        top: &peer.top,
        read: &source.read,
        read_with_harness: &format!("{}; read_verilog harness.v", source.read),
    };
    let report = bench.report(seeds)?;
    Ok(Measured {
        top: peer.top.clone(),
        parameters: peer.parameters.iter().cloned().collect(),
        clock,
        latency: None,
        figures: Figures::from(&report),
        seeds: report.seeds,
        verilog: source.digest,
    })
}

/// Figures of the peer divided by those of the unit; none where one of them is none or the unit's is 0.
pub fn ratios(peer: &Figures, unit: &Figures) -> BTreeMap<&'static str, Option<f64>> {
    let float = |count: Option<u64>| count.map(|count| count as f64);
    let counts = peer.counts().into_iter().zip(unit.counts());
    let counts = counts.map(|((name, peer), (_, unit))| (name, float(peer), float(unit)));
    counts
        .chain([("Fmax", peer.fmax_mhz, unit.fmax_mhz)])
        .map(|(name, peer, unit)| {
            let unit = unit.filter(|unit| *unit != 0.0);
            (name, peer.zip(unit).map(|(peer, unit)| peer / unit))
        })
        .collect()
}
