//! The emitted Verilog in Icarus Verilog: a process for each instance, a line of inputs and of outputs every clock.
//!
//! It knows undefined bits, so that it shows what nothing drives or sets, where the other engines read 0.

use super::design::{Design, DesignError, Instance, Source};
use crate::signal::Signal;
use imogene_tools::{ICARUS, ToolError, VVP, scratch, write};
use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdout, Command, Stdio};
use std::sync::Arc;
use tempfile::TempDir;

/// Name of the bench module around the design.
const BENCH: &str = "imogene_bench";
const COMPILED: &str = "design.vvp";

/// Compiles a design.
pub fn compile(source: &Source) -> Result<Design, DesignError> {
    let folder = scratch().map_err(ToolError::from)?;
    for (name, text) in [("design.v", source.text), ("bench.v", &bench(source))] {
        write(&folder.path().join(name), text).map_err(ToolError::from)?;
    }
    let arguments = ["-g2005", "-s", BENCH, "-o", COMPILED, "bench.v", "design.v"];
    ICARUS.run(arguments, folder.path())?;
    // Found missing here, and not when the first instance starts.
    VVP.run(["-V"], folder.path())?;
    let folder = Arc::new(folder);
    let [inputs, outputs] = [source.inputs, source.outputs].map(Arc::<[Signal]>::from);
    Ok(Box::new(move || {
        Box::new(IcarusInstance {
            process: start(folder.path()),
            _folder: folder.clone(),
            inputs: inputs.clone(),
            outputs: outputs.clone(),
            line: String::new(),
        })
    }))
}

struct IcarusInstance {
    /// None when the process could not be started or has ended: nothing is defined then.
    process: Option<Process>,
    /// Keeps what is compiled until the last instance is gone.
    _folder: Arc<TempDir>,
    inputs: Arc<[Signal]>,
    outputs: Arc<[Signal]>,
    line: String,
}

struct Process {
    child: Child,
    stdout: BufReader<ChildStdout>,
}

fn start(folder: &Path) -> Option<Process> {
    let mut child = Command::new(VVP.name)
        .args(["-n", COMPILED])
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .ok()?;
    let stdout = BufReader::new(child.stdout.take()?);
    Some(Process { child, stdout })
}

impl Process {
    fn exchange(&mut self, line: &mut String) -> std::io::Result<()> {
        let stdin = self.child.stdin.as_mut().expect("a pipe was asked for");
        stdin.write_all(line.as_bytes())?;
        line.clear();
        self.stdout.read_line(line)?;
        Ok(())
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // This closes its input, and the bench ends where that does.
        let _ = self.child.wait();
    }
}

impl Instance for IcarusInstance {
    fn clock(&mut self, inputs: &[u64], outputs: &mut [Option<u64>]) {
        self.line.clear();
        for (word, signal) in inputs.iter().zip(&*self.inputs) {
            let digits = signal.width.div_ceil(4) as usize;
            let _ = write!(self.line, "{word:0digits$x} ");
        }
        self.line.push('\n');
        outputs.fill(None);
        let Some(process) = &mut self.process else {
            return;
        };
        let outcome = process.exchange(&mut self.line);
        let mut fields = self.line.split_ascii_whitespace();
        for (place, signal) in outputs.iter_mut().zip(&*self.outputs) {
            let field = fields.next();
            let field = field.filter(|bits| bits.len() == signal.width as usize);
            *place = field.and_then(|bits| u64::from_str_radix(bits, 2).ok());
        }
        if outcome.is_err() || self.line.is_empty() {
            eprintln!(
                "{} ended before its input did; its outputs count as undefined from here",
                VVP.name
            );
            self.process = None;
        }
    }
}

/// The bench: a line of hexadecimal numbers in, a clock, a line of binary numbers out.
fn bench(source: &Source) -> String {
    let mut text =
        format!("`timescale 1ns/1ps\nmodule {BENCH};\n  reg clock = 1'b0;\n  integer fields;\n");
    let mut connections = String::from("    .clock(clock)");
    for (kind, signals) in [("reg", source.inputs), ("wire", source.outputs)] {
        for Signal { name, width, .. } in signals {
            let _ = writeln!(text, "  {kind} [{}:0] port_{name};", width - 1);
            let _ = write!(connections, ",\n    .{name}(port_{name})");
        }
    }
    let list = |signals: &[Signal]| -> String {
        let names = signals.iter().map(|s| format!(", port_{}", s.name));
        names.collect()
    };
    let format = |letter: &str, count: usize| vec![letter; count].join(" ");
    let read = format!(
        "fields = $fscanf(32'h8000_0000, \"{}\"{});",
        format("%h", source.inputs.len()),
        list(source.inputs)
    );
    let _ = write!(
        text,
        "  {top} dut (
{connections}
  );
  initial begin
    {read}
    while (fields == {count}) begin
      #5 clock = 1'b1;
      #4 $display(\"{found}\"{outputs});
      $fflush(32'h8000_0001);
      #1 clock = 1'b0;
      {read}
    end
    $finish;
  end
endmodule
",
        top = source.top,
        count = source.inputs.len(),
        found = format("%b", source.outputs.len()),
        outputs = list(source.outputs),
    );
    text
}
