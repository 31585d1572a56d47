//! Runs proofs, each in a temporary folder of its own, two at a time.

use super::FormalError;
use super::catalogue;
use super::driver::Run;
pub use super::driver::Verdict;
use super::job::{Job, Method};
use super::mutants::Mutant;
use super::toolchain::Toolchain;
use imogene_tools::FileError;
use rayon::prelude::*;
use serde::Serialize;
use std::path::PathBuf;
use std::time::Instant;

/// Jobs at the same time; each may run two solvers.
const JOBS_AT_ONCE: usize = 2;

/// Outcome of a job; the keys are stable.
#[derive(Clone, Debug, Serialize)]
pub struct ProofReport {
    /// Job.
    pub name: String,
    /// What is proved.
    pub statement: String,
    /// How.
    pub method: String,
    /// Widths and counts.
    pub widths: String,
    /// Edit of the design, if it was run on a mutant.
    pub mutant: Option<String>,
    /// Outcome.
    pub result: Verdict,
    /// Whether that is what is wanted: proved, or refuted on a mutant.
    pub ok: bool,
    /// The assertion that fails, or why the result is open.
    pub detail: Option<String>,
    /// Programs and their versions.
    pub tools: Vec<String>,
    /// Wall-clock time.
    pub seconds: f64,
    /// Folder with the sources and the trace, kept when the outcome is not the wanted one.
    pub folder: Option<PathBuf>,
}

/// One job on its design, or on a mutant of it.
#[derive(Clone, Debug)]
pub struct Task {
    /// Proof.
    pub job: Job,
    /// Edit of the design.
    pub mutant: Option<Mutant>,
}

/// The jobs of a name: one job, all jobs whose name begins with it, or `all`. Jobs for `--full` are among them only
/// with `full`, when named in full, or when there are no others.
pub fn select(name: &str, full: bool) -> Result<Vec<Job>, FormalError> {
    let jobs = catalogue::jobs();
    if let Some(job) = jobs.iter().find(|job| job.name == name) {
        return Ok(vec![job.clone()]);
    }
    let of_family = |job: &Job| {
        let rest = job.name.strip_prefix(name);
        name == "all" || rest.is_some_and(|rest| rest.starts_with('-'))
    };
    let (mut family, others): (Vec<Job>, Vec<Job>) = jobs.into_iter().partition(of_family);
    if family.is_empty() {
        let names: Vec<String> = others.into_iter().map(|job| job.name).collect();
        return Err(FormalError::Unknown(name.to_owned(), names.join(", ")));
    }
    if !full && family.iter().any(|job| !job.full) {
        family.retain(|job| !job.full);
    }
    Ok(family)
}

/// Runs tasks and calls `done` after each; reports come in the order of the tasks.
pub fn prove_all(
    tasks: &[Task],
    tools: &Toolchain,
    done: impl Fn(&ProofReport) + Sync,
) -> Result<Vec<ProofReport>, FormalError> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(JOBS_AT_ONCE)
        .build()
        .map_err(|error| FileError::at("threads")(std::io::Error::other(error)))?;
    let run = |task: &Task| {
        let report = prove(task, tools)?;
        done(&report);
        Ok(report)
    };
    // One at a time from the list, in its order, so that the long ones can be put first.
    pool.install(|| tasks.par_iter().with_max_len(1).map(run).collect())
}

/// The folder where a person finds it after the process, whose own temporary files are removed.
fn kept(folder: tempfile::TempDir) -> Result<PathBuf, FormalError> {
    let name = folder.path().file_name().unwrap_or_default();
    let lasting = std::env::temp_dir().join(name);
    let folder = folder.keep();
    std::fs::rename(&folder, &lasting).map_err(FileError::at(&lasting))?;
    Ok(lasting)
}

/// Runs one task.
pub fn prove(task: &Task, tools: &Toolchain) -> Result<ProofReport, FormalError> {
    let Task { job, mutant } = task;
    let text = job.source(mutant.as_ref())?;
    // A counterexample is looked for from the initial state.
    let method = match (mutant, job.method) {
        (Some(mutant), Method::Induction(_)) => Method::Bounded(mutant.clocks),
        (_, method) => method,
    };
    let folder = tempfile::Builder::new()
        .prefix("imogene-prove-")
        .tempdir()
        .map_err(FileError::at("temporary folder"))?;
    let begun = Instant::now();
    let run = Run {
        job,
        method,
        text: &text,
        folder: folder.path(),
        tools,
    };
    let (result, detail) = run.prove()?;
    let seconds = begun.elapsed().as_secs_f64();
    let wanted = match mutant {
        Some(_) => Verdict::Refuted,
        None => Verdict::Proved,
    };
    let ok = result == wanted;
    Ok(ProofReport {
        name: job.name.clone(),
        statement: job.statement.to_owned(),
        method: method.to_string(),
        widths: job.widths.clone(),
        mutant: mutant.as_ref().map(|mutant| mutant.name.to_owned()),
        result,
        ok,
        detail,
        tools: tools.versions.clone(),
        seconds,
        folder: if ok { None } else { Some(kept(folder)?) },
    })
}
