//! The vectors, and a bench in Icarus Verilog that runs all kernels on them.

use super::{NAMES, Tested, VECTORS, WIDTHS};
use std::fmt::Write;
use std::process::{Command, Output};

pub(super) fn vectors() -> Vec<[u64; 11]> {
    // A multiply-with-carry generator: the same vectors in every run.
    let mut state = 0x1234_5678_9abc_def1_u64;
    let mut next = || {
        state = (state & 0xffff_ffff) * 4_294_957_665 + (state >> 32);
        state & 0xffff_ffff
    };
    let mut word = |width: usize| {
        let ones = u64::MAX >> (64 - width);
        // One word in four is an edge: zero, one, all ones, the sign bit, the greatest positive.
        let edges = [0, 1, ones, 1 << (width - 1), ones >> 1];
        let value = match next() % 20 {
            place @ 0..5 => edges[place as usize],
            _ => next() << 32 | next(),
        };
        value & ones
    };
    (0..VECTORS).map(|_| WIDTHS.map(&mut word)).collect()
}

/// A bench that reads the vectors and prints the results of all kernels.
fn bench(kernels: &[Tested], stimulus: &str) -> String {
    let total: usize = WIDTHS.iter().sum();
    let mut text = format!(
        "module bench;\n  reg [{}:0] vectors [0:{}];\n  reg [{}:0] now;\n",
        total - 1,
        VECTORS - 1,
        total - 1
    );
    let mut high = total;
    let mut inputs = Vec::new();
    for (name, width) in NAMES.iter().zip(WIDTHS) {
        inputs.push(format!(".{name}(now[{}:{}])", high - 1, high - width));
        high -= width;
    }
    for (place, kernel) in kernels.iter().enumerate() {
        let _ = writeln!(
            text,
            "  wire [{}:0] out_{place};\n  {} unit_{place} ({}, .result(out_{place}));",
            kernel.width - 1,
            kernel.module,
            inputs.join(", ")
        );
    }
    let _ = writeln!(
        text,
        "  integer i;\n  initial begin\n    $readmemh(\"{stimulus}\", vectors);\n    for (i = 0; i < {VECTORS}; i = i + 1) begin\n      now = vectors[i]; #1;"
    );
    for place in 0..kernels.len() {
        let _ = writeln!(text, "      $display(\"%h\", out_{place});");
    }
    text + "    end\n  end\nendmodule\n"
}

/// The vectors as hexadecimal words, the first input in the highest bits.
fn stimulus(vectors: &[[u64; 11]]) -> String {
    let mut text = String::new();
    for vector in vectors {
        let words = vector.iter().zip(WIDTHS);
        let (high, low) = words.fold((0_u128, 0_u128), |(high, low), (word, width)| {
            (
                (high << width) | (low >> (128 - width)),
                (low << width) | u128::from(*word),
            )
        });
        let _ = writeln!(text, "{high:x}{low:032x}");
    }
    text
}

/// Results of all kernels, vector by vector, of the texts that `text` chooses; none where a bit is undefined. What Icarus says of the texts is
/// refused if they are to be clean.
pub(super) fn icarus(
    kernels: &[Tested],
    text: impl Fn(&Tested) -> &str,
    is_clean: bool,
    vectors: &[[u64; 11]],
) -> Vec<Option<u64>> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = |name: &str| {
        folder
            .path()
            .join(name)
            .to_str()
            .expect("a plain path")
            .to_owned()
    };
    std::fs::write(path("stimulus.hex"), stimulus(vectors)).expect("a written file");
    let mut text: String = kernels.iter().map(text).collect();
    text += &bench(kernels, &path("stimulus.hex"));
    std::fs::write(path("bench.v"), text).expect("a written file");
    let run = |tool: &str, arguments: &[&str]| {
        let output = tool_output(tool, arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let is_fine = output.status.success() && (said.is_empty() || !is_clean);
        assert!(is_fine, "{tool}: {said}");
        String::from_utf8(output.stdout).expect("plain text")
    };
    run(
        "iverilog",
        &[
            "-g2005",
            "-Wall",
            "-Wno-timescale",
            "-o",
            &path("bench.vvp"),
            &path("bench.v"),
        ],
    );
    run("vvp", &["-n", &path("bench.vvp")])
        .lines()
        .map(|line| u64::from_str_radix(line, 16).ok())
        .collect()
}

/// Icarus Verilog takes the text at all.
pub(super) fn is_legal(text: &str) -> bool {
    let file = tempfile::NamedTempFile::new().expect("a temporary file");
    std::fs::write(file.path(), text).expect("a written file");
    let path = file.path().to_str().expect("a plain path");
    let output = tool_output("iverilog", &["-g2005", "-o", "/dev/null", path]);
    output.status.success()
}

fn tool_output(tool: &str, arguments: &[&str]) -> Output {
    let output = Command::new(tool).args(arguments).output();
    output.unwrap_or_else(|error| {
        panic!("{tool} cannot be run ({error}); install the package `iverilog`")
    })
}
