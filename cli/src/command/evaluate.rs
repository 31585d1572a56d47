//! `imogene evaluate`.

use crate::arguments::Evaluate;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_golden::format::Format;
use imogene_package::processors::processors;
use imogene_studies::evaluate::{
    EvaluateError, Evaluation, Hardware, MACHINE_PROCESSORS, Parts, duplication_plot, evaluate,
    markdown, operations_plot, page, zone_machine,
};
use imogene_verif::display::request::{core_request, zone_timing};
use std::path::{Path, PathBuf};

pub fn run(options: &Evaluate, json: bool) -> Result {
    let evaluation = evaluate(&hardware()?).map_err(defect)?;
    let page = markdown(&evaluation).map_err(defect)?;
    let out = options.out.as_ref();
    let files = out.map(|folder| write(folder, &evaluation, &page));
    let files = files.transpose()?.unwrap_or_default();
    output::paged(json, evaluation, files, page.trim_end());
    Ok(())
}

/// Parts of the processors as they are emitted, and the clocks of the zone machine.
fn hardware() -> Result<Hardware> {
    let parts = processors()?.into_iter().map(|p| Parts {
        unit: p.unit.into(),
        parameters: p.parameters,
        counts: [
            p.census.pe1,
            p.census.pe2,
            p.census.roots,
            p.census.multipliers,
        ],
    });
    let machine = zone_machine(MACHINE_PROCESSORS);
    let request = core_request(&machine, &Format::BASE, 1);
    Ok(Hardware {
        processors: parts.collect(),
        zone_timing: zone_timing(&request)?,
    })
}

fn defect(error: EvaluateError) -> Failure {
    Failure::Check(error.to_string())
}

fn write(folder: &Path, evaluation: &Evaluation, markdown: &str) -> Result<Vec<PathBuf>> {
    let index = page(evaluation, env!("CARGO_PKG_VERSION")).map_err(defect)?;
    let figures = output::json_text(evaluation) + "\n";
    let duplication = duplication_plot().map_err(defect)?;
    let operations = operations_plot(evaluation).map_err(defect)?;
    let mut files = output::files();
    for (name, text) in [
        ("index.html", &*index),
        ("evaluation.json", &*figures),
        ("evaluation.md", markdown),
        ("images/duplication.svg", &*duplication),
        ("images/operations.svg", &*operations),
    ] {
        files.add_text(&folder.join(name), text)?;
    }
    Ok(files.finish()?)
}
