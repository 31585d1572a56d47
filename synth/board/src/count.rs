//! What a board takes of a part that no program places and routes here.

use crate::description::Board;
use crate::error::BoardError;
use crate::flow::too_little;
use crate::top::{Sources, TOP};
use imogene_synth::tools::{Tool, YOSYS};
use imogene_synth::{CellCounts, digest, kept, parse_statistics, run_yosys};
use imogene_tools::{read, scratch, write};
use std::collections::BTreeMap;

const REPORT: &str = "cells.json";

/// Look-up tables of a memory in tables, and of a shift register.
const TABLES: [(&str, u64); 9] = [
    ("RAM32M", 4),
    ("RAM64M", 4),
    ("RAM32X1D", 2),
    ("RAM64X1D", 2),
    ("RAM128X1D", 4),
    ("RAM128X1S", 2),
    ("RAM256X1S", 4),
    ("SRL16E", 1),
    ("SRLC32E", 1),
];

/// What the sources of a board take of its part by Yosys, used and available by kind.
///
/// # Errors
///
/// When Yosys is missing or fails, or the part has too little.
///
/// # Panics
///
/// When the board has no part.
pub fn count(board: &Board, sources: &Sources) -> Result<BTreeMap<String, (u64, u64)>, BoardError> {
    let part = board.part.as_ref().expect("a board with a part");
    let yosys = Tool::find(YOSYS)?;
    let script = format!(
        "read_verilog board.v; {} -top {TOP}; tee -q -o {REPORT} stat -json",
        part.synthesis()
    );
    let place = kept(&[&digest(&sources.verilog), &script, &yosys.version]);
    let cells: CellCounts = match place.load() {
        Some(cells) => cells,
        None => {
            let folder = scratch()?;
            let folder = folder.path();
            write(&folder.join("board.v"), &sources.verilog)?;
            run_yosys(&yosys, folder, &script)?;
            let cells = parse_statistics(&read(&folder.join(REPORT))?)?.cells;
            place.store(&cells)?;
            cells
        }
    };
    let kinds = part.cells.iter();
    let used: BTreeMap<_, _> = kinds
        .map(|(kind, &there)| (kind.clone(), (used(&cells, kind), there)))
        .collect();
    let too_few = used.iter().find(|(_, (used, there))| used > there);
    match too_few {
        Some((kind, (used, there))) => Err(too_little(part, format!("{used} {kind} of {there}"))),
        None => Ok(used),
    }
}

/// How many of a kind of cell of a part.
fn used(cells: &CellCounts, kind: &str) -> u64 {
    let takes: fn(&str) -> u64 = match kind {
        "LUT" => tables,
        "FF" => |name| name.starts_with("FD").into(),
        "RAMB36" => halves,
        _ => |name| name.starts_with("DSP48").into(),
    };
    let counts = cells.iter().map(|(name, count)| takes(name) * count);
    let sum: u64 = counts.sum();
    match kind {
        "RAMB36" => sum.div_ceil(2),
        _ => sum,
    }
}

/// Look-up tables of a cell.
fn tables(name: &str) -> u64 {
    let known = TABLES.iter().find(|(known, _)| *known == name);
    let is_table = name.strip_prefix("LUT").is_some_and(|size| size.len() == 1);
    known.map_or(u64::from(is_table), |&(_, tables)| tables)
}

/// Half block memories of a cell.
fn halves(name: &str) -> u64 {
    match name {
        "RAMB36E1" => 2,
        "RAMB18E1" => 1,
        _ => 0,
    }
}
