//! What the tests share: shapes, a random source and the Verilog tools.

use imogene_contract::{Request, Unit};
use imogene_rtl::emit::Emitted;
use std::path::PathBuf;
use std::process::{Command, Output};

/// A small random source (splitmix64).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
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
    let request = |unit, (depth_word, planes, rows_per_stage, objects)| {
        let usual = Request::of(unit, depth_word);
        Request {
            // A polyhedron has a plane at least.
            planes: u32::max(planes, u32::from(unit == Unit::PolyhedronProcessor)),
            digits: if planes == 0 { 1 } else { usual.digits },
            rows_per_stage,
            objects,
            ..usual
        }
    };
    let of = |unit| shapes.map(|shape| request(unit, shape));
    Unit::ALL.into_iter().flat_map(of).collect()
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
    for (file, text) in emitted.files() {
        std::fs::write(directory.join(file), text).unwrap();
    }
    directory
}
