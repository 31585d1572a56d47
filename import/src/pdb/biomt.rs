//! REMARK 350 of the PDB format: biological molecules as copies of chains.

use super::assembly::{AS_THEY_STAND, Assemblies, Copies, Operator, Part, Rows};
use super::columns::Columns;
use super::words::Words;
use crate::error::{ImportError, unusable};

/// The remarks read so far.
#[derive(Default)]
pub struct Reading {
    /// Molecules that the next part is of.
    molecules: Vec<String>,
    parts: Vec<Lines>,
    problem: Option<ImportError>,
}

/// Chains and operators of some molecules.
#[derive(Default)]
struct Lines {
    molecules: Vec<String>,
    chains: Vec<String>,
    operators: Vec<(Operator, [bool; 3])>,
}

impl Reading {
    /// Takes a line of the remark.
    pub fn line(&mut self, columns: &Columns) {
        let text = columns.field(11, 80);
        let after = |label: &str| {
            let (before, behind) = text.split_once(':')?;
            before.trim().eq_ignore_ascii_case(label).then_some(behind)
        };
        if let Some(names) = after("BIOMOLECULE") {
            self.molecules = items(names);
        } else if let Some(chains) = after("APPLY THE FOLLOWING TO CHAINS") {
            self.begin();
            self.chains(chains);
        } else if let Some(chains) = after("AND CHAINS") {
            self.chains(chains);
        } else if columns.bytes(14, 18) == b"BIOMT" {
            let row = usize::from(columns.character(19).wrapping_sub(b'1'));
            if row < 3 {
                self.row(columns, row);
            }
        }
    }

    fn begin(&mut self) {
        let mut molecules = self.molecules.clone();
        if molecules.is_empty() {
            molecules.push("1".to_owned());
        }
        let lines = Lines::default();
        self.parts.push(Lines { molecules, ..lines });
    }

    fn chains(&mut self, text: &str) {
        if let Some(part) = self.parts.last_mut() {
            // Files from before 2007 name a chain without a name so.
            let named = |name: String| if name == "NULL" { String::new() } else { name };
            part.chains.extend(items(text).into_iter().map(named));
        }
    }

    fn row(&mut self, columns: &Columns, row: usize) {
        if self.parts.is_empty() {
            self.begin();
        }
        let part = self.parts.last_mut().expect("begun");
        let name = columns.field(20, 23);
        let is_new = part.operators.last().is_none_or(|(o, _)| o.name != name);
        if is_new {
            let rows = Rows::default();
            part.operators.push((Operator { name, rows }, [false; 3]));
        }
        let (operator, seen) = part.operators.last_mut().expect("there is one");
        seen[row] = true;
        for (k, first) in [24, 34, 44, 54].into_iter().enumerate() {
            let last = if k == 3 { 68 } else { first + 9 };
            let number = columns.number(first, last);
            if number.is_none() && self.problem.is_none() {
                let text = columns.field(first, last);
                let problem = format!("`{text}` of an operator is not a number");
                let accepted = format!(
                    "a decimal number such as 0.500000 in columns {first} to {last} would be accepted"
                );
                self.problem = Some(columns.error(first, problem, accepted));
            }
            operator.rows[row][k] = number.unwrap_or_default();
        }
    }

    /// What the remarks say.
    pub fn assemblies(mut self, words: &mut Words, file: &str) -> Assemblies {
        let mut parts = vec![];
        for lines in self.parts {
            let whole = lines.operators.iter().all(|(_, seen)| *seen == [true; 3]);
            if !whole && self.problem.is_none() {
                let problem =
                    "REMARK 350 has an operator without its lines BIOMT1, BIOMT2 and BIOMT3";
                self.problem = Some(unusable(file, problem, AS_THEY_STAND));
            }
            let operators: Vec<Operator> = lines.operators.into_iter().map(|(o, _)| o).collect();
            for assembly in lines.molecules {
                parts.push(Part {
                    assembly,
                    chains: lines.chains.iter().map(|c| words.keep(c)).collect(),
                    copies: Copies::List(operators.clone()),
                });
            }
        }
        Assemblies {
            parts,
            problem: self.problem,
            ..Assemblies::default()
        }
    }
}

/// The names of a list.
fn items(text: &str) -> Vec<String> {
    let items = text.split(',').map(str::trim);
    items.filter(|i| !i.is_empty()).map(str::to_owned).collect()
}
