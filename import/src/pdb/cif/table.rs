//! A category as rows of texts, and what those beside the atoms say: title, bonds, assemblies.

use super::super::assembly::{Copies, IDENTITY, Part, Rows};
use super::super::structure::{End, Structure};
use super::super::words::{Words, plain};
use super::atoms::number;
use crate::error::{Error, Result};
use std::collections::HashMap;

/// A value and where it begins in its file; nothing where the file has `?` or `.`.
pub type Cell<'a> = (&'a [u8], usize);

/// The categories of a block by their names, with a row for each entry.
pub type Tables = HashMap<&'static str, Vec<Row>>;

/// An entry of a category: values by their items, with where they begin. The first of two equal items counts.
#[derive(Debug, Default)]
pub struct Row(HashMap<String, (String, usize)>);

impl Row {
    pub fn set(&mut self, item: &str, (bytes, at): Cell) {
        let text = || (String::from_utf8_lossy(bytes).into_owned(), at);
        self.0.entry(item.to_owned()).or_insert_with(text);
    }

    pub fn value(&self, item: &str) -> (&str, usize) {
        self.0.get(item).map_or(("", 0), |(text, at)| (text, *at))
    }

    pub fn text(&self, item: &str) -> &str {
        self.value(item).0
    }
}

/// Kinds of bonds that are drawn; hydrogen bonds and mismatched bases are not.
const BONDS: [&str; 4] = ["covale", "disulf", "metalc", "modres"];
/// Where a partner stands that has not been moved to another cell of the crystal.
const HERE: &str = "1_555";

/// Makes the error of a value: where it begins, what is wrong, what would be accepted.
pub type Blame<'a> = &'a dyn Fn(usize, String, &str) -> Error;

/// Fills in all but the atoms.
pub fn finish(structure: &mut Structure, tables: &Tables, blame: Blame) {
    let rows = |name| tables.get(name).into_iter().flatten();
    let text = |name, item| {
        let found = rows(name).map(|row| row.text(item)).next();
        let line = found.unwrap_or_default().replace(['\r', '\n'], " ");
        plain(line.trim().as_bytes())
    };
    structure.entry = text("_entry", "id");
    structure.title = text("_struct", "title");
    for row in rows("_struct_conn") {
        connection(structure, row);
    }
    let assemblies = &mut structure.assemblies;
    for row in rows("_pdbx_struct_assembly_gen") {
        assemblies.parts.push(part(row, &mut structure.words));
    }
    for row in rows("_pdbx_struct_oper_list") {
        match operator(row, blame) {
            Ok(operator) => {
                let name = row.text("id").to_owned();
                assemblies.operators.insert(name, operator);
            }
            Err(error) => drop(assemblies.problem.get_or_insert(error)),
        }
    }
}

fn connection(structure: &mut Structure, row: &Row) {
    let kind = row.text("conn_type_id");
    if !BONDS.iter().any(|bond| kind.eq_ignore_ascii_case(bond)) {
        return;
    }
    let symmetries = ["ptnr1_symmetry", "ptnr2_symmetry"].map(|item| row.text(item));
    if symmetries.iter().any(|s| !s.is_empty() && *s != HERE) {
        structure.other_cells += 1;
        return;
    }
    let words = &mut structure.words;
    let ends = [1, 2].map(|n| {
        let item = |text: &str| text.replace('#', &n.to_string());
        let first = |own: &str, label: &str| {
            let [own, label] = [own, label].map(|text| row.text(&item(text)));
            if own.is_empty() { label } else { own }
        };
        let chain = first("ptnr#_label_asym_id", "ptnr#_auth_asym_id");
        let number = first("ptnr#_auth_seq_id", "ptnr#_label_seq_id");
        let insertion = row.text(&item("pdbx_ptnr#_pdb_ins_code"));
        let atom = row.text(&item("ptnr#_label_atom_id"));
        let alternate = row.text(&item("pdbx_ptnr#_label_alt_id"));
        let number = format!("{number}{insertion}");
        End::Names([chain, &number, atom, alternate].map(|text| words.keep_bytes(text.as_bytes())))
    });
    if ends[0] != ends[1] {
        structure.connections.push(ends);
    }
}

fn part(row: &Row, words: &mut Words) -> Part {
    let chains = row.text("asym_id_list").split(',').map(str::trim);
    let chains = chains.filter(|chain| !chain.is_empty());
    Part {
        assembly: plain(row.text("assembly_id").as_bytes()),
        chains: chains.map(|c| words.keep_bytes(c.as_bytes())).collect(),
        copies: Copies::Expression(plain(row.text("oper_expression").as_bytes())),
    }
}

fn operator(row: &Row, blame: Blame) -> Result<Rows> {
    let mut rows = IDENTITY;
    for (i, line) in rows.iter_mut().enumerate() {
        for (j, value) in line.iter_mut().enumerate() {
            let item = match j {
                3 => format!("vector[{}]", i + 1),
                _ => format!("matrix[{}][{}]", i + 1, j + 1),
            };
            let (text, at) = row.value(&item);
            *value = number(text.as_bytes()).ok_or_else(|| {
                let id = row.text("id");
                let problem =
                    format!("{item} of operator `{id}` is `{text}`, not a number up to 1e8");
                let accepted = "a decimal number such as 0.5 would be accepted";
                blame(at, plain(problem.as_bytes()), accepted)
            })?;
        }
    }
    Ok(rows)
}
