//! A routed ECP5 as Verilog: the cells that the router put into the part, for [`simulate`](crate::simulate).

use crate::error::BoardError;
use crate::top::{MODELS, TOP};
use imogene_synth::tools::Tool;
use imogene_synth::{SynthError, run_yosys};
use imogene_tools::{read, write};
use minijinja::{Environment, context};
use serde_json::{Map, Value, json};
use std::path::Path;

const CELLS: &str = include_str!("top/ecp5.v");

/// A cell of which there is a model: its type, the parameters that the model takes, those that have to be of a certain
/// value for it, and the inputs that have to stay at a level.
type Model = (
    &'static str,
    &'static [&'static str],
    &'static [(&'static str, &'static [&'static str])],
    &'static [(&'static str, &'static str)],
);

const FLIP_FLOP: &str = "TRELLIS_FF";
const MODELLED: [Model; 8] = [
    (
        "TRELLIS_COMB",
        &["MODE", "CCU2_INJECT1", "INITVAL"],
        &[("MODE", &["LOGIC", "CCU2"])],
        &[],
    ),
    (
        FLIP_FLOP,
        &["CLKMUX", "CEMUX", "LSRMUX", "REGSET", "SD"],
        &[("SRMODE", &["LSR_OVER_CE"]), ("LSRMODE", &["LSR"])],
        &[],
    ),
    (
        "DP16KD",
        &["DATA_WIDTH", "REGMODE", "INITVAL"],
        &[
            ("CSDECODE_A", &["0b000"]),
            ("CSDECODE_B", &["0b000"]),
            ("INIT_DATA", &["STATIC"]),
        ],
        &[("WEB", "0"), ("RSTA", "0"), ("RSTB", "0")],
    ),
    (
        "MULT18X18D",
        &["REG_INPUTA_CLK", "REG_INPUTB_CLK", "REG_OUTPUT_CLK"],
        &[
            ("REG_INPUTA_CLK", &["NONE", "CLK0"]),
            ("REG_INPUTB_CLK", &["NONE", "CLK0"]),
            ("REG_PIPELINE_CLK", &["NONE"]),
            ("REG_OUTPUT_CLK", &["NONE", "CLK0"]),
            ("MULT_BYPASS", &["DISABLED"]),
        ],
        &[],
    ),
    ("SIOLOGIC", &[], &[("MODE", &["IDDRX1_ODDRX1"])], &[]),
    ("DCCA", &[], &[], &[]),
    (
        "TRELLIS_IO",
        &["DATAMUX_ODDR"],
        &[("DIR", &["INPUT", "OUTPUT"])],
        &[],
    ),
    ("EHXPLLL", &[], &[], &[]),
];

/// Verilog of the netlist that the router wrote to a file of the folder; why there is none where it has a cell without
/// a model, or one that does what its model does not. Fails when the file is no netlist, or Yosys fails.
pub(crate) fn routed_verilog(
    yosys: &Tool,
    folder: &Path,
    file: &str,
) -> Result<Result<String, String>, BoardError> {
    let path = folder.join(file);
    let mut netlist: Value = serde_json::from_str(&read(&path)?)
        .map_err(|error| SynthError::report("nextpnr-ecp5", error))?;
    let modules = netlist["modules"].as_object_mut();
    for module in modules.into_iter().flat_map(Map::values_mut) {
        let cells = module["cells"].as_object_mut();
        for (name, cell) in cells.into_iter().flatten() {
            if let Err(problem) = settle(cell) {
                return Ok(Err(format!("{name}: {problem}")));
            }
        }
    }
    write(&path, &netlist.to_string())?;
    // The router calls every design so.
    let script = format!("read_json {file}; rename top {TOP}; write_verilog -noattr {file}.v");
    run_yosys(yosys, folder, &script)?;
    Ok(Ok(read(&folder.join(format!("{file}.v")))?))
}

/// The models of its cells.
pub(crate) fn routed_models() -> Result<String, BoardError> {
    let slices: Vec<String> = (0..64).map(|slice| format!("{slice:02X}")).collect();
    let cells = Environment::new().render_str(CELLS, context! { slices })?;
    Ok(format!("{MODELS}{cells}"))
}

/// Gives the open inputs of a cell their levels, and leaves it the parameters that its model takes. A cell is as Yosys
/// writes it in JSON. Fails when there is no model of the cell, or it does what its model does not.
pub fn settle(cell: &mut Value) -> Result<(), String> {
    let kind = text(&cell["type"]);
    let model = MODELLED.iter().find(|model| model.0 == kind);
    let &(_, taken, fixed, still) = model.ok_or_else(|| format!("no model of a {kind}"))?;
    for (name, accepted) in fixed {
        let value = &cell["parameters"][name];
        if !value.is_null() && !accepted.contains(&text(value).as_str()) {
            return Err(format!("no model of a {kind} whose {name} is {value}"));
        }
    }
    let directions = cell["port_directions"].as_object().cloned();
    let inputs = directions.into_iter().flatten();
    for (port, _) in inputs.filter(|(_, direction)| direction == "input") {
        let mux = text(&cell["parameters"][format!("{port}MUX")]);
        let net = &mut cell["connections"][&port];
        let is_open = net.as_array().is_none_or(Vec::is_empty);
        if is_open {
            *net = json!([level(&kind, &port, &mux)]);
        } else if mux == "INV" && kind != FLIP_FLOP {
            return Err(format!("no model of a {kind} with {port} inverted"));
        }
        let still = still.iter().find(|(name, _)| *name == port);
        if still.is_some_and(|(_, level)| *net != json!([level])) {
            return Err(format!("no model of a {kind} with a level at {port}"));
        }
        if is_open && port == "LSR" {
            cell["parameters"]["LSRMUX"] = "LSR".into();
        }
    }
    if kind == "TRELLIS_IO" {
        cell["type"] = format!("TRELLIS_{}", text(&cell["parameters"]["DIR"])).into();
    }
    if let Some(parameters) = cell["parameters"].as_object_mut() {
        let is_taken = |name: &String| taken.iter().any(|taken| name.starts_with(taken));
        parameters.retain(|name, _| is_taken(name));
    }
    Ok(())
}

/// The level of an input that the router leaves open: that of its multiplexer, and else a pull-up. A reset of a
/// flip-flop is never chosen then.
fn level(kind: &str, port: &str, mux: &str) -> &'static str {
    let is_low = matches!(mux, "0" | "INV") || (kind, port) == (FLIP_FLOP, "LSR");
    if is_low { "0" } else { "1" }
}

/// A text of the netlist, whose zeros and ones alone have a blank behind them.
fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().trim().to_owned()
}
