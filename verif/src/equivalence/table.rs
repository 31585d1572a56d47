//! The table of all units.

use super::{Verdict, unit};
use crate::engine::design::DesignError;
use imogene_contract::{Request, Unit};
use imogene_hdl::Module;
use imogene_rtl::emit::design;

/// A unit and what was found of it.
pub struct Row {
    /// Unit.
    pub unit: Unit,
    /// Bits of its registers.
    pub bits: u32,
    /// What was found; nothing of a unit with a memory, which has too many bits.
    pub verdict: Option<Verdict>,
}

impl Row {
    /// Compares a unit at a depth word.
    pub fn of(unit_of_row: Unit, depth_word: u32) -> Result<Row, DesignError> {
        let request = Request::of(unit_of_row, depth_word);
        let design = design(&request)?;
        let register_bits = |module: &Module| {
            let registers = module.registers.iter();
            registers
                .map(|register| module.node(register.net).width)
                .sum()
        };
        Ok(Row {
            unit: unit_of_row,
            bits: sums(&design.top, &register_bits),
            verdict: match memory_bits(&design.top) {
                0 => Some(unit(&request)?),
                _ => None,
            },
        })
    }
}

/// Bits of all block memories in a module. Each is a register to a proof.
pub fn memory_bits(module: &Module) -> u32 {
    let own = |module: &Module| {
        let memories = module.memories.iter();
        memories
            .map(|memory| memory.words as u32 * memory.width)
            .sum()
    };
    sums(module, &own)
}

/// The sum over a module and all its instances.
fn sums(module: &Module, of: &dyn Fn(&Module) -> u32) -> u32 {
    let inner = module.instances.iter();
    of(module)
        + inner
            .map(|instance| sums(&instance.module, of))
            .sum::<u32>()
}

/// The rows as Markdown.
pub fn markdown(rows: &[Row]) -> String {
    let mut text = String::from("| unit | bits of registers | rust-hdl's text |\n|---|---|---|\n");
    for Row {
        unit,
        bits,
        verdict,
    } in rows
    {
        let verdict = match verdict {
            Some(Verdict::Equal) => "equal",
            Some(Verdict::Differs(_)) => "differs",
            Some(Verdict::Open) => "open",
            None => "has a memory",
        };
        text += &format!("| {} | {bits} | {verdict} |\n", unit.name());
    }
    text
}
