//! Synthesis with Yosys, and its cell statistics.

use crate::error::SynthError;
use crate::target::Family;
use crate::tools::Tool;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// Cells by type, as Yosys counts them.
pub type CellCounts = BTreeMap<String, u64>;

/// Resources of a design, before packing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Resources {
    /// Look-up tables of logic, of any size; those of carry chains are not among them.
    pub lut: u64,
    /// Flip-flops.
    pub ff: u64,
    /// Carry cells, of the size of the family (1 bit iCE40 and Gowin, 2 bits ECP5, 4 bits Xilinx).
    pub carry: u64,
    /// Multiplier cells.
    pub dsp: u64,
    /// Block memories.
    pub bram: u64,
}

impl Resources {
    /// All counts, in their order.
    pub fn counts(&self) -> [u64; 5] {
        [self.lut, self.ff, self.carry, self.dsp, self.bram]
    }

    /// The resources of these counts.
    pub(crate) fn of([lut, ff, carry, dsp, bram]: [u64; 5]) -> Resources {
        Resources {
            lut,
            ff,
            carry,
            dsp,
            bram,
        }
    }
}

/// Statistics of one Yosys run.
#[derive(Clone, Debug, PartialEq)]
pub struct Statistics {
    /// Cells by type.
    pub cells: CellCounts,
    /// Transistors in static CMOS gates, where they were asked for.
    pub transistors: Option<u64>,
    /// Area in square micrometres, where a library of cells says it.
    pub area: Option<f64>,
}

/// The pass that makes products by Booth's recoding. A Yosys without it makes them of all digits.
const BOOTH: &str = "booth; ";

/// Runs a script of Yosys in a folder; file names in it are relative to the folder. Fails when Yosys refuses its
/// input.
pub fn run(tool: &Tool, folder: &Path, script: &str) -> Result<(), SynthError> {
    match run_all(tool, folder, script) {
        Err(SynthError::Tool { message, .. }) if message.contains("No such command: booth") => {
            run_all(tool, folder, &script.replace(BOOTH, ""))
        }
        ran => ran,
    }
}

/// Runs a script with every pass that it names.
fn run_all(tool: &Tool, folder: &Path, script: &str) -> Result<(), SynthError> {
    let arguments = ["-q", "-l", "yosys.log", "-p", script];
    tool.run(&arguments, folder).map_err(|error| match error {
        SynthError::Tool { message, .. } if message.is_empty() => {
            let logged = std::fs::read_to_string(folder.join("yosys.log"));
            SynthError::tool(tool.name, &logged.unwrap_or_default())
        }
        error => error,
    })
}

/// Reads what `stat -json` wrote. Fails when it is none, or the transistors do not count every cell.
pub fn parse_statistics(text: &str) -> Result<Statistics, SynthError> {
    let bad = |problem: String| SynthError::report("yosys", problem);
    // `tee` may put the heading of the command before the document.
    let start = text
        .find('{')
        .ok_or_else(|| bad("no JSON document".into()))?;
    let document: Value =
        serde_json::from_str(&text[start..]).map_err(|error| bad(error.to_string()))?;
    // Of one module there is no sum over the design.
    let design = match (&document["design"], document["modules"].as_object()) {
        (Value::Null, Some(modules)) => modules.values().next().unwrap_or(&Value::Null),
        (design, _) => design,
    };
    let cells = CellCounts::deserialize(&design["num_cells_by_type"])
        .map_err(|error| bad(format!("design.num_cells_by_type: {error}")))?;
    let transistors = match &design["estimated_num_transistors"] {
        Value::Null => None,
        // A number followed by `+` leaves cells out.
        Value::String(count) => {
            let partial = |_| bad(format!("`{count}` transistors do not count every cell"));
            Some(count.parse().map_err(partial)?)
        }
        other => return Err(bad(format!("{other} transistors"))),
    };
    Ok(Statistics {
        cells,
        transistors,
        area: design["area"].as_f64(),
    })
}

/// Sums cells into resources; gates have none.
pub fn resources(family: Family, cells: &CellCounts) -> Resources {
    let kinds: [&[&str]; 5] = match family {
        Family::Ice40 => [
            &["SB_LUT4"],
            &["SB_DFF"],
            &["SB_CARRY"],
            &["SB_MAC16"],
            &["SB_RAM40_4K", "SB_SPRAM256KA"],
        ],
        Family::Ecp5 => [
            &["LUT4"],
            &["TRELLIS_FF"],
            &["CCU2C"],
            &["MULT18X18D", "ALU54B"],
            &["DP16KD", "PDPW16KD"],
        ],
        // Shift registers and memories of a few words sit in look-up tables.
        Family::Xilinx7 => [
            &["LUT", "SRL", "RAM32", "RAM64", "RAM128", "RAM256"],
            &["FD"],
            &["CARRY4"],
            &["DSP48"],
            &["RAMB"],
        ],
        Family::Gowin => [
            &["LUT", "RAM16"],
            &["DFF"],
            &["ALU"],
            &["MULT", "ALU54"],
            &["DP", "SDP", "SP", "ROM", "pROM"],
        ],
        Family::Gates => return Resources::default(),
    };
    let sum = |prefixes: &[&str]| {
        let is_meant = |name: &str| prefixes.iter().any(|prefix| name.starts_with(prefix));
        let matching = cells.iter().filter(|(name, _)| is_meant(name));
        matching.map(|(_, count)| count).sum()
    };
    Resources {
        // By whole name: Gowin's ALU is a carry cell, its ALU54D belongs to a multiplier.
        carry: kinds[2].iter().filter_map(|name| cells.get(*name)).sum(),
        ..Resources::of(kinds.map(sum))
    }
}
