//! Rows of `_atom_site`.

use super::super::structure::{Atom, Model, Serial, Structure};
use super::super::words::{Repeated, plain};
use crate::kit::decimal;
use std::collections::HashMap;

/// The items that are read, in the order in which a row is handed on.
pub const WANTED: [&str; 17] = [
    "cartn_x",
    "cartn_y",
    "cartn_z",
    "id",
    "type_symbol",
    "label_atom_id",
    "auth_atom_id",
    "label_alt_id",
    "auth_comp_id",
    "label_comp_id",
    "auth_asym_id",
    "label_asym_id",
    "auth_seq_id",
    "label_seq_id",
    "pdbx_pdb_ins_code",
    "occupancy",
    "pdbx_pdb_model_num",
];

/// Largest magnitude of a coordinate, in angstroms.
const MOST: f64 = 1e8;

/// A value that cannot be used: its place in [`WANTED`], what is wrong, and what would be accepted.
pub struct Defect {
    pub column: usize,
    pub problem: String,
    pub accepted: &'static str,
}

/// What the rows before have shown: the next one has most of its words too.
#[derive(Default)]
pub struct Atoms {
    models: HashMap<i64, usize>,
    /// Text of the model of the last atom, and its place.
    model: (Vec<u8>, usize),
    residue: Repeated,
    chain: Repeated,
    part: Repeated,
    number: Repeated,
}

impl Atoms {
    /// Adds an atom; an empty value is one that the file does not give.
    pub fn push(
        &mut self,
        structure: &mut Structure,
        row: &[&[u8]; WANTED.len()],
    ) -> Result<(), Defect> {
        let [x, y, z, id, symbol, name, own_name, alternate, rest @ ..] = *row;
        let [own_residue, residue, own_chain, chain, rest @ ..] = rest;
        let [own_number, number, insertion, occupancy, model] = rest;
        let place = [coordinate(x, 0)?, coordinate(y, 1)?, coordinate(z, 2)?];
        let model = self.model(structure, model)?;
        let name = given(name, own_name);
        let residue = given(own_residue, residue);
        let element = structure.element(symbol, || (in_columns(name), plain(residue)));
        let occupancy = structure.occupancy(!occupancy.is_empty(), self::number(occupancy));
        let words = &mut structure.words;
        let mut again = |last: &mut Repeated, text: &[u8]| last.of(text, || words.keep_bytes(text));
        let residue = again(&mut self.residue, residue);
        let part = again(&mut self.part, given(chain, own_chain));
        let chain = again(&mut self.chain, given(own_chain, chain));
        let number = [given(own_number, number), insertion].concat();
        let number = again(&mut self.number, &number);
        let atom = Atom {
            place,
            element,
            serial: Serial::of(id, words),
            occupancy,
            name: words.keep_bytes(name),
            alternate: words.keep_bytes(alternate),
            residue,
            number,
            chain,
            part,
        };
        structure.models[model].atoms.push(atom);
        Ok(())
    }

    /// The place of a model, which begins with its first atom.
    fn model(&mut self, structure: &mut Structure, text: &[u8]) -> Result<usize, Defect> {
        if self.model.0 == text && !structure.models.is_empty() {
            return Ok(self.model.1);
        }
        let number = match std::str::from_utf8(text).ok().map(str::parse) {
            Some(Ok(number)) => number,
            _ if text.is_empty() => 1,
            _ => {
                let text = plain(text);
                return Err(Defect {
                    column: 16,
                    problem: format!("the number `{text}` of the model is not a whole number"),
                    accepted: "a number such as 1 would be accepted",
                });
            }
        };
        let next = structure.models.len();
        let place = *self.models.entry(number).or_insert(next);
        if place == next {
            let atoms = vec![];
            structure.models.push(Model { number, atoms });
        }
        self.model = (text.to_vec(), place);
        Ok(place)
    }
}

/// The first that the file gives.
fn given<'a>(first: &'a [u8], second: &'a [u8]) -> &'a [u8] {
    if first.is_empty() { second } else { first }
}

/// A number; its uncertainty may stand behind it in brackets.
pub fn number(text: &[u8]) -> Option<f64> {
    let end = text.iter().position(|c| *c == b'(').unwrap_or(text.len());
    let value = decimal(&text[..end], b"+-.eE");
    value.filter(|value| value.abs() <= MOST)
}

fn coordinate(text: &[u8], column: usize) -> Result<f64, Defect> {
    let axis = ["x", "y", "z"][column];
    number(text).ok_or_else(|| Defect {
        column,
        problem: match plain(text).as_str() {
            "" => format!("the atom has no {axis} coordinate"),
            text => format!("the {axis} coordinate `{text}` is not a number up to 1e8"),
        },
        accepted: "a decimal number such as -12.345 would be accepted",
    })
}

/// A name as it stands, if it is short, in the columns of the other format.
fn in_columns(name: &[u8]) -> [u8; 4] {
    let first = usize::from(name.len() < 4);
    std::array::from_fn(|k| {
        let letter = k.checked_sub(first).and_then(|k| name.get(k));
        letter.copied().filter(u8::is_ascii).unwrap_or(b' ')
    })
}
