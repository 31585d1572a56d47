//! `imogene mutate`.

use crate::arguments::Mutate;
use crate::failure::Failure;
use crate::output;
use imogene_contract::Request;
use imogene_files::text::counted;
use imogene_rtl::emit::emit;
use imogene_verif::mutation::{self, Design, MutationReport, table};
use imogene_verif::unit::subject;

/// Scores one unit or all of the published table.
pub fn run(options: &Mutate, json: bool) -> Result<(), Failure> {
    let units = if options.unit == "all" {
        table::UNITS.to_vec()
    } else {
        vec![options.unit.as_str()]
    };
    let reports: Vec<MutationReport> = units
        .into_iter()
        .map(|unit| {
            let report = score(unit, options)?;
            if !json {
                output::text(describe(&report));
            }
            Ok(report)
        })
        .collect::<Result<_, Failure>>()?;
    if let Some(path) = &options.out {
        let command = format!(
            "imogene mutate {} --format {} --mutants {} --out {}",
            options.unit,
            options.format,
            options.mutants,
            path.display()
        );
        let text = table::markdown(&reports, &command);
        output::write_text(path, &text)?;
    }
    if json {
        output::json(&reports);
    }
    verdict(&reports)
}

fn score(unit: &str, options: &Mutate) -> Result<MutationReport, Failure> {
    let request = Request::given(unit, options.format, &[])?;
    let subject = subject(&request)?;
    let emitted = emit(&request)?;
    let text = emitted.bundle();
    let design = Design {
        top: &emitted.top,
        text: &text,
        latency: emitted.latency,
    };
    let bar = output::progress(u64::from(options.mutants), "mutants");
    let options = mutation::Options {
        mutants: options.mutants as usize,
        ..mutation::Options::default()
    };
    let report = mutation::run(&subject, &design, &options, || bar.inc(1));
    bar.finish_and_clear();
    report.map_err(Failure::from)
}

/// A score as text.
fn describe(report: &MutationReport) -> String {
    format!(
        "{}: {} of {}, {} killed, {} equivalent, {} surviving: score {:.2} % ({:.1} s)",
        report.unit,
        counted(report.mutants, "mutant"),
        report.candidates,
        report.killed,
        report.equivalent,
        report.surviving.len(),
        report.score,
        report.seconds
    )
}

/// Success if nothing survived.
fn verdict(reports: &[MutationReport]) -> Result<(), Failure> {
    let count: usize = reports.iter().map(|report| report.surviving.len()).sum();
    if count == 0 {
        return Ok(());
    }
    Err(Failure::Check(format!(
        "surviving and not proven equivalent: {}\n{}",
        counted(count, "mutant"),
        table::survivors(reports).trim_end()
    )))
}
