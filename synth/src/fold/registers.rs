//! Flip-flops behind block memories and multipliers of an ECP5 become the output registers that these cells have.
//!
//! Yosys leaves such flip-flops in logic. A block memory then needs 5.8 ns to its word, 1.0 ns with its own register; a
//! multiplier 3.9 ns and a way to the flip-flop, 3.5 ns with its own. Clock for clock the outputs are the same.

use super::{Cells, FLIP_FLOP, Readers, is_bit};
use serde_json::{Value, json};

/// A cell with an output register: its type, the sides that the register has, the names that its outputs, clock, enable
/// and reset begin with, which the side ends, and the same of the parameter that puts it in, and its value.
struct Kind {
    cell: &'static str,
    is_meant: fn(&Value) -> bool,
    sides: &'static [&'static str],
    names: [&'static str; 4],
    parameter: (&'static str, &'static str),
}

impl Kind {
    /// A name with each side.
    fn with_sides(&self, name: &str) -> impl Iterator<Item = String> {
        self.sides.iter().map(move |side| format!("{name}{side}"))
    }

    /// The register of such a cell is in use.
    fn is_used(&self, cell: &Value) -> bool {
        let (parameter, value) = self.parameter;
        let mut parameters = self.with_sides(parameter);
        parameters.any(|name| cell["parameters"][name] == value)
    }
}

/// A block memory with the register on these sides.
const fn memory(sides: &'static [&'static str], is_meant: fn(&Value) -> bool) -> Kind {
    Kind {
        cell: "DP16KD",
        is_meant,
        sides,
        names: ["DO", "CLK", "OCE", "RST"],
        parameter: ("REGMODE_", "OUTREG"),
    }
}

/// A word of 36 bits leaves a block memory on the outputs of both ports, so both have the register. The clock of a
/// multiplier is that of the flip-flops behind it, for it has none before.
const KINDS: [Kind; 5] = [
    memory(&["A"], |cell| !is_wide(cell)),
    memory(&["B"], |cell| !is_wide(cell)),
    memory(&["A", "B"], is_wide),
    Kind {
        cell: "PDPW16KD",
        is_meant: |_| true,
        sides: &[""],
        names: ["DO", "CLKR", "OCER", "RST"],
        parameter: ("REGMODE", "OUTREG"),
    },
    Kind {
        cell: "MULT18X18D",
        is_meant: |_| true,
        sides: &[""],
        names: ["P", "CLK0", "CE0", "RST0"],
        parameter: ("REG_OUTPUT_CLK", "CLK0"),
    },
];

/// One of the cells with a register in use.
pub(super) fn has_output_register(cell: &Value) -> bool {
    KINDS
        .iter()
        .any(|kind| cell["type"] == kind.cell && kind.is_used(cell))
}

/// Words of 36 bits are read.
fn is_wide(memory: &Value) -> bool {
    let width = memory["parameters"]["DATA_WIDTH_B"].as_str();
    width.is_some_and(|width| u64::from_str_radix(width, 2) == Ok(36))
}

/// Moves the flip-flops of a module; how many there were.
pub(super) fn fold(cells: &mut Cells, readers: &Readers) -> u64 {
    let has_registers = |cell: &Value| KINDS.iter().any(|kind| cell["type"] == kind.cell);
    let named = cells.iter().filter(|(_, cell)| has_registers(cell));
    let named: Vec<String> = named.map(|(name, _)| name.clone()).collect();
    let mut moved = 0;
    for name in named {
        for kind in &KINDS {
            if let Some(register) = register(&cells[&name], kind, cells, readers) {
                moved += register.bits.len() as u64;
                put(register, &name, kind, cells);
            }
        }
    }
    moved
}

/// What flip-flops have in common that become one register: bits of the clock and of the enable.
pub(super) type Control = [Value; 2];

/// The register that can stand behind a cell: what controls it, and the output port and flip-flop of each of its bits.
struct Register {
    control: Control,
    bits: Vec<(String, String)>,
}

/// None unless every output bit that is used goes to a flip-flop alone, and all of these are controlled alike.
fn register(cell: &Value, kind: &Kind, cells: &Cells, readers: &Readers) -> Option<Register> {
    let connections = &cell["connections"];
    let is_reset = |port: String| {
        let bits = connections.get(port);
        bits.is_some_and(|bits| bits != &json!(["0"]))
    };
    let [output, clock, _, reset] = kind.names;
    let is_meant = cell["type"] == kind.cell && (kind.is_meant)(cell);
    if !is_meant || kind.is_used(cell) || kind.with_sides(reset).any(is_reset) {
        return None;
    }
    let mut found: Option<Register> = None;
    for (port, net) in cell["connections"].as_object()? {
        let is_output = kind.with_sides(output).any(|name| is_bit(port, &name));
        let readers = net[0].as_u64().and_then(|net| readers.get(&net));
        let Some(readers) = readers.filter(|_| is_output) else {
            continue;
        };
        let [(Some(name), data)] = readers.as_slice() else {
            return None;
        };
        let control = control(&cells[name]).filter(|_| data == "DI")?;
        let register = found.get_or_insert_with(|| Register {
            control: control.clone(),
            bits: vec![],
        });
        if register.control != control {
            return None;
        }
        register.bits.push((port.clone(), name.clone()));
    }
    let clocks = kind.with_sides(clock);
    let mut clocks = clocks.filter_map(|port| connections.get(port));
    found.filter(|found| clocks.all(|clock| *clock == found.control[0]))
}

/// What controls a flip-flop on a rising edge that starts at 0 and has no reset.
pub(super) fn control(cell: &Value) -> Option<Control> {
    let parameter = |name: &str, default: &'static str| {
        let value = cell["parameters"][name].as_str();
        value.unwrap_or(default).trim().to_owned()
    };
    let reset = &cell["connections"]["LSR"];
    let is_plain = cell["type"] == FLIP_FLOP
        && parameter("REGSET", "RESET") == "RESET"
        && parameter("CLKMUX", "CLK") == "CLK"
        && (reset.is_null() || reset == &json!(["0"]));
    let enable = match parameter("CEMUX", "CE").as_str() {
        "1" => json!(["1"]),
        "CE" => cell["connections"]["CE"].clone(),
        _ => return None,
    };
    let clock = cell["connections"]["CLK"].clone();
    is_plain.then_some([clock, enable])
}

fn put(register: Register, name: &str, kind: &Kind, cells: &mut Cells) {
    for (port, flip_flop) in &register.bits {
        let removed = cells.remove(flip_flop).unwrap_or_default();
        cells[name]["connections"][port] = removed["connections"]["Q"].clone();
    }
    let cell = &mut cells[name];
    let (parameter, value) = kind.parameter;
    for parameter in kind.with_sides(parameter) {
        cell["parameters"][parameter] = value.into();
    }
    let [clock, enable] = register.control;
    for (name, bits) in kind.names[1..].iter().zip([clock, enable, json!(["0"])]) {
        for port in kind.with_sides(name) {
            cell["connections"][&port] = bits.clone();
            cell["port_directions"][port] = "input".into();
        }
    }
}
