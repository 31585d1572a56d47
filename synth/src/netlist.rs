//! The netlist that synthesis makes of a unit, as Verilog that a simulator runs: what is on the device, not what was
//! meant.

use crate::error::SynthError;
use crate::target::{Family, Target};
use crate::tools::{Tool, YOSYS};
use crate::yosys;
use imogene_contract::Request;
use imogene_rtl::emit::emit;
use imogene_tools::{read, scratch, write};
use std::collections::{BTreeMap, BTreeSet};

/// A synthesised unit with the models of its cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Netlist {
    /// Name of the top module; its ports are those of the unit.
    pub top: String,
    /// The netlist, and the simulation model of each cell in it from the library of Yosys.
    pub text: String,
    /// Cells by type.
    pub cells: yosys::CellCounts,
}

const STATISTICS: &str = "netlist.stat";
const SYNTHESISED: &str = "netlist.json";
const NETLIST: &str = "netlist.v";

/// Synthesises a unit, without a harness, before place and route. Fails when the request is not legal, the target has
/// no models of its cells, Yosys is missing or fails.
pub fn netlist(request: &Request, target: Target) -> Result<Netlist, SynthError> {
    libraries(target)?;
    let emitted = emit(request)?;
    let yosys = Tool::find(YOSYS)?;
    let folder = scratch()?;
    let folder = folder.path();
    write(&folder.join("unit.v"), &emitted.bundle())?;
    let script = format!(
        "read_verilog unit.v; {}; delete t:$scopeinfo; write_json {SYNTHESISED}",
        target.synthesis(&emitted.top),
    );
    yosys::run(&yosys, folder, &script)?;
    target.fold(&folder.join(SYNTHESISED))?;
    let script = format!(
        // Single wires: a vector of which one bit depends on another looks like a loop to a simulator.
        "read_json {SYNTHESISED}; delete =A:blackbox; splitnets; write_verilog -noattr {NETLIST}; \
         tee -q -o {STATISTICS} {}",
        target.statistics()
    );
    yosys::run(&yosys, folder, &script)?;
    let cells = yosys::parse_statistics(&read(&folder.join(STATISTICS))?)?.cells;
    let names: Vec<&str> = cells.keys().map(String::as_str).collect();
    Ok(Netlist {
        top: emitted.top,
        text: read(&folder.join(NETLIST))? + &cell_models(&names, target)?,
        cells,
    })
}

/// The simulation models of cells, from the library of Yosys. Fails when there are none, or Yosys is missing or fails.
pub fn cell_models(cells: &[&str], target: Target) -> Result<String, SynthError> {
    let libraries = libraries(target)?;
    let folder = scratch()?;
    let copies = libraries.iter().enumerate();
    let copies = copies.map(|(k, file)| format!("write_file cells_{k}.v +/{file}"));
    let script = copies.collect::<Vec<_>>().join("; ");
    yosys::run(&Tool::find(YOSYS)?, folder.path(), &script)?;
    let mut models = BTreeMap::new();
    let mut text = NO_PORT_DEFAULTS.to_owned();
    for k in 0..libraries.len() {
        let library = read(&folder.path().join(format!("cells_{k}.v")))?;
        text += &macros(&library);
        models.extend(modules(&library));
    }
    for model in used(&models, cells, target)? {
        text.push('\n');
        text += model;
    }
    Ok(text)
}

/// The models of iCE40 give ports a default, which is SystemVerilog, unless they are told not to.
const NO_PORT_DEFAULTS: &str = "\n`define NO_ICE40_DEFAULT_ASSIGNMENTS\n";

/// Files of the library of Yosys that hold the models.
fn libraries(target: Target) -> Result<&'static [&'static str], SynthError> {
    match target.family() {
        Family::Ice40 => Ok(&["ice40/cells_sim.v"]),
        Family::Ecp5 => Ok(&[
            "ecp5/cells_sim.v",
            "ecp5/common_sim.vh",
            "ecp5/ccu2c_sim.vh",
        ]),
        Family::Gowin => Ok(&["gowin/cells_sim.v"]),
        Family::Xilinx7 | Family::Gates => Err(SynthError::NoModels(target.name())),
    }
}

/// The macros that a file defines before its first module.
fn macros(text: &str) -> String {
    let head = text.lines().take_while(|line| !line.starts_with("module "));
    let directives = head.filter(|line| line.starts_with('`') && !line.starts_with("`include"));
    directives.map(|line| format!("{line}\n")).collect()
}

/// The modules of a file by name, without the attributes before them.
pub fn modules(text: &str) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    let mut current: Option<(String, String)> = None;
    for line in text.lines() {
        if let Some(rest) = line.strip_prefix("module ") {
            let end = rest.find(|c: char| !is_word(c)).unwrap_or(rest.len());
            current = Some((rest[..end].to_owned(), String::new()));
        }
        let Some((_, body)) = &mut current else {
            continue;
        };
        body.push_str(line);
        body.push('\n');
        if line.starts_with("endmodule") {
            found.extend(current.take());
        }
    }
    found
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// The models of the cells in a netlist, and of the cells in those. Fails when a cell has no model.
pub fn used<'a>(
    models: &'a BTreeMap<String, String>,
    cells: &[&str],
    target: Target,
) -> Result<Vec<&'a str>, SynthError> {
    let mut open = cells.to_vec();
    let mut taken = BTreeSet::new();
    while let Some(name) = open.pop() {
        if !taken.insert(name) {
            continue;
        }
        let none = || SynthError::NoModel(target.name(), name.to_owned());
        let text = models.get(name).ok_or_else(none)?;
        let words = text.split(|c| !is_word(c));
        open.extend(words.filter(|word| models.contains_key(*word)));
    }
    Ok(taken.iter().map(|name| models[*name].as_str()).collect())
}
