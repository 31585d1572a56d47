//! Flip-flops before multipliers of an ECP5 become the input registers that these cells have.
//!
//! A factor must reach a multiplier that has an output register alone 3.5 ns before the clock. A flip-flop that only
//! delays another register or a constant leaves the way to the multiplier the whole clock instead.

use super::registers::{Control, control, has_output_register};
use super::{Cells, FLIP_FLOP, Readers, is_bit, nets};
use serde_json::{Value, json};
use std::collections::HashMap;

const MULTIPLIER: &str = "MULT18X18D";
const FACTORS: [&str; 2] = ["A", "B"];

/// The parameter that puts the register of a factor in.
fn parameter(side: &str) -> String {
    format!("REG_INPUT{side}_CLK")
}

/// Moves the flip-flops of a module; how many there were. One that others read too stays, and is counted as none.
pub(super) fn fold(cells: &mut Cells, readers: &Readers) -> u64 {
    let drivers = drivers(cells);
    let multipliers = cells.iter().filter(|(_, cell)| cell["type"] == MULTIPLIER);
    let of =
        |(name, cell): (&String, &Value)| Some((name.clone(), factors(cell, cells, &drivers)?));
    let found: Vec<(String, Vec<Factor>)> = multipliers.filter_map(of).collect();
    let mut left: HashMap<String, usize> = HashMap::new();
    for (name, factors) in found {
        let cell = &mut cells[&name];
        for side in FACTORS {
            cell["parameters"][parameter(side)] = "CLK0".into();
        }
        for factor in factors {
            cell["connections"][&factor.port] = factor.from;
            let count = || readers.get(&factor.net).map_or(0, Vec::len);
            *left.entry(factor.flip_flop).or_insert_with(count) -= 1;
        }
    }
    let unread = left.into_iter().filter(|(_, readers)| *readers == 0);
    unread.filter_map(|(name, _)| cells.remove(&name)).count() as u64
}

/// A bit of a factor that comes from a flip-flop: its port, the net and the flip-flop that it is, and what that delays.
struct Factor {
    port: String,
    net: u64,
    flip_flop: String,
    from: Value,
}

/// The cell that drives a net.
type Drivers = HashMap<u64, String>;

fn drivers(cells: &Cells) -> Drivers {
    let mut drivers = Drivers::new();
    for (name, cell) in cells {
        for (port, bits) in cell["connections"].as_object().into_iter().flatten() {
            if cell["port_directions"][port] == "output" {
                drivers.extend(nets(bits).map(|net| (net, name.clone())));
            }
        }
    }
    drivers
}

/// The bits of both factors that come from flip-flops; none unless the multiplier can have the registers of all.
fn factors(cell: &Value, cells: &Cells, drivers: &Drivers) -> Option<Vec<Factor>> {
    let own: Control = ["CLK0", "CE0"].map(|port| cell["connections"][port].clone());
    let has_registers = FACTORS
        .iter()
        .any(|side| cell["parameters"][parameter(side)] == "CLK0");
    if has_registers || !has_output_register(cell) {
        return None;
    }
    let mut found = vec![];
    for (port, bits) in cell["connections"].as_object()? {
        let is_factor = FACTORS.iter().any(|side| is_bit(port, side));
        if !is_factor || bits == &json!(["0"]) {
            continue;
        }
        let net = bits[0].as_u64()?;
        let name = drivers.get(&net)?;
        let flip_flop = &cells[name];
        let from = &flip_flop["connections"]["DI"];
        let is_kept = |net| {
            let delayed = drivers.get(&net);
            delayed.is_some_and(|name| is_registered(&cells[name]))
        };
        let is_delay = from[0].as_u64().is_none_or(is_kept) && control(flip_flop)? == own;
        let (port, flip_flop) = (port.clone(), name.clone());
        found.push(is_delay.then(|| Factor {
            port,
            net,
            flip_flop,
            from: from.clone(),
        })?);
    }
    Some(found)
}

/// Outputs come from registers.
fn is_registered(cell: &Value) -> bool {
    cell["type"] == FLIP_FLOP || has_output_register(cell)
}
