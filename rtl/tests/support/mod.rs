//! What the tests share: shapes, a random source, the Verilog tools and a generated test bench.
#![allow(dead_code)]

use imogene_contract::{Request, Unit};
use imogene_rtl::emit::{Direction, Emitted, emit};
use std::fmt::Write;
use std::path::PathBuf;
use std::process::{Command, Output};

/// A small random source (splitmix64) with a liking for extreme words.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, bound: u64) -> u64 {
        self.next() % bound
    }

    /// A number of some magnitude up to `bits` bits, at times an extreme one.
    pub fn number(&mut self, bits: u32) -> i64 {
        let extreme = 1_i64 << (bits - 1);
        match self.below(8) {
            0 => -extreme,
            1 => extreme.wrapping_sub(1),
            2 => 0,
            3 => -1,
            _ => {
                let shift = 64 - bits + self.below(u64::from(bits)) as u32;
                (self.next() as i64) >> shift
            }
        }
    }
}

/// Every unit in shapes that reach the ends of the ranges.
pub fn requests() -> Vec<Request> {
    let shapes = [
        (24, 3, 1, 4),
        (16, 0, 16, 1),
        (20, 1, 7, 2),
        (28, 2, 5, 3),
        (32, 12, 4, 5),
    ];
    let request = |unit, (depth_word, planes, rows_per_stage, objects)| Request {
        // A polyhedron has a plane at least.
        planes: u32::max(planes, u32::from(unit == Unit::PolyhedronProcessor)),
        rows_per_stage,
        objects,
        ..Request::of(unit, depth_word)
    };
    Unit::ALL
        .into_iter()
        .flat_map(|unit| shapes.map(|shape| request(unit, shape)))
        .collect()
}

/// A fresh directory for a test.
pub fn directory(name: &str) -> PathBuf {
    let directory = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&directory);
    std::fs::create_dir_all(&directory).unwrap();
    directory
}

/// Runs a Verilog tool; a missing tool fails the test and names its package.
pub fn run(tool: &str, package: &str, arguments: &[&str]) -> Output {
    match Command::new(tool).args(arguments).output() {
        Ok(output) => output,
        Err(error) => panic!("{tool} cannot be run ({error}); install the package `{package}`"),
    }
}

/// Writes a unit as one file in a directory of its own.
pub fn write(name: &str, emitted: &Emitted) -> PathBuf {
    let file = directory(name).join(format!("{}.v", emitted.top));
    std::fs::write(&file, emitted.bundle()).unwrap();
    file
}

/// Writes a unit as one file for each module in an empty directory of its own.
pub fn write_split(name: &str, emitted: &Emitted) -> PathBuf {
    let directory = directory(name);
    std::fs::remove_dir_all(&directory).unwrap();
    std::fs::create_dir(&directory).unwrap();
    for (file, text) in emitted.files() {
        std::fs::write(directory.join(file), text).unwrap();
    }
    directory
}

/// Output words, in the order of the ports, after each clock of the emitted Verilog in Icarus Verilog.
pub fn icarus(name: &str, request: &Request, stimulus: &[Vec<u64>]) -> Vec<Vec<u64>> {
    let emitted = emit(request).unwrap();
    let file = write(name, &emitted);
    let directory = file.parent().expect("a file lies in a directory");
    let path = |file: &str| directory.join(file).to_str().unwrap().to_owned();
    std::fs::write(path("stimulus.hex"), stimulus_text(stimulus)).unwrap();
    std::fs::write(
        path("bench.v"),
        bench(&emitted, stimulus, &path("stimulus.hex")),
    )
    .unwrap();
    let compiled = run(
        "iverilog",
        "iverilog",
        &[
            "-g2005",
            "-o",
            &path("bench.vvp"),
            &path("bench.v"),
            file.to_str().unwrap(),
        ],
    );
    assert!(
        compiled.status.success(),
        "{}",
        String::from_utf8_lossy(&compiled.stderr)
    );
    let output = run("vvp", "iverilog", &["-n", &path("bench.vvp")]);
    assert!(output.status.success());
    let words = |line: &str| {
        line.split(' ')
            .map(|word| u64::from_str_radix(word, 16).unwrap_or(u64::MAX))
            .collect()
    };
    String::from_utf8(output.stdout)
        .unwrap()
        .lines()
        .map(words)
        .collect()
}

fn stimulus_text(stimulus: &[Vec<u64>]) -> String {
    let mut text = String::new();
    for word in stimulus.iter().flatten() {
        let _ = writeln!(text, "{word:x}");
    }
    text
}

fn bench(emitted: &Emitted, stimulus: &[Vec<u64>], file: &str) -> String {
    let inputs: Vec<_> = emitted
        .ports
        .iter()
        .filter(|port| port.direction == Direction::In && port.name != "clock")
        .collect();
    let outputs: Vec<_> = emitted
        .ports
        .iter()
        .filter(|port| port.direction == Direction::Out)
        .collect();
    assert!(
        stimulus.iter().all(|words| words.len() == inputs.len()),
        "one word for each input"
    );
    let mut text = String::from("module bench;\n  reg clock = 0;\n  integer i;\n");
    let _ = writeln!(
        text,
        "  reg [63:0] words [0:{}];",
        stimulus.len() * inputs.len() - 1
    );
    for port in &inputs {
        let _ = writeln!(text, "  reg [{}:0] {} = 0;", port.width - 1, port.name);
    }
    for port in &outputs {
        let _ = writeln!(text, "  wire [{}:0] {};", port.width - 1, port.name);
    }
    let ports: Vec<_> = emitted
        .ports
        .iter()
        .map(|port| format!(".{0}({0})", port.name))
        .collect();
    let _ = writeln!(text, "  {} dut ({});", emitted.top, ports.join(", "));
    let _ = writeln!(text, "  initial begin\n    $readmemh(\"{file}\", words);");
    let _ = writeln!(
        text,
        "    for (i = 0; i < {}; i = i + 1) begin",
        stimulus.len()
    );
    for (place, port) in inputs.iter().enumerate() {
        let _ = writeln!(
            text,
            "      {} = words[i * {} + {place}];",
            port.name,
            inputs.len()
        );
    }
    let format: Vec<_> = outputs.iter().map(|_| "%h").collect();
    let names: Vec<_> = outputs.iter().map(|port| port.name.as_str()).collect();
    let _ = writeln!(text, "      #1 clock = 1;");
    let _ = writeln!(
        text,
        "      #1 $display(\"{}\", {});",
        format.join(" "),
        names.join(", ")
    );
    let _ = writeln!(
        text,
        "      clock = 0;\n      #1;\n    end\n    $finish;\n  end\nendmodule"
    );
    text
}
