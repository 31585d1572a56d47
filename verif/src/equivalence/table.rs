//! The table of all units.

use super::{Comparison, EquivalenceError, Verdict, unit};
use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::EmitRequest;

/// A unit and what was found of it.
pub struct Row {
    /// Unit.
    pub unit: Unit,
    /// rust-hdl's text as it prints it, and with ranges at its signed constants; or why it prints none.
    pub found: Result<[Comparison; 2], String>,
}

impl Row {
    /// Compares a unit at a depth word.
    ///
    /// # Errors
    ///
    /// When a tool is missing or refuses a text. A unit that rust-hdl cannot print is a row.
    pub fn of(unit_of_row: Unit, depth_word: usize) -> Result<Row, EquivalenceError> {
        let request = EmitRequest {
            depth_word,
            ..EmitRequest::new(unit_of_row)
        };
        let found = match unit(&request, false) {
            Ok(printed) => Ok([printed, unit(&request, true)?]),
            Err(EquivalenceError::Emit(error)) => Err(error.to_string()),
            Err(error) => return Err(error),
        };
        Ok(Row {
            unit: unit_of_row,
            found,
        })
    }
}

/// The rows as Markdown.
pub fn markdown(rows: &[Row]) -> String {
    let mut text = String::from(
        "| unit | registers | bits | rust-hdl's text as printed | with ranges at its signed constants |\n|---|---|---|---|---|\n",
    );
    for row in rows {
        text += &match &row.found {
            Ok([printed, ranged]) => format!(
                "| {} | {} | {} | {} | {} |\n",
                row.unit.name(),
                printed.registers,
                printed.bits,
                word(&printed.verdict),
                word(&ranged.verdict)
            ),
            Err(_) => format!("| {} | | | cannot be printed | |\n", row.unit.name()),
        };
    }
    text
}

fn word(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Equal => "equal",
        Verdict::Differs(_) => "differs",
        Verdict::Open => "open",
    }
}
