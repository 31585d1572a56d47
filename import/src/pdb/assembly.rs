//! Assemblies: the molecules of a file as copies of its chains, moved by operators.

use super::columns::Columns;
use super::words::{Word, Words, listed};
use crate::error::{Error, Result};
use crate::kit::short;
use indexmap::IndexSet;
use std::collections::HashMap;

/// Most operators of a part of an assembly; the largest virus shells have some thousand.
const MOST_OPERATORS: usize = 100_000;
/// What is possible where an assembly is not.
pub const AS_THEY_STAND: &str = "the coordinates as they stand are drawn without --assembly";

/// A movement, or the copy of a crystal: three rows of a matrix, each with its displacement in angstroms behind.
pub type Rows = [[f64; 4]; 3];

pub const IDENTITY: Rows = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
];

/// An operator by the name that the file gives it, or that its parts have together.
#[derive(Clone, Debug, PartialEq)]
pub struct Operator {
    pub name: String,
    pub rows: Rows,
}

impl Operator {
    /// The place of a point, to 10^-4 angstroms: operators have six to ten digits.
    pub fn place(&self, point: [f64; 3]) -> [f64; 3] {
        if self.is_identity() {
            return point;
        }
        let [x, y, z] = point;
        self.rows
            .map(|[a, b, c, d]| short(a * x + b * y + c * z + d))
    }

    pub fn is_identity(&self) -> bool {
        self.rows == IDENTITY
    }

    /// This one after another.
    fn after(&self, first: &Operator) -> Operator {
        let value = |row: &[f64; 4], column: usize| {
            let sum: f64 = (0..3).map(|k| row[k] * first.rows[k][column]).sum();
            sum + if column == 3 { row[3] } else { 0.0 }
        };
        Operator {
            name: format!("{}-{}", self.name, first.name),
            rows: self.rows.map(|row| std::array::from_fn(|c| value(&row, c))),
        }
    }
}

/// How a file says which operators.
pub enum Copies {
    /// One after another.
    List(Vec<Operator>),
    /// By their names: `1,2`, `(1-60)`, or `(X0)(1-5)`, of which the right is applied first.
    Expression(String),
}

/// Chains, and what is made of them.
pub struct Part {
    pub assembly: String,
    /// Its chains; all if there are none.
    pub chains: Vec<Word>,
    pub copies: Copies,
}

/// Chains, all if there are none, and the copies of each.
pub type Moved = (Vec<Word>, Vec<Operator>);

/// What can be put together of copies of the chains of a file.
#[derive(Default)]
pub struct Assemblies {
    pub parts: Vec<Part>,
    pub operators: HashMap<String, Rows>,
    /// Why they cannot be used, if they cannot: told to those who ask for one.
    pub problem: Option<Error>,
}

impl Assemblies {
    pub fn names(&self) -> Vec<&str> {
        let names: IndexSet<&str> = self.parts.iter().map(|p| p.assembly.as_str()).collect();
        names.into_iter().collect()
    }

    pub fn find(&mut self, name: &str) -> Result<Vec<Moved>> {
        if let Some(problem) = self.problem.take() {
            return Err(problem);
        }
        let names = self.names();
        if names.is_empty() {
            return Err(Error::whole("it describes no assembly", AS_THEY_STAND));
        }
        if !names.contains(&name) {
            let accepted = format!("--assembly {} would be accepted", listed(names));
            return Err(Error::whole(format!("it has no assembly {name}"), accepted));
        }
        let parts = self.parts.iter().filter(|part| part.assembly == name);
        let moved = |part: &Part| {
            let operators = match &part.copies {
                Copies::List(operators) => Ok(operators.clone()),
                Copies::Expression(text) => expand(text, &self.operators),
            };
            let problem = |problem| format!("assembly {name}: {problem}");
            let operators = operators.map_err(|e| Error::whole(problem(e), AS_THEY_STAND))?;
            Ok((part.chains.clone(), operators))
        };
        parts.map(moved).collect()
    }
}

/// The operators of an expression.
fn expand(text: &str, known: &HashMap<String, Rows>) -> Result<Vec<Operator>, String> {
    let mut factors = factors(text)?.into_iter();
    let mut all = list(factors.next().unwrap_or_default(), known)?;
    for factor in factors {
        let factor = list(factor, known)?;
        if all.len() * factor.len() > MOST_OPERATORS {
            return Err(format!("`{text}` is more than {MOST_OPERATORS} operators"));
        }
        let pairs = all.iter().flat_map(|o| factor.iter().map(|f| o.after(f)));
        all = pairs.collect();
    }
    match all.is_empty() {
        true => Err("it names no operator".to_owned()),
        false => Ok(all),
    }
}

/// The lists of an expression, those in brackets and those without.
fn factors(text: &str) -> Result<Vec<&str>, String> {
    let wrong = || format!("`{text}` is no list of operators such as 1,2 or (X0)(1-5)");
    let mut rest = text.trim();
    let mut factors = vec![];
    while !rest.is_empty() {
        let (factor, behind) = match rest.strip_prefix('(') {
            Some(inner) => inner.split_once(')').ok_or_else(wrong)?,
            None => rest.split_at(rest.find('(').unwrap_or(rest.len())),
        };
        if factor.contains(['(', ')']) {
            return Err(wrong());
        }
        factors.push(factor);
        rest = behind.trim_start();
    }
    Ok(factors)
}

fn list(text: &str, known: &HashMap<String, Rows>) -> Result<Vec<Operator>, String> {
    let find = |name: &str| match known.get(name) {
        Some(rows) => Ok(Operator {
            name: name.to_owned(),
            rows: *rows,
        }),
        None => Err(format!("there is no operator `{name}`")),
    };
    let mut operators = vec![];
    for item in text.split(',').map(str::trim).filter(|i| !i.is_empty()) {
        let number = |text: &str| text.trim().parse::<u32>().ok();
        let (first, last) = item.split_once('-').unwrap_or_default();
        match (number(first), number(last)) {
            (Some(first), Some(last)) if !known.contains_key(item) => {
                if first > last {
                    return Err(format!("`{item}` runs backwards"));
                }
                // The first name that is not there ends the longest range.
                for number in first..=last {
                    operators.push(find(&number.to_string())?);
                }
            }
            _ => operators.push(find(item)?),
        }
        if operators.len() > MOST_OPERATORS {
            return Err(format!("`{text}` is more than {MOST_OPERATORS} operators"));
        }
    }
    Ok(operators)
}

/// The lines of REMARK 350 of the PDB format that have been read: biological molecules as copies of chains.
#[derive(Default)]
pub struct Biomt {
    /// Molecules that the next part is of.
    molecules: Vec<String>,
    parts: Vec<Lines>,
    problem: Option<Error>,
}

#[derive(Default)]
struct Lines {
    molecules: Vec<String>,
    chains: Vec<String>,
    /// Numbers that have not been read are none.
    operators: Vec<Operator>,
}

impl Biomt {
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
        let molecules = match &self.molecules[..] {
            [] => vec!["1".to_owned()],
            molecules => molecules.to_vec(),
        };
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
        if part.operators.last().is_none_or(|o| o.name != name) {
            let rows = [[f64::NAN; 4]; 3];
            part.operators.push(Operator { name, rows });
        }
        let operator = part.operators.last_mut().expect("there is one");
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

    pub fn assemblies(mut self, words: &mut Words) -> Assemblies {
        let mut parts = vec![];
        for lines in self.parts {
            let mut numbers = lines.operators.iter().flat_map(|o| o.rows.as_flattened());
            if numbers.any(|number| number.is_nan()) && self.problem.is_none() {
                let problem =
                    "REMARK 350 has an operator without its lines BIOMT1, BIOMT2 and BIOMT3";
                self.problem = Some(Error::whole(problem, AS_THEY_STAND));
            }
            for assembly in lines.molecules {
                parts.push(Part {
                    assembly,
                    chains: lines.chains.iter().map(|c| words.keep(c)).collect(),
                    copies: Copies::List(lines.operators.clone()),
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

fn items(text: &str) -> Vec<String> {
    let items = text.split(',').map(str::trim);
    items.filter(|i| !i.is_empty()).map(str::to_owned).collect()
}
