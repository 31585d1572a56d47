//! What a board takes of a part that no program places and routes here.

use crate::description::Board;
use crate::error::BoardError;
use crate::flow::too_little;
use crate::top::{Sources, TOP};
use imogene_synth::tools::{Tool, YOSYS};
use imogene_synth::{CellCounts, Family, digest, kept, parse_statistics, resources, run_yosys};
use imogene_tools::{read, scratch, write};
use std::collections::BTreeMap;

const REPORT: &str = "cells.json";

/// Look-up tables that memories in them take beside the first.
const MORE_TABLES: [(&str, u64); 7] = [
    ("RAM32M", 3),
    ("RAM64M", 3),
    ("RAM32X1D", 1),
    ("RAM64X1D", 1),
    ("RAM128X1D", 3),
    ("RAM128X1S", 1),
    ("RAM256X1S", 3),
];

/// What the sources of a board take of its part by Yosys, used and available by kind. Fails when Yosys is missing or
/// fails, or the part has too little. Panics when the board has no part.
pub fn count(board: &Board, sources: &Sources) -> Result<BTreeMap<String, (u64, u64)>, BoardError> {
    let part = board.part.as_ref().expect("a board with a part");
    let yosys = Tool::find(YOSYS)?;
    let script = format!(
        "read_verilog board.v; {} -top {TOP}; tee -q -o {REPORT} stat -json",
        part.synthesis()
    );
    let place = kept(&[&digest(&sources.verilog), &script, &yosys.version]);
    let cells = place.or_made(|| {
        let folder = scratch()?;
        write(&folder.path().join("board.v"), &sources.verilog)?;
        run_yosys(&yosys, folder.path(), &script)?;
        let report = read(&folder.path().join(REPORT))?;
        Ok::<_, BoardError>(parse_statistics(&report)?.cells)
    })?;
    let of_kind = |(kind, &there): (&String, &u64)| (kind.clone(), (used(&cells, kind), there));
    let used: BTreeMap<_, _> = part.cells.iter().map(of_kind).collect();
    match used.iter().find(|(_, (used, there))| used > there) {
        Some((kind, (used, there))) => Err(too_little(part, format!("{used} {kind} of {there}"))),
        None => Ok(used),
    }
}

/// How many of a kind of cell of a part.
fn used(cells: &CellCounts, kind: &str) -> u64 {
    let sums = resources(Family::Xilinx7, cells);
    let count = |name: &str| cells.get(name).copied().unwrap_or(0);
    match kind {
        "LUT" => {
            let more = MORE_TABLES.iter().map(|&(name, more)| more * count(name));
            sums.lut + more.sum::<u64>()
        }
        "FF" => sums.ff,
        // Two halves are one.
        "RAMB36" => sums.bram - count("RAMB18E1") / 2,
        _ => sums.dsp,
    }
}
