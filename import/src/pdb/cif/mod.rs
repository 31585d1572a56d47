//! The PDBx/mmCIF format: categories of items in a CIF text.
//!
//! Only categories that a picture needs are kept; the atoms go from the text into the structure row by row.

mod atoms;
mod table;
mod token;

pub use atoms::{Atoms, WANTED};
pub use table::{Cell, Row, Tables, finish};

use super::structure::Structure;
use super::words::plain;
use crate::error::{Error, Result};
use token::{Token, Tokens};

pub const ATOMS: &str = "_atom_site";
const KEPT: [&str; 6] = [
    ATOMS,
    "_entry",
    "_struct",
    "_struct_conn",
    "_pdbx_struct_assembly_gen",
    "_pdbx_struct_oper_list",
];

/// Where the items of [`WANTED`] stand among those of a file; `None` if it has no coordinates.
pub fn columns(items: &[String]) -> Option<[Option<usize>; WANTED.len()]> {
    let columns = WANTED.map(|name| items.iter().position(|item| item == name));
    columns[..3].iter().all(Option::is_some).then_some(columns)
}

pub fn read(bytes: &[u8]) -> Result<Structure> {
    let mut reader = Reader {
        tokens: Tokens { bytes, at: 0 },
        name: String::new(),
        tables: Tables::new(),
        other: None,
        structure: Structure::default(),
    };
    reader.blocks()?;
    let mut structure = reader.structure;
    if structure.models.is_empty() {
        return Err(no_atoms(reader.other));
    }
    finish(&mut structure, &reader.tables, &|at, problem, accepted| {
        reader.tokens.malformed(at, problem, accepted)
    });
    if structure.entry.is_empty() {
        structure.entry = reader.name;
    }
    Ok(structure)
}

pub fn no_atoms(other: Option<&str>) -> Error {
    let problem = other.unwrap_or("it has no atom in the category _atom_site");
    let accepted = "a structure in the PDBx/mmCIF format, with atoms in _atom_site.Cartn_x, _y and _z, would be accepted";
    Error::whole(problem, accepted)
}

/// What a category says of a file that has no atoms.
pub fn instead_of_atoms(category: &str) -> Option<&'static str> {
    Some(match category {
        "_atom_site_fract_x" => {
            "this is the CIF of a small molecule or a crystal, with atoms as fractions of its cell in _atom_site_fract_x"
        }
        "_chem_comp_atom" => {
            "this is the definition of a chemical component, which has no _atom_site"
        }
        "_refln" => "these are structure factors, which have no _atom_site",
        _ => return None,
    })
}

struct Reader<'a> {
    tokens: Tokens<'a>,
    /// Name and tables of the block.
    name: String,
    tables: Tables,
    other: Option<&'static str>,
    structure: Structure,
}

/// The category and the item of a tag; the items of small molecules have no point.
fn parts(tag: &[u8]) -> (String, String) {
    let tag = String::from_utf8_lossy(tag);
    match tag.split_once('.') {
        Some((category, item)) => (category.to_ascii_lowercase(), item.to_ascii_lowercase()),
        None => (tag.to_ascii_lowercase(), String::new()),
    }
}

pub fn kept(category: &str) -> Option<&'static str> {
    KEPT.into_iter().find(|name| *name == category)
}

impl<'a> Reader<'a> {
    /// A value, if one follows.
    fn value(&mut self) -> Result<Option<Cell<'a>>> {
        Ok(match self.tokens.next()? {
            Some((Token::Bare(b"?" | b"."), at)) => Some((&[], at)),
            Some((Token::Bare(text) | Token::Quoted(text), at)) => Some((text, at)),
            Some((_, at)) => {
                self.tokens.at = at;
                None
            }
            None => None,
        })
    }

    /// The blocks up to the end of the first that has atoms.
    fn blocks(&mut self) -> Result<()> {
        while let Some((token, at)) = self.tokens.next()? {
            match token {
                Token::Data(name) => {
                    self.only_atom()?;
                    if !self.structure.models.is_empty() {
                        self.structure.other_blocks = true;
                        return Ok(());
                    }
                    self.name = plain(name);
                    self.tables.clear();
                }
                Token::Loop => self.whole_loop(at)?,
                Token::Tag(tag) => self.item(tag, at)?,
                Token::Other => {}
                Token::Bare(_) | Token::Quoted(_) => {
                    let problem = "a value without a name";
                    let accepted = "a name such as _entry.id before each value would be accepted";
                    return Err(self.tokens.malformed(at, problem, accepted));
                }
            }
        }
        self.only_atom()
    }

    fn item(&mut self, tag: &[u8], at: usize) -> Result<()> {
        let (category, item) = parts(tag);
        let Some(value) = self.value()? else {
            let problem = format!("the item `{}` has no value", plain(tag));
            let accepted = "a value behind each name, such as ?, would be accepted";
            return Err(self.tokens.malformed(at, problem, accepted));
        };
        self.other = self.other.or_else(|| instead_of_atoms(&category));
        if let Some(name) = kept(&category) {
            let rows = self.tables.entry(name).or_default();
            rows.resize_with(rows.len().max(1), Row::default);
            rows[0].set(&item, value);
        }
        Ok(())
    }

    /// Takes over the atom whose items stood one by one.
    fn only_atom(&mut self) -> Result<()> {
        let mut atoms = Atoms::default();
        for row in self.tables.remove(ATOMS).into_iter().flatten() {
            let cells = WANTED.map(|item| row.value(item));
            if cells[..3].iter().any(|(text, _)| !text.is_empty()) {
                self.atom(&mut atoms, cells.map(|(text, at)| (text.as_bytes(), at)))?;
            }
        }
        Ok(())
    }

    fn atom(&mut self, atoms: &mut Atoms, cells: [Cell; WANTED.len()]) -> Result<()> {
        let pushed = atoms.push(&mut self.structure, &cells.map(|(text, _)| text));
        pushed.map_err(|defect| {
            let at = cells[defect.column].1;
            self.tokens.malformed(at, defect.problem, defect.accepted)
        })
    }

    fn whole_loop(&mut self, start: usize) -> Result<()> {
        let (mut category, mut items) = (String::new(), vec![]);
        while let Some((token, at)) = self.tokens.next()? {
            let Token::Tag(tag) = token else {
                self.tokens.at = at;
                break;
            };
            let (of, item) = parts(tag);
            self.other = self.other.or_else(|| instead_of_atoms(&of));
            category = of;
            items.push(item);
        }
        let width = items.len();
        if width == 0 {
            let problem = "a loop without names";
            let accepted = "names such as _atom_site.id behind `loop_` would be accepted";
            return Err(self.tokens.malformed(start, problem, accepted));
        }
        match (kept(&category), columns(&items)) {
            (Some(ATOMS), Some(columns)) => {
                let mut atoms = Atoms::default();
                self.rows(width, |reader, row| {
                    let cells = columns.map(|k| k.map_or((&[][..], row[0].1), |k| row[k]));
                    reader.atom(&mut atoms, cells)
                })
            }
            (None | Some(ATOMS), _) => self.rows(width, |_, _| Ok(())),
            (Some(name), _) => {
                let mut table = vec![];
                self.rows(width, |_, cells| {
                    let mut row = Row::default();
                    for (item, cell) in items.iter().zip(cells) {
                        row.set(item, *cell);
                    }
                    table.push(row);
                    Ok(())
                })?;
                self.tables.insert(name, table);
                Ok(())
            }
        }
    }

    fn rows(
        &mut self,
        width: usize,
        mut take: impl FnMut(&mut Self, &[Cell<'a>]) -> Result<()>,
    ) -> Result<()> {
        let mut row: Vec<Cell> = Vec::with_capacity(width);
        while let Some(value) = self.value()? {
            row.push(value);
            if row.len() == width {
                take(self, &row)?;
                row.clear();
            }
        }
        let Some((_, at)) = row.first() else {
            return Ok(());
        };
        let count = row.len();
        let problem = format!("the last row of the loop has {count} of {width} values");
        let accepted = format!("{width} values in each row, one for each name, would be accepted");
        Err(self.tokens.malformed(*at, problem, accepted))
    }
}
