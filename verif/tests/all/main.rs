//! All tests of the crate, as one program.

mod deciders;
mod engine;
mod engines;
mod equivalence;
mod exhaustive;
mod extremes;
mod faults;
mod fields;
mod fitted;
mod formal;
mod glass;
mod icarus;
mod kernels;
mod lanes;
mod machines;
mod mutation;
mod patches;
mod proofs;
mod roots;
mod shading_processor;
mod signal;
mod tile;
mod units;
mod verilator;
mod video;
mod waveform;
mod waveforms;
mod zone_core;

use imogene_contract::Request;
use imogene_golden::format::Format;
use imogene_prepare::{Framing, PreparedScene, prepare};
use imogene_rtl::emit::emit;
use imogene_scene::{FramedScene, SceneFile};
use imogene_verif::engine::design::{DesignError, Source};
use imogene_verif::engine::verilator::Model;
use imogene_verif::report::Report;
use imogene_verif::subject::{Hardware, Subject};
use imogene_verif::unit::subject;
use std::path::{Path, PathBuf};

/// The runs of minutes are made as well.
fn is_full_run() -> bool {
    std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1")
}

/// All proofs are made.
fn is_proof_run() -> bool {
    std::env::var("IMOGENE_PROOFS").is_ok_and(|value| value == "1")
}

/// The folder of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A scene of the repository.
fn scene(name: &str) -> SceneFile {
    SceneFile::read(&root().join("scenes").join(name)).expect("a valid scene")
}

/// A scene in a size, and its words in a format.
fn prepared(
    file: &SceneFile,
    (width, height): (u32, u32),
    format: Format,
) -> (FramedScene, PreparedScene) {
    let framed = file.frame(width, height).expect("a valid size");
    let prepared = prepare(&framed, format).expect("fits the format");
    (framed, prepared)
}

/// A unit of the catalogue with its default parameters.
fn unit(name: &str, depth_word: u32) -> Subject {
    subject(&request(name, depth_word, &[])).expect("its defaults are legal")
}

/// A unit with these parameters.
fn request(name: &str, depth_word: u32, options: &[(&'static str, u32)]) -> Request {
    let options = options.iter();
    let options = options.map(|(option, value)| (*option, Some(*value)));
    let request = Request::given(name, depth_word, &options.collect::<Vec<_>>());
    request.unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The emitted Verilog of a unit.
fn verilog(name: &str, depth_word: u32) -> String {
    let request = request(name, depth_word, &[]);
    emit(&request).expect("a legal request").bundle()
}

/// Verilog of a unit in Verilator.
fn compiled(unit: &Subject, text: &str) -> Result<Model, DesignError> {
    Model::compile(&Source::of(unit, &unit.name, text), ["", ""])
}

/// The outputs of hardware that runs alone, after a clock.
fn clock(hardware: &mut dyn Hardware, inputs: &[i64]) -> Vec<Option<i64>> {
    let mut found = vec![];
    hardware.clock(&[inputs]);
    hardware.outputs(0, &mut found);
    found
}

/// Runs so many stimuli, in which nothing differs.
fn run(unit: &Subject, stimuli: u64, clocks: usize) -> Vec<Report> {
    let stimuli = (0..stimuli).map(|seed| unit.seeded_stimulus(clocks, seed));
    let outcomes = unit.run_all(&stimuli.collect::<Vec<_>>(), false);
    let reports: Vec<Report> = outcomes.into_iter().map(|(report, _)| report).collect();
    for (seed, report) in reports.iter().enumerate() {
        let unit = format!("{} {}, seed {seed}", unit.name, unit.options);
        let first = &report.first_mismatches;
        assert_eq!(report.mismatches, 0, "{unit}: {first:?}");
        assert!(report.comparisons > 0, "{unit}: nothing was compared");
    }
    reports
}
