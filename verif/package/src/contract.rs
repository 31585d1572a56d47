//! What a unit promises: ports, widths, timing, ties, error.
//!
//! Ports are those of the circuit, each with its meaning; the formula of a width follows from the circuit at the least
//! and the greatest depth words. The rest of a promise is the record of the unit.

use imogene_contract::parameters::Parameter;
use imogene_contract::words::MOST_DEPTH;
use imogene_contract::{Request, RequestError, RootForm};
use imogene_hdl::Design;
use imogene_rtl::emit::{Emitted, Port, design, emit};
use serde::Serialize;
use std::fmt::Write;

/// What every unit does about reset.
pub const RESET: &str = "none: registers start from their initial values at configuration; outputs mean something under valid only, or where there is none after the latency has passed";

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
    pub value: u32,
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
    pub formula: String,
    /// Of this Verilog.
    pub clocks: usize,
}

/// The contract of a unit; refuses a parameter out of its range.
pub fn contract(request: &Request) -> Result<Contract, RequestError> {
    of_emitted(request, &emit(request)?)
}

/// The contract of a unit that was already emitted.
pub fn of_emitted(request: &Request, emitted: &Emitted) -> Result<Contract, RequestError> {
    let record = request.unit.record();
    Ok(Contract {
        unit: record.name,
        computes: record.computes,
        source: record.source,
        parameters: parameters(request),
        ports: ports(request, &emitted.ports)?,
        latency: Latency {
            formula: request.latency_formula(),
            clocks: emitted.latency,
        },
        throughput: record.throughput,
        reset: RESET,
        ties: record.ties,
        error: request.error(),
        command: request.command(),
    })
}

impl Contract {
    /// The contract as JSON.
    pub fn json(&self) -> String {
        let text = serde_json::to_string_pretty(self).expect("every key is a string");
        text + "\n"
    }

    /// The contract as a Markdown page.
    pub fn markdown(&self) -> String {
        let mut text = format!("# {}\n\nComputes {}.\n\n", self.unit, self.computes);
        let Latency { formula, clocks } = &self.latency;
        let s = if *clocks == 1 { "" } else { "s" };
        let latency = format!("{clocks} clock{s}, `{formula}`");
        text += "| | |\n|---|---|\n";
        for (what, value) in [
            ("source", self.source),
            ("latency", &latency),
            ("throughput", self.throughput),
            ("reset", self.reset),
            ("ties", self.ties),
            ("error", &self.error),
            ("made by", &format!("`{}`", self.command)),
        ] {
            let _ = writeln!(text, "| {what} | {value} |");
        }
        text += "\n## Parameters\n\n| parameter | option | legal | here |\n|---|---|---|---|\n";
        for p in &self.parameters {
            let _ = writeln!(
                text,
                "| `{}` | `--{}` | {} | {} |",
                p.symbol, p.option, p.range, p.value
            );
        }
        text += "\n## Ports\n\n| port | direction | width | formula | format | meaning |\n|---|---|---|---|---|---|\n";
        for p in &self.ports {
            let _ = writeln!(
                text,
                "| `{}` | {} | {} | `{}` | {} | {} |",
                p.name, p.direction, p.width, p.formula, p.format, p.meaning
            );
        }
        text
    }
}

fn parameters(request: &Request) -> Vec<ParameterEntry> {
    let format = ParameterEntry {
        option: "format",
        symbol: "W",
        range: format!("{} to 32", request.unit.least_word()),
        value: request.depth_word,
    };
    let entry = |parameter: &Parameter| ParameterEntry {
        option: parameter.option,
        symbol: parameter.symbol,
        range: parameter.range(),
        value: request.get(parameter),
    };
    let own = request.unit.record().parameters.iter().map(entry);
    std::iter::once(format).chain(own).collect()
}

fn ports(request: &Request, ports: &[Port]) -> Result<Vec<PortEntry>, RequestError> {
    // The parameters that are at most the depth word change no port.
    let at = |depth_word: u32| {
        design(&Request {
            depth_word,
            rows_per_stage: 1,
            digits: 1,
            root_form: RootForm::default(),
            ..*request
        })
    };
    let end = |word: u32| Ok([at(word)?, at(word + 1)?]);
    let (least, most) = (request.unit.least_word(), MOST_DEPTH - 1);
    let ends: [[Design; 2]; 2] = [end(least)?, end(most)?];
    let formula = |port: &Port| {
        let widths = ends.each_ref().map(|designs| {
            designs.each_ref().map(|design| {
                let mut others = design.top.ports.iter();
                let found = others.find(|other| other.name == port.name);
                found.map_or(1, |other| i64::from(other.width))
            })
        });
        let [short, long] = widths.map(|[width, next]| next - width);
        let line =
            |times: i64, width: i64, word: u32| formula(times, width - times * i64::from(word));
        let one = line(short, widths[0][0], least);
        let other = line(long, widths[1][0], most);
        // Cut to what the widest word leaves, or filled up to what every word has.
        match (short - long).signum() {
            0 => one,
            1 => format!("min({one}, {other})"),
            _ => format!("max({one}, {other})"),
        }
    };
    let entry = |port: &Port| PortEntry {
        name: port.name.clone(),
        direction: port.direction.keyword(),
        width: port.width,
        formula: formula(port),
        format: match (port.signed, port.width) {
            (true, _) => "two's complement",
            (false, 1) => "flag",
            (false, _) => "unsigned",
        },
        meaning: port.meaning.clone(),
    };
    Ok(ports.iter().map(entry).collect())
}

/// `times W + plus`.
fn formula(times: i64, plus: i64) -> String {
    match (times, plus) {
        (0, plus) => plus.to_string(),
        (1, 0) => "W".to_owned(),
        (1, plus) => format!("W + {plus}"),
        (times, 0) => format!("{times}W"),
        (-1, plus) => format!("{plus} - W"),
        (times, plus) => format!("{times}W + {plus}"),
    }
}
