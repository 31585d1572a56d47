//! What a board is delivered with beside its sources: a page for a person, and a FuseSoC core (CAPI2).

use super::description::{Board, Family};
use super::error::BoardError;
use super::pll::Pll;
use minijinja::value::Serde;
use minijinja::{Environment, Value, context};
use serde::Serialize;
use serde_json::json;

/// The page of a board, of the keys of its report. Fails when the report lacks what the page says.
pub fn page(board: &Board, report: &impl Serialize) -> Result<String, BoardError> {
    let values = context! {
        name => board.name.clone(), bitstream => board.bitstream(), report => Value::from(Serde(report)),
    };
    let text = Environment::new().render_str(include_str!("page/board.md"), values)?;
    Ok(text + "\n")
}

/// The core file by which FuseSoC makes a bitstream of the sources; none of a board without a part.
pub fn core_file(board: &Board, pll: &Pll, command: &str) -> Result<Option<String>, BoardError> {
    let Some(part) = &board.part else {
        return Ok(None);
    };
    let (kind, flow) = match part.family {
        Family::Ecp5 => ("lpf", "trellis"),
        Family::Ice40 => ("pcf", "icestorm"),
        Family::Gowin => ("cst", "apicula"),
        Family::Xilinx7 => ("xdc", "vivado"),
    };
    // The flow of a Gowin has its part in keys of its own.
    let is_gowin = part.family == Family::Gowin;
    let mut options = if is_gowin { vec![] } else { part.arguments() };
    let is_vivado = part.family == Family::Xilinx7;
    let vivado = is_vivado.then(|| part.number());
    let file_type = match is_vivado {
        true => kind.to_owned(),
        false => kind.to_uppercase(),
    };
    options.extend(["--freq".to_owned(), format!("{:.6}", pll.pixel_mhz())]);
    let synthesis: Vec<&str> = part.synthesis().split(' ').skip(1).collect();
    // JSON is YAML.
    let values = context! {
        name => board.name.clone(), version => env!("CARGO_PKG_VERSION"), about => json!(board.about).to_string(),
        device => is_gowin.then(|| part.package.clone()), command, kind, file_type, vivado, flow, options => json!(options).to_string(), synthesis => json!(synthesis).to_string(),
    };
    let text = Environment::new().render_str(include_str!("page/board.core"), values)?;
    Ok(Some(text + "\n"))
}
