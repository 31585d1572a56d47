//! Verilog of units and machines: the text of a circuit, with a header that says what it is.
//!
//! The same request gives the same text, byte for byte.

mod census;
mod circuit;
pub mod display;
pub mod machine;
mod names;
mod raw;
mod words;

pub use census::{Census, census};
use imogene_circuits::units;
use imogene_contract::{Request, RequestError};
use imogene_hdl::Design;
pub use imogene_hdl::Direction;
pub use raw::raw;
use std::fmt::Write;
use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm, fill};

/// A port of the emitted module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// Name in the Verilog.
    pub name: String,
    /// What it carries.
    pub meaning: String,
    /// Direction.
    pub direction: Direction,
    /// Bits.
    pub width: usize,
    /// Two's complement.
    pub signed: bool,
}

/// The Verilog of a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Emitted {
    /// Name of the top module.
    pub top: String,
    /// Comment that states parameters, latency, ports and the command that makes the text.
    pub header: String,
    /// Names and texts of the modules, leaves first, the top module last.
    pub modules: Vec<(String, String)>,
    /// Ports of the top module, in its order.
    pub ports: Vec<Port>,
    /// Clocks from the first input of a computation to its result.
    pub latency: usize,
}

impl Emitted {
    /// All modules as the text of one file.
    pub fn bundle(&self) -> String {
        let mut text = self.header.clone();
        for (_, module) in &self.modules {
            text.push('\n');
            text += module;
        }
        text
    }

    /// One file for each module, by name, leaves first: the form in which every linter finds each module where it looks for it.
    pub fn files(&self) -> Vec<(String, String)> {
        let text = |name: &str, module: &str| {
            if name == self.top {
                format!("{}\n{module}", self.header)
            } else {
                format!(
                    "// {name}: part of {}; see there.\n// SPDX-License-Identifier: {LICENCE}\n\n{module}",
                    self.top
                )
            }
        };
        let files = self.modules.iter();
        files
            .map(|(name, module)| (format!("{name}.v"), text(name, module)))
            .collect()
    }
}

const LICENCE: &str = "MIT OR Apache-2.0";

/// The circuit of a unit.
///
/// # Errors
///
/// When a parameter is out of its legal range; the error names the value and the range.
pub fn design(request: &Request) -> Result<Design, RequestError> {
    request.check()?;
    Ok(units::design(request))
}

/// Emits the Verilog of a unit.
///
/// # Errors
///
/// When a parameter is out of its legal range; the error names the value and the range.
pub fn emit(request: &Request) -> Result<Emitted, RequestError> {
    emitted(request, "")
}

/// Emits the Verilog of a unit with a prefix before the name of every module, so that several configurations fit in one design.
///
/// # Errors
///
/// As for [`emit`], and when a name with the prefix is no identifier.
pub fn emit_with_prefix(request: &Request, prefix: &str) -> Result<Emitted, RequestError> {
    names::check_prefix(prefix)?;
    emitted(request, prefix)
}

fn emitted(request: &Request, prefix: &str) -> Result<Emitted, RequestError> {
    let design = design(request)?;
    let ports = circuit::ports(&design);
    let latency = request.latency();
    Ok(Emitted {
        top: format!("{prefix}{}", request.unit.name()),
        header: header(request, &ports, latency, prefix),
        modules: circuit::modules(&design, prefix),
        ports,
        latency,
    })
}

pub use imogene_contract::video::LEAD;

/// Columns of the statements of a header at most.
const COLUMNS: usize = 120;

fn header(request: &Request, ports: &[Port], latency: usize, prefix: &str) -> String {
    let unit = request.unit;
    let format = format!("format {}", request.depth_word);
    let options = request.options().into_iter();
    let options = options.map(|(option, value)| format!("{} {value}", option.replace('-', " ")));
    Heading {
        top: &format!("{prefix}{}", unit.name()),
        contract: unit.record().computes,
        parameters: std::iter::once(format).chain(options).collect(),
        latency,
        error: &request.error(),
        source: unit.record().source,
        ports,
        command: &request.command_with_prefix(prefix),
    }
    .text()
}

/// What the comment before the Verilog states.
struct Heading<'a> {
    top: &'a str,
    contract: &'a str,
    /// A line each.
    parameters: Vec<String>,
    latency: usize,
    error: &'a str,
    source: &'a str,
    ports: &'a [Port],
    command: &'a str,
}

impl Heading<'_> {
    fn text(&self) -> String {
        let mut text = format!("// {}: {}\n//\n", self.top, self.contract);
        let parameters = self.parameters.join(&format!("\n{INDENT}"));
        let _ = writeln!(text, "// parameters: {parameters}");
        let clocks = if self.latency == 1 { "clock" } else { "clocks" };
        let _ = writeln!(text, "// latency:    {} {clocks}", self.latency);
        let _ = writeln!(text, "// error:      {}", wrapped(self.error));
        let _ = writeln!(text, "// source:     {}", self.source);
        let _ = writeln!(text, "// ports:");
        for port in self.ports {
            let direction = if port.direction == Direction::In {
                "in "
            } else {
                "out"
            };
            let reading = if port.signed {
                "two's complement"
            } else {
                "unsigned"
            };
            let _ = writeln!(
                text,
                "//   {direction} {:<14} {:>2} {reading}",
                port.name, port.width
            );
        }
        let _ = writeln!(text, "//\n// Made by: {}", self.command);
        let _ = writeln!(text, "// SPDX-License-Identifier: {LICENCE}");
        text
    }
}

/// What stands before the later lines of a statement.
const INDENT: &str = "//             ";

/// A statement on as many lines as it needs, the later ones indented like the first.
fn wrapped(statement: &str) -> String {
    let options = Options::new(COLUMNS)
        .initial_indent(INDENT)
        .subsequent_indent(INDENT)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit)
        .break_words(false);
    fill(statement, options)[INDENT.len()..].to_owned()
}
