//! `imogene prove`.

use crate::arguments::Prove;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_verif::formal::mutants;
use imogene_verif::formal::runner::{ProofReport, Task, Verdict, prove_all, select};
use imogene_verif::formal::toolchain::Toolchain;

pub fn run(options: &Prove, json: bool) -> Result {
    let jobs = select(&options.name, options.full)?;
    let mut tasks = vec![];
    for job in jobs {
        if options.mutants {
            tasks.extend(mutants::of(&job.name).map(|mutant| Task {
                job: job.clone(),
                mutant: Some(mutant),
            }));
        } else {
            tasks.push(Task { job, mutant: None });
        }
    }
    if tasks.is_empty() {
        return Err(Failure::Input(format!(
            "the proofs of `{}` have no mutants; the mutants are of {}",
            options.name,
            mutants::jobs().join(", ")
        )));
    }
    let tools = Toolchain::find()?;
    let bar = output::progress(tasks.len() as u64, "proofs");
    // Proofs take minutes: a person sees each when it is done.
    let done = |report: &ProofReport| {
        bar.inc(1);
        if !json {
            bar.suspend(|| output::text(describe(report)));
        }
    };
    let reports = prove_all(&tasks, &tools, done)?;
    bar.finish_and_clear();
    output::report(json, &reports, |_| {
        output::text(format!("tools: {}", tools.versions.join(", ")));
    });
    verdict(&reports)
}

fn describe(report: &ProofReport) -> String {
    let result = match report.result {
        Verdict::Proved => "proved",
        Verdict::Refuted => "refuted",
        Verdict::Open => "open",
    };
    let what = report.mutant.as_ref().unwrap_or(&report.statement);
    let mut text = format!(
        "{result:<8} {:<28} {:<24} {:>6.1} s  {what}",
        report.name, report.method, report.seconds
    );
    if let Some(detail) = &report.detail {
        text += &format!("\n         {detail}");
    }
    text
}

/// Success if every property is proved, or every mutant refuted.
fn verdict(reports: &[ProofReport]) -> Result {
    let bad: Vec<&ProofReport> = reports.iter().filter(|report| !report.ok).collect();
    if bad.is_empty() {
        return Ok(());
    }
    let mut text = format!("{} of {} are not as they must be", bad.len(), reports.len());
    for report in bad {
        text += &format!("\n  {}", report.name);
        if let Some(mutant) = &report.mutant {
            text += &format!(", mutant `{mutant}` not refuted");
        }
        if let Some(detail) = &report.detail {
            text += &format!(": {detail}");
        }
        if let Some(folder) = &report.folder {
            text += &format!("\n    sources and trace: {}", folder.display());
        }
    }
    Err(Failure::Check(text))
}
