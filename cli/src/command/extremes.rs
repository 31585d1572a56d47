//! `imogene cosim extremes/NAME`, and `imogene cosim extremes` for all of them.

use super::negation;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_files::text::counted;
use imogene_verif::extremes::{self, Extreme, Finding};

/// What the subject of `cosim` must begin with.
const PREFIX: &str = "extremes";

/// True if `cosim` is asked for an extreme and not for a unit or a scene file.
pub fn is_meant(subject: &str) -> bool {
    subject == PREFIX
        || subject
            .strip_prefix(PREFIX)
            .is_some_and(|rest| rest.starts_with('/') && !rest.ends_with(".toml"))
}

pub fn run(subject: &str, json: bool) -> Result {
    let run = |extreme: &Extreme| {
        let finding = extreme.run();
        if !json {
            print(&finding);
        }
        finding
    };
    let findings: Vec<Finding> = chosen(subject)?.into_iter().map(run).collect();
    if json {
        output::json(&findings);
    }
    let failed = findings.iter().filter(|f| !f.held).map(|f| &f.name);
    let failed = output::joined(failed, ", ");
    Failure::unless(failed.is_empty(), || format!("not as stated: {failed}"))
}

fn chosen(subject: &str) -> Result<Vec<&'static Extreme>> {
    let rest = subject.strip_prefix(PREFIX).unwrap_or_default();
    let name = rest.trim_start_matches('/');
    if name.is_empty() {
        return Ok(extremes::all().collect());
    }
    match extremes::find(name) {
        Some(extreme) => Ok(vec![extreme]),
        None => Err(Failure::Input(format!(
            "there is no extreme `{name}`; the extremes are {}",
            output::joined(extremes::all().map(|e| e.name), ", ")
        ))),
    }
}

fn print(finding: &Finding) {
    let (name, not, outcome) = (&finding.name, negation(finding.held), &finding.outcome);
    output::text(format!("{name}: {not}as stated\n  {outcome}"));
    if let Some(report) = &finding.cosimulation {
        output::text(format!(
            "  {}, {} of hardware and golden model compared, {}",
            counted(report.cycles, "clock"),
            counted(report.comparisons, "value"),
            counted(report.mismatches, "mismatch")
        ));
    }
    if !finding.detail.is_empty() {
        output::text(format!("  {}", finding.detail));
    }
}
