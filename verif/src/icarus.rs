//! The emitted Verilog of a unit in Icarus Verilog, against golden vectors: rust-hdl's own simulator is no evidence about its Verilog.
//!
//! A self-checking bench reads stimulus, expected outputs and a mask of the bits that the golden model states, and compares with `!==`, so an
//! undefined bit is a mismatch too.

use crate::report::{Mismatch, Report};
use crate::signal::Signal;
use crate::subject::{Inputs, Subject};
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::time::Instant;
use thiserror::Error;

/// Why the bench could not be run.
#[derive(Debug, Error)]
pub enum IcarusError {
    /// Icarus Verilog is not there.
    #[error("Icarus Verilog is not installed ({0}); install the package 'iverilog'")]
    Missing(String),
    /// Icarus refused the Verilog.
    #[error("Icarus Verilog refused the design:\n{0}")]
    Refused(String),
    /// A file or process failed.
    #[error("Icarus Verilog bench: {0}")]
    Io(#[from] std::io::Error),
    /// The bench printed something else than its result.
    #[error("the bench ended without a result:\n{0}")]
    NoResult(String),
}

/// Runs a stimulus through the emitted Verilog `text` (module `top`) and compares every stated bit on every clock.
pub fn run(
    subject: &Subject,
    top: &str,
    text: &str,
    stimulus: &[Inputs],
) -> Result<Report, IcarusError> {
    let started = Instant::now();
    let folder = tempfile::tempdir()?;
    let expected = golden_outputs(subject, stimulus);
    for (name, text) in files(subject, top, stimulus, &expected) {
        std::fs::write(folder.path().join(name), text)?;
    }
    std::fs::write(folder.path().join("dut.v"), text)?;
    let output = compile_and_run(folder.path())?;
    let mut report = Report {
        subject: subject.name.clone(),
        engine: "icarus".into(),
        cycles: stimulus.len() as u64,
        ..Report::default()
    };
    score(subject, &expected, &output, &mut report)?;
    report.timed(started.elapsed().as_secs_f64());
    Ok(report)
}

/// Runs several stimuli, each from reset, and adds up what was found.
pub fn run_all(
    subject: &Subject,
    top: &str,
    text: &str,
    stimuli: &[Vec<Inputs>],
) -> Result<Report, IcarusError> {
    let mut total = Report {
        subject: subject.name.clone(),
        engine: "icarus".into(),
        ..Report::default()
    };
    let mut seconds = 0.0;
    for stimulus in stimuli {
        let report = run(subject, top, text, stimulus)?;
        seconds += report.seconds;
        total.absorb(report);
    }
    total.timed(seconds);
    Ok(total)
}

fn golden_outputs(subject: &Subject, stimulus: &[Inputs]) -> Vec<Vec<Option<i64>>> {
    let mut golden = (subject.golden)();
    stimulus.iter().map(|inputs| golden.clock(inputs)).collect()
}

/// Bits of a row of values, most significant first, as hexadecimal digits.
fn hex(signals: &[Signal], bits: impl Fn(usize, &Signal) -> u64) -> String {
    let mut binary = String::new();
    for (index, signal) in signals.iter().enumerate() {
        let value = bits(index, signal);
        for bit in (0..signal.width).rev() {
            binary.push(if (value >> bit) & 1 == 1 { '1' } else { '0' });
        }
    }
    let padding = (4 - binary.len() % 4) % 4;
    let padded = "0".repeat(padding) + &binary;
    padded
        .as_bytes()
        .chunks(4)
        .map(|nibble| {
            let value = nibble
                .iter()
                .fold(0, |acc, b| acc * 2 + u32::from(b - b'0'));
            char::from_digit(value, 16).expect("four bits")
        })
        .collect()
}

/// The self-checking bench for a stimulus and its vectors, as names and texts of files that lie in one folder: `bench.v` (module `bench`) and
/// what it reads, `stimulus.hex`, `expected.hex` (from the golden model) and `mask.hex` (which bits the golden model states).
///
/// The bench prints `DONE` and the number of clocks that differ. If there are any it ends Icarus Verilog with exit code 1.
pub fn bench_files(
    subject: &Subject,
    top: &str,
    stimulus: &[Inputs],
) -> Vec<(&'static str, String)> {
    files(subject, top, stimulus, &golden_outputs(subject, stimulus))
}

fn files(
    subject: &Subject,
    top: &str,
    stimulus: &[Inputs],
    expected: &[Vec<Option<i64>>],
) -> Vec<(&'static str, String)> {
    let (mut given, mut wanted, mut mask) = (String::new(), String::new(), String::new());
    for (inputs, outputs) in stimulus.iter().zip(expected) {
        given += &hex(&subject.inputs, |k, s| s.bits(inputs[k]));
        wanted += &hex(&subject.outputs, |k, s| s.bits(outputs[k].unwrap_or(0)));
        mask += &hex(&subject.outputs, |k, s| match outputs[k] {
            Some(_) => s.bits(-1),
            None => 0,
        });
        for text in [&mut given, &mut wanted, &mut mask] {
            text.push('\n');
        }
    }
    vec![
        ("bench.v", bench(subject, top, stimulus.len())),
        ("stimulus.hex", given),
        ("expected.hex", wanted),
        ("mask.hex", mask),
    ]
}

fn total_width(signals: &[Signal]) -> u32 {
    signals.iter().map(|s| s.width).sum()
}

/// The self-checking bench: inputs change while the clock is low, outputs are compared after the rising edge.
fn bench(subject: &Subject, top: &str, clocks: usize) -> String {
    let (inputs, outputs) = (total_width(&subject.inputs), total_width(&subject.outputs));
    let mut connections = String::from("    .clock(clock)");
    for (vector, signals) in [("given", &subject.inputs), ("found", &subject.outputs)] {
        let mut high = total_width(signals);
        for signal in signals {
            high -= signal.width;
            let _ = write!(
                connections,
                ",\n    .{}({vector}[{high} +: {}])",
                signal.name, signal.width
            );
        }
    }
    format!(
        "`timescale 1ns/1ps
module bench;
  reg clock = 1'b0;
  reg [{i}:0] stimulus [0:{last}];
  reg [{o}:0] expected [0:{last}];
  reg [{o}:0] mask [0:{last}];
  reg [{i}:0] given;
  wire [{o}:0] found;
  integer n;
  integer bad;
  {top} dut (
{connections}
  );
  initial begin
    $readmemh(\"stimulus.hex\", stimulus);
    $readmemh(\"expected.hex\", expected);
    $readmemh(\"mask.hex\", mask);
    bad = 0;
    for (n = 0; n <= {last}; n = n + 1) begin
      given = stimulus[n];
      #5 clock = 1'b1;
      #4 if ((found & mask[n]) !== (expected[n] & mask[n])) begin
        bad = bad + 1;
        if (bad <= {kept}) $display(\"MISMATCH %0d %b\", n, found);
      end
      #1 clock = 1'b0;
    end
    $display(\"DONE %0d\", bad);
`ifdef __ICARUS__
    if (bad != 0) $finish_and_return(1);
`endif
    $finish;
  end
endmodule
",
        i = inputs - 1,
        o = outputs - 1,
        last = clocks - 1,
        kept = crate::report::KEPT,
    )
}

fn compile_and_run(folder: &Path) -> Result<String, IcarusError> {
    let run = |program: &str, arguments: &[&str]| {
        Command::new(program)
            .args(arguments)
            .current_dir(folder)
            .output()
            .map_err(|e| match e.kind() {
                std::io::ErrorKind::NotFound => {
                    IcarusError::Missing(format!("'{program}' was not found"))
                }
                _ => IcarusError::Io(e),
            })
    };
    let compiled = run(
        "iverilog",
        &["-g2005", "-o", "bench.vvp", "bench.v", "dut.v"],
    )?;
    if !compiled.status.success() {
        return Err(IcarusError::Refused(
            String::from_utf8_lossy(&compiled.stderr).into_owned(),
        ));
    }
    let done = run("vvp", &["-n", "bench.vvp"])?;
    Ok(String::from_utf8_lossy(&done.stdout).into_owned())
}

fn score(
    subject: &Subject,
    expected: &[Vec<Option<i64>>],
    output: &str,
    report: &mut Report,
) -> Result<(), IcarusError> {
    let no_result = || IcarusError::NoResult(output.to_string());
    let total: u64 = output
        .lines()
        .find_map(|line| line.strip_prefix("DONE "))
        .and_then(|count| count.trim().parse().ok())
        .ok_or_else(no_result)?;
    for row in expected {
        let stated = row.iter().flatten().count() as u64;
        report.comparisons += stated;
        report.pixels += u64::from(stated > 0);
    }
    for line in output.lines() {
        if let Some(rest) = line.strip_prefix("MISMATCH ") {
            let (cycle, bits) = rest.split_once(' ').ok_or_else(no_result)?;
            let cycle: usize = cycle.parse().map_err(|_| no_result())?;
            list_mismatches(subject, cycle, bits.trim(), &expected[cycle], report);
        }
    }
    report.mismatches = report.mismatches.max(total);
    Ok(())
}

fn list_mismatches(
    subject: &Subject,
    cycle: usize,
    bits: &str,
    expected: &[Option<i64>],
    report: &mut Report,
) {
    let mut at = 0;
    for (signal, golden) in subject.outputs.iter().zip(expected) {
        let field = &bits[at..at + signal.width as usize];
        at += signal.width as usize;
        let Some(golden) = *golden else { continue };
        let found = u64::from_str_radix(field, 2).ok().map(|b| signal.value(b));
        if found == Some(golden) {
            continue;
        }
        report.mismatches += 1;
        if report.first_mismatches.len() < crate::report::KEPT {
            let undefined = if found.is_none() {
                " (undefined bits)"
            } else {
                ""
            };
            report.first_mismatches.push(Mismatch {
                cycle: cycle as u64,
                pixel: None,
                signal: format!("{}{undefined}", signal.name),
                hardware: found.unwrap_or(0),
                golden,
            });
        }
    }
}
