//! `imogene cosim extremes/NAME`, and `imogene cosim extremes` for all of them.

use crate::failure::Failure;
use crate::output;
use imogene_files::text::counted;
use imogene_verif::extremes::{self, Extreme, Finding};

/// What the subject of `cosim` must begin with.
pub const PREFIX: &str = "extremes";

/// True if `cosim` is asked for an extreme and not for a unit or a scene file.
pub fn is_meant(subject: &str) -> bool {
    subject == PREFIX
        || subject
            .strip_prefix(PREFIX)
            .is_some_and(|rest| rest.starts_with('/') && !rest.ends_with(".toml"))
}

pub fn run(subject: &str, json: bool) -> Result<(), Failure> {
    let chosen = chosen(subject)?;
    let mut findings = Vec::new();
    for extreme in chosen {
        let finding = extreme.run();
        if !json {
            print(&finding);
        }
        findings.push(finding);
    }
    if json {
        output::json(&findings);
    }
    let failed = findings.iter().filter(|f| !f.held).map(|f| &f.name);
    match output::joined(failed, ", ") {
        none if none.is_empty() => Ok(()),
        failed => Err(Failure::Check(format!("not as stated: {failed}"))),
    }
}

fn chosen(subject: &str) -> Result<Vec<&'static Extreme>, Failure> {
    let name = subject
        .strip_prefix(PREFIX)
        .unwrap_or_default()
        .trim_start_matches('/');
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
    let verdict = if finding.held {
        "as stated"
    } else {
        "NOT as stated"
    };
    output::text(format!(
        "{}: {verdict}\n  {}",
        finding.name, finding.outcome
    ));
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
