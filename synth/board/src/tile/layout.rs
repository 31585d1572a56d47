//! The layout of a tile in cells of 180 nm, by the tools that Debian has.

use super::Tile;
use super::cells::{Library, Mapped};
use crate::error::BoardError;
use imogene_synth::kept;
use imogene_tools::{FileError, Program, read, scratch, write};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::Path;

/// The flow: placement by graywolf, routing by qrouter, times by vesta, layout and extraction by magic, comparison by
/// netgen.
const QFLOW: Program = Program::new("qflow", "qflow");
/// The cells, as the flow calls them.
const TECHNOLOGY: &str = "osu018";
/// The steps, and those of them that fail where they find errors: their logs count these.
const STEPS: [&str; 7] = [
    "synthesize",
    "place",
    "route",
    "backanno",
    "migrate",
    "drc",
    "lvs",
];
const CHECKS: [&str; 2] = ["drc", "lvs"];
/// Settings of the flow: the part of the rows that cells fill.
const SETTINGS: &str = "set initial_density = 0.75\n";

/// A tile that was placed and routed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Layout {
    /// Width and height in micrometres.
    pub micrometres: [f64; 2],
    /// Cells, with the buffers of the flow and without fillers.
    pub cells: u64,
    /// Nets.
    pub nets: u64,
    /// Of the nets those that could not be routed.
    pub unrouted: u64,
    /// The longest path between two registers, with its wires, in ns.
    pub longest_ns: f64,
    /// Errors of the rules of the layout.
    pub rule_errors: u64,
    /// Differences of what is extracted from the layout to the netlist.
    pub differences: u64,
}

/// The texts of a layout.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct LayoutTexts {
    /// The netlist with the buffers of the flow.
    pub verilog: String,
    /// Places of cells and wires, in DEF.
    pub def: String,
}

/// Places and routes a tile that is in the cells of 180 nm. What was made of the same netlist is kept. Errors in a
/// layout are counted. Fails when a tool is missing or fails. Panics when the tile is in other cells.
pub fn lay_out(tile: &Tile, mapped: &Mapped) -> Result<(Layout, LayoutTexts), BoardError> {
    assert_eq!(mapped.library, Library::Osu018, "cells with a layout");
    let place = kept(&[&mapped.verilog, &STEPS.join(" "), SETTINGS]);
    place.or_made(|| made(tile, mapped, scratch()?.path()))
}

fn made(tile: &Tile, mapped: &Mapped, folder: &Path) -> Result<(Layout, LayoutTexts), BoardError> {
    let top = &tile.top;
    for name in ["source", "synthesis", "layout", "log"] {
        let path = folder.join(name);
        std::fs::create_dir_all(&path).map_err(FileError::at(path))?;
    }
    let source = with_short_names(&mapped.verilog);
    write(&folder.join(format!("source/{top}.v")), &source)?;
    write(&folder.join("project_vars.sh"), SETTINGS)?;
    for step in STEPS {
        let said = QFLOW.run([step, "-T", TECHNOLOGY, top.as_str()], folder);
        if !CHECKS.contains(&step) {
            said?;
        }
    }
    let text = |name: &str| read(&folder.join(name));
    let log = |name: &str| text(&format!("log/{name}.log"));
    let def = text(&format!("layout/{top}.def"))?;
    let verilog = text(&format!("synthesis/{top}.rtlnopwr.v"))?;
    let layout = layout([
        &def,
        &verilog,
        &log("route")?,
        &log("post_sta")?,
        &log("drc")?,
        &log("lvs")?,
    ]);
    let layout = layout.map_err(|what| BoardError::Layout(what.to_owned()))?;
    Ok((layout, LayoutTexts { verilog, def }))
}

/// A netlist without escaped names, and with none that is long: a tool of the flow (rc2dly of qflow 1.3.17) has no room
/// for the end of a name of 24 or 40 letters, and the next one does not find it then.
pub fn with_short_names(verilog: &str) -> String {
    let (before, escaped) = verilog.split_once('\\').unwrap_or((verilog, ""));
    let mut numbers: HashMap<&str, usize> = HashMap::new();
    let short = escaped.split_terminator('\\').map(|text| {
        let (name, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let next = numbers.len();
        let number = *numbers.entry(name).or_insert(next);
        format!("net_{number} {rest}")
    });
    before.to_owned() + &short.collect::<String>()
}

/// What the texts of the flow say: layout, netlist, reports of routing, times, rules and comparison. The error is
/// what they do not say.
pub fn layout(
    [def, verilog, route, times, rules, comparison]: [&str; 6],
) -> Result<Layout, &'static str> {
    let whole = |text: &str, label: &'static str| {
        number(text, label).map(|number| number as u64).ok_or(label)
    };
    let mut lines = def.lines().map(str::trim_start);
    let area = lines.find_map(|line| line.strip_prefix("DIEAREA"));
    let numbers = area.unwrap_or_default().split_whitespace();
    let numbers: Vec<f64> = numbers.filter_map(|word| word.parse().ok()).collect();
    let [left, bottom, right, top] = numbers[..] else {
        return Err("DIEAREA");
    };
    let unit = number(def, "UNITS DISTANCE MICRONS").ok_or("UNITS")?;
    let unrouted = match route.contains("Final: No failed routes!") {
        true => 0,
        false => whole(route, "Final: Failed net routes:")?,
    };
    Ok(Layout {
        micrometres: [(right - left) / unit, (top - bottom) / unit],
        cells: verilog.lines().filter(|line| line.contains(" ( .")).count() as u64,
        nets: whole(def, "\nNETS")?,
        unrouted,
        longest_ns: number(times, "/D delay").ok_or("the longest path")? / 1e3,
        rule_errors: whole(rules, "drc =")?,
        differences: whole(comparison, "Total errors =")?,
    })
}

/// The first number behind a label.
fn number(text: &str, label: &str) -> Option<f64> {
    let (_, rest) = text.split_once(label)?;
    rest.split_whitespace().next()?.parse().ok()
}
