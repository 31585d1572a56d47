//! Self-checking test benches with golden vectors, for users who run a unit in a simulator of their own.
//!
//! A bench reads stimulus, expected outputs and a mask of the bits that the golden model states, and compares with
//! `!==`, so an undefined bit is a mismatch too.

use crate::signal::Signal;
use crate::subject::{Inputs, Subject};
use std::fmt::Write as _;

/// Mismatches that a bench prints; it counts all.
const PRINTED: usize = 20;

/// Bits of a row of values, most significant first, as hexadecimal digits.
fn hex(signals: &[Signal], bits: impl Fn(usize, &Signal) -> u64) -> String {
    let width = total_width(signals) as usize;
    let mut binary = "0".repeat(width.next_multiple_of(4) - width);
    for (index, signal) in signals.iter().enumerate() {
        let width = signal.width as usize;
        let _ = write!(binary, "{:0width$b}", bits(index, signal));
    }
    let nibbles = binary.as_bytes().chunks(4).map(|nibble| {
        let value = nibble
            .iter()
            .fold(0, |acc, b| acc * 2 + u32::from(b - b'0'));
        char::from_digit(value, 16).expect("four bits")
    });
    nibbles.collect()
}

/// The self-checking bench for a stimulus and its vectors, as names and texts of files that lie in one folder:
/// `bench.v` (module `bench`) and what it reads, `stimulus.hex`, `expected.hex` (from the golden model) and `mask.hex`
/// (which bits the golden model states).
///
/// The bench prints `DONE` and how many clocks differ. If any does, it ends Icarus Verilog with exit code 1.
pub fn files(subject: &Subject, top: &str, stimulus: &[Inputs]) -> Vec<(&'static str, String)> {
    let mut golden = (subject.golden)();
    let (mut given, mut wanted, mut mask) = (String::new(), String::new(), String::new());
    for inputs in stimulus {
        let outputs = golden(inputs);
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
        kept = PRINTED,
    )
}
