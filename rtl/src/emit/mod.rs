//! Verilog of units and machines: the text of a circuit, with a header that says what it is.
//!
//! The same request gives the same text, byte for byte.

pub mod machine;
mod words;

use imogene_circuits::{machines, units};
use imogene_contract::tile::TileWords;
use imogene_contract::{Request, RequestError};
pub use imogene_hdl::Direction;
use imogene_hdl::block::Block;
use imogene_hdl::{Design, Module, verilog};
use rust_hdl::core::prelude::generate_verilog;
use std::fmt::Write;
use std::sync::Arc;
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

    /// One file for each module, by name, leaves first: the form in which every linter finds each module.
    pub fn files(&self) -> Vec<(String, String)> {
        let top = &self.top;
        let file = |(name, module): &(String, String)| {
            let header = match name == top {
                true => self.header.clone(),
                false => format!(
                    "// {name}: part of {top}; see there.\n// SPDX-License-Identifier: {LICENCE}\n"
                ),
            };
            (format!("{name}.v"), format!("{header}\n{module}"))
        };
        self.modules.iter().map(file).collect()
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
    unit(request, "")
}

/// Emits the Verilog of a unit with a prefix before the name of every module, so that several configurations fit in one
/// design.
///
/// # Errors
///
/// As for [`emit`], and when a name with the prefix is no identifier.
pub fn emit_with_prefix(request: &Request, prefix: &str) -> Result<Emitted, RequestError> {
    check_prefix(prefix)?;
    unit(request, prefix)
}

fn unit(request: &Request, prefix: &str) -> Result<Emitted, RequestError> {
    let design = design(request)?;
    let record = request.unit.record();
    let format = format!("format {}", request.depth_word);
    let form = request.root_form;
    let form = (!form.is_usual()).then(|| format!("root form {form}"));
    let options = request.options().into_iter();
    let options = options.map(|(option, value)| format!("{} {value}", option.replace('-', " ")));
    let heading = Heading {
        contract: record.computes,
        parameters: std::iter::once(format).chain(form).chain(options).collect(),
        error: &request.error(),
        source: record.source,
        command: &request.command_with_prefix(prefix),
    };
    Ok(emitted(&design, prefix, request.latency(), &heading))
}

/// The Verilog of a tile. Its registers have no value at power-up, for those of a chip have none.
pub fn emit_tile(words: &TileWords, prefix: &str, command: &str) -> Emitted {
    let design = machines::tile(words);
    let widths = &words.widths;
    let widths = [
        format!("depth {}", widths.depth),
        format!("root {}", widths.root),
        format!("{} rows of it left out", widths.dropped_rows),
        format!("plane {}", widths.plane),
    ];
    let heading = Heading {
        contract: "one solid with its cut planes, one pixel per clock, in a window that goes over the screen",
        parameters: widths.to_vec(),
        error: "none: every pixel is that of the golden model",
        source: "docs/boards.md",
        command,
    };
    let mut emitted = emitted(&design, prefix, 1, &heading);
    let texts = design.top.all().into_iter();
    for ((_, text), module) in emitted.modules.iter_mut().zip(texts) {
        *text = verilog::write_for_chip(&module, prefix);
    }
    emitted
}

/// The Verilog that rust-hdl itself prints of a unit. It is compared with ours and used for nothing else; the module of
/// the unit is called `top`, its ports are those of [`emit`].
///
/// # Errors
///
/// When a parameter is out of its legal range.
pub fn raw(request: &Request) -> Result<String, RequestError> {
    Ok(generate_verilog(&Block::of(&design(request)?.top)))
}

/// Refuses what cannot stand before the name of a module: also VHDL begins identifiers with a letter and knows no two
/// underscores in a row.
fn check_prefix(prefix: &str) -> Result<(), RequestError> {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let begins = prefix.starts_with(|c: char| c.is_ascii_alphabetic());
    match begins && prefix.chars().all(is_plain) && !prefix.contains("__") {
        true => Ok(()),
        false => Err(RequestError::Prefix {
            prefix: prefix.to_owned(),
        }),
    }
}

/// What the comment before the Verilog states besides latency and ports.
struct Heading<'a> {
    contract: &'a str,
    /// A line each.
    parameters: Vec<String>,
    error: &'a str,
    source: &'a str,
    command: &'a str,
}

/// The text of a design.
fn emitted(design: &Design, prefix: &str, latency: usize, heading: &Heading) -> Emitted {
    let modules = design.top.all();
    let module = |module: &Arc<Module>| {
        let name = format!("{prefix}{}", module.name);
        (name, verilog::write(module, prefix))
    };
    let (top, ports) = (format!("{prefix}{}", design.top.name), ports(design));
    Emitted {
        header: heading.text(&top, latency, &ports),
        modules: modules.iter().map(module).collect(),
        top,
        ports,
        latency,
    }
}

/// The ports of the top module, the clock before all others.
fn ports(design: &Design) -> Vec<Port> {
    let clock = Port {
        name: "clock".to_owned(),
        meaning: "rising edge".to_owned(),
        direction: Direction::In,
        width: 1,
        signed: false,
    };
    let others = design.top.ports.iter().map(|port| Port {
        name: port.name.clone(),
        meaning: port.meaning.clone(),
        direction: port.direction,
        width: port.width as usize,
        signed: port.signed,
    });
    let clock = design.top.is_clocked().then_some(clock);
    clock.into_iter().chain(others).collect()
}

impl Heading<'_> {
    fn text(&self, top: &str, latency: usize, ports: &[Port]) -> String {
        let mut text = format!("// {top}: {}\n//\n", self.contract);
        let parameters = self.parameters.join(&format!("\n{INDENT}"));
        let clocks = if latency == 1 { "clock" } else { "clocks" };
        let _ = writeln!(text, "// parameters: {parameters}");
        let _ = writeln!(text, "// latency:    {latency} {clocks}");
        let _ = writeln!(text, "// error:      {}", wrapped(self.error));
        let _ = writeln!(text, "// source:     {}", self.source);
        let _ = writeln!(text, "// ports:");
        for port in ports {
            let is_input = port.direction == Direction::In;
            let direction = if is_input { "in " } else { "out" };
            let reading = ["unsigned", "two's complement"][usize::from(port.signed)];
            let (name, width) = (&port.name, port.width);
            let _ = writeln!(text, "//   {direction} {name:<14} {width:>2} {reading}");
        }
        let _ = writeln!(text, "//\n// Made by: {}", self.command);
        let _ = writeln!(text, "// SPDX-License-Identifier: {LICENCE}");
        text
    }
}

/// Columns of the statements of a header at most.
const COLUMNS: usize = 120;

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
