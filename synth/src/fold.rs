//! What an ECP5 does in fewer cells than Yosys writes: the netlist is changed between Yosys and nextpnr.
//!
//! Clock for clock nothing changes: [registers] are moved into the cells before them, or into the multipliers whose
//! [factors] they hold, and choices into the [sums] that they follow or feed.

mod factors;
mod registers;
mod sums;

use crate::error::SynthError;
use crate::target::{Family, Target};
use crate::yosys::CellCounts;
use serde_json::{Map, Value};
use std::collections::{BTreeMap, HashMap};
use std::path::Path;

/// The type of a flip-flop of an ECP5.
const FLIP_FLOP: &str = "TRELLIS_FF";
/// The type of a look-up table of an ECP5.
const TABLE: &str = "LUT4";

/// What is moved, by which a result is kept: it changes with every change of what is done.
pub const FOLDS: &str = " output registers, registers of factors and constants, choices in sums";

/// Cells that a netlist does without.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Folded {
    /// Flip-flops.
    pub flip_flops: u64,
    /// Look-up tables.
    pub tables: u64,
}

impl Folded {
    /// Takes them off the cells that Yosys counted.
    pub(crate) fn take_from(self, cells: &mut CellCounts) {
        for (cell, fewer) in [(FLIP_FLOP, self.flip_flops), (TABLE, self.tables)] {
            if let Some(count) = cells.get_mut(cell) {
                *count -= fewer;
            }
        }
    }
}

impl Target {
    /// What a result depends on beside tools and their commands.
    pub(crate) fn steps(self) -> &'static str {
        match self.family() {
            Family::Ecp5 => FOLDS,
            _ => "",
        }
    }

    /// Changes a netlist in a file to one of fewer cells, where the family has such cells; by module, how many fewer.
    pub(crate) fn fold(self, netlist: &Path) -> Result<BTreeMap<String, Folded>, SynthError> {
        match self.family() {
            Family::Ecp5 => fold(netlist),
            _ => Ok(BTreeMap::new()),
        }
    }
}

/// Changes a netlist in a file, which Yosys wrote as JSON; the cells that each of its modules does without. Fails when
/// the file is no such netlist, or cannot be read or written.
pub fn fold(path: &Path) -> Result<BTreeMap<String, Folded>, SynthError> {
    let text = imogene_tools::read(path)?;
    let mut netlist: Value =
        serde_json::from_str(&text).map_err(|error| SynthError::report("yosys", error))?;
    let modules = netlist.get_mut("modules").and_then(Value::as_object_mut);
    let modules = modules.ok_or_else(|| SynthError::report("yosys", "no modules"))?;
    let named = modules.iter_mut();
    let folded = named.map(|(name, module)| (name.clone(), fold_module(module)));
    let folded = folded.collect();
    imogene_tools::write(path, &netlist.to_string())?;
    Ok(folded)
}

fn fold_module(module: &mut Value) -> Folded {
    let mut apply = |change: fn(&mut Cells, &Readers) -> u64| {
        let readers = readers(module);
        let cells = module["cells"].as_object_mut();
        cells.map_or(0, |cells| change(cells, &readers))
    };
    Folded {
        flip_flops: apply(registers::fold) + apply(factors::fold),
        tables: apply(sums::fold),
    }
}

/// A port is a bit of the one of this name.
fn is_bit(port: &str, name: &str) -> bool {
    let number = port.strip_prefix(name);
    number.is_some_and(|number| number.parse::<u8>().is_ok())
}

/// The nets among the bits of a port.
fn nets(bits: &Value) -> impl Iterator<Item = u64> {
    bits.as_array()
        .into_iter()
        .flatten()
        .filter_map(Value::as_u64)
}

/// Cells by name.
type Cells = Map<String, Value>;

/// Cell and port of everything that a net goes to; a port of the module has no cell.
type Readers = HashMap<u64, Vec<(Option<String>, String)>>;

fn readers(module: &Value) -> Readers {
    let mut readers = Readers::new();
    let mut add = |bits: &Value, cell: Option<&str>, port: &str| {
        for bit in nets(bits) {
            let reader = (cell.map(str::to_owned), port.to_owned());
            readers.entry(bit).or_default().push(reader);
        }
    };
    for (port, signal) in module["ports"].as_object().into_iter().flatten() {
        add(&signal["bits"], None, port);
    }
    for (name, cell) in module["cells"].as_object().into_iter().flatten() {
        for (port, bits) in cell["connections"].as_object().into_iter().flatten() {
            if cell["port_directions"][port] != "output" {
                add(bits, Some(name), port);
            }
        }
    }
    readers
}
