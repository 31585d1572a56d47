//! What a unit promises: ports, widths, timing, ties, error.
//!
//! Names, directions, widths and number formats of ports come from the emitted Verilog; their formulas and meanings from [`ports`]; the
//! rest of a promise from [`statement`] and the catalogue.

mod markdown;
pub mod ports;
mod processors;
mod shared;
pub mod statement;
mod video;
pub mod width;

use imogene_rtl::catalogue::Parameter;
use imogene_rtl::emit::{Direction, EmitError, EmitRequest, Emitted, Port, emit};
use serde::Serialize;
use thiserror::Error;

/// What every unit does about reset.
pub const RESET: &str = "none: registers start from their initial values at configuration; outputs mean something under valid only, or where there is none after the latency has passed";

/// Symbols of the parameters in formulas.
const SYMBOLS: [(&str, &str); 13] = [
    ("planes", "N"),
    ("rows-per-stage", "R"),
    ("objects", "M"),
    ("digits", "D"),
    ("corrections", "C"),
    ("sides", "E"),
    ("cards", "K"),
    ("layers", "T"),
    ("products", "G"),
    ("intersected", "I"),
    ("subtracted", "J"),
    ("mode", "V"),
    ("lights", "Q"),
];

/// Why a unit has no contract.
#[derive(Debug, Error)]
pub enum ContractError {
    /// A parameter is out of its range.
    #[error("{0}")]
    Request(EmitError),
    /// A port of the Verilog without a meaning, or a meaning without a port; a defect of this crate.
    #[error("the contract of `{unit}` and its Verilog differ at port `{port}`")]
    Port {
        /// The unit.
        unit: &'static str,
        /// The port.
        port: String,
    },
}

/// The contract of a unit with its parameters; the keys are stable.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Contract {
    /// The unit, which is also the name of its Verilog module.
    pub unit: &'static str,
    /// What it computes.
    pub computes: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// Parameters that the Verilog was made with.
    pub parameters: Vec<ParameterEntry>,
    /// Ports, in the order of the Verilog.
    pub ports: Vec<PortEntry>,
    /// Clocks from an input to its result.
    pub latency: Latency,
    /// Results per clock.
    pub throughput: &'static str,
    /// What happens at reset.
    pub reset: &'static str,
    /// What happens at equality.
    pub ties: &'static str,
    /// How far results are from what is computed.
    pub error: String,
    /// The command that makes the Verilog.
    pub command: String,
}

/// A parameter of a unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ParameterEntry {
    /// Option of the command line.
    pub option: &'static str,
    /// Symbol in formulas.
    pub symbol: &'static str,
    /// Legal values.
    pub range: String,
    /// The value of this Verilog.
    pub value: usize,
}

/// A port of a unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PortEntry {
    /// Name.
    pub name: String,
    /// `input` or `output`.
    pub direction: &'static str,
    /// Bits.
    pub width: usize,
    /// Bits as a formula in `W`.
    pub formula: String,
    /// `two's complement`, `unsigned` or `flag`.
    pub format: &'static str,
    /// What it carries.
    pub meaning: String,
}

/// Clocks from an input to its result.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Latency {
    /// As a formula in the symbols of the parameters.
    pub formula: &'static str,
    /// Of this Verilog.
    pub clocks: usize,
}

/// The contract of a unit.
///
/// # Errors
///
/// When a parameter is out of its range.
pub fn contract(request: &EmitRequest) -> Result<Contract, ContractError> {
    of_emitted(request, &emit(request).map_err(ContractError::Request)?)
}

/// The contract of a unit that was already emitted.
///
/// # Errors
///
/// When its ports are not those that this crate describes.
pub fn of_emitted(request: &EmitRequest, emitted: &Emitted) -> Result<Contract, ContractError> {
    let unit = request.unit;
    let statement = statement::of(unit);
    Ok(Contract {
        unit: unit.name(),
        computes: unit.contract(),
        source: unit.source(),
        parameters: parameters(request),
        ports: port_entries(request, &emitted.ports)?,
        latency: Latency {
            formula: unit.latency_formula(),
            clocks: emitted.latency,
        },
        throughput: statement.throughput,
        reset: RESET,
        ties: statement.ties,
        error: unit.error(request),
        command: request.command(),
    })
}

impl Contract {
    /// The contract as a Markdown page.
    pub fn markdown(&self) -> String {
        markdown::page(self)
    }

    /// The contract as JSON.
    pub fn json(&self) -> String {
        let text = serde_json::to_string_pretty(self).expect("every key is a string");
        text + "\n"
    }
}

fn parameters(request: &EmitRequest) -> Vec<ParameterEntry> {
    let formats = imogene_rtl::format::DEPTH_WORDS.map(|word| word.to_string());
    let mut list = vec![ParameterEntry {
        option: "format",
        symbol: "W",
        range: formats.join(", "),
        value: request.depth_word,
    }];
    let given = request.unit.parameters().iter().zip(request.options());
    list.extend(given.map(|(parameter, (option, value))| ParameterEntry {
        option,
        symbol: symbol(option),
        range: range(parameter),
        value,
    }));
    list
}

fn symbol(option: &str) -> &'static str {
    let found = SYMBOLS.iter().find(|(name, _)| *name == option);
    found.map_or("?", |(_, symbol)| symbol)
}

fn range(parameter: &Parameter) -> String {
    match parameter.most {
        Some(most) => format!("{} to {most}", parameter.least),
        None => format!("{} to W", parameter.least),
    }
}

fn port_entries(request: &EmitRequest, emitted: &[Port]) -> Result<Vec<PortEntry>, ContractError> {
    let differs = |port: &str| ContractError::Port {
        unit: request.unit.name(),
        port: port.to_owned(),
    };
    let mut described = ports::described(request);
    let mut list = Vec::new();
    for port in emitted {
        let at = described.iter().position(|known| known.name == port.name);
        let known = described.swap_remove(at.ok_or_else(|| differs(&port.name))?);
        if known.width.bits(request.depth_word) != port.width {
            return Err(differs(&port.name));
        }
        list.push(entry(port, known));
    }
    match described.first() {
        Some(left) => Err(differs(&left.name)),
        None => Ok(list),
    }
}

fn entry(port: &Port, known: ports::Described) -> PortEntry {
    PortEntry {
        name: port.name.clone(),
        direction: match port.direction {
            Direction::Input => "input",
            Direction::Output => "output",
        },
        width: port.width,
        formula: known.width.to_string(),
        format: match (port.signed, port.width) {
            (true, _) => "two's complement",
            (false, 1) => "flag",
            (false, _) => "unsigned",
        },
        meaning: known.meaning,
    }
}
