//! Proves the emitted units the same circuits as those of a folder that `scripts/archive-verilog` wrote:
//! `cargo run --release -p imogene-verif --example same_as -- target/archive/verilog 16 [UNIT ..]`.
//! Block memories of many bits are too large for a proof; there co-simulation stands in.

use imogene_contract::{Request, Unit};
use imogene_rtl::emit::{design, emit};
use imogene_verif::equivalence::{Text, Verdict, compare, memory_bits};
use std::fs::{read_dir, read_to_string};
use std::path::Path;

/// Bits of memory that a proof takes too long for.
const LARGE: u32 = 4096;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [folder, word, names @ ..] = &arguments[..] else {
        return Err("usage: same_as FOLDER DEPTH_WORD [UNIT ..]".into());
    };
    let mut differing = vec![];
    let is_wanted = |unit: &Unit| names.is_empty() || names.iter().any(|name| name == unit.name());
    for unit in Unit::ALL.into_iter().filter(is_wanted) {
        let request = Request::of(unit, word.parse()?);
        if memory_bits(&design(&request)?.top) > LARGE {
            println!("{}: has a large memory", unit.name());
            continue;
        }
        let mut archived = String::new();
        for file in read_dir(Path::new(folder).join(word).join(unit.name()))? {
            let path = file?.path();
            if path.extension().is_some_and(|extension| extension == "v") {
                archived += &read_to_string(path)?;
            }
        }
        let emitted = emit(&request)?;
        let today = emitted.bundle();
        let texts = [&archived, &today].map(|verilog| Text {
            top: unit.name(),
            verilog,
        });
        let [before, now] = texts;
        let verdict = compare(before, now)?;
        println!("{}: {verdict:?}", unit.name());
        if verdict != Verdict::Equal {
            differing.push(unit.name());
        }
    }
    match differing.as_slice() {
        [] => Ok(()),
        names => Err(format!("not proven the same: {}", names.join(", ")).into()),
    }
}
