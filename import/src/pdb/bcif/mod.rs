//! The BinaryCIF format: the categories of mmCIF as encoded columns in MessagePack.

mod decode;

use super::cif::{
    ATOMS, Atoms, Row, Tables, WANTED, columns, finish, instead_of_atoms, kept, no_atoms,
};
use super::structure::Structure;
use crate::error::{Error, Result};
use decode::{Budget, Read, Values, array, get, text};
use rmpv::ValueRef;

/// Values for each byte of a file, at most; real files have fewer than ten.
const MOST_VALUES_PER_BYTE: usize = 100;
const ALWAYS: usize = 1 << 20;

/// A column that is read: its name, its values, and which of them the file does not give.
struct Column<'a> {
    item: String,
    values: Values<'a>,
    mask: Option<Vec<i64>>,
}

impl Column<'_> {
    /// Writes the text of a value; nothing if the file does not give it.
    fn write(&self, row: usize, text: &mut String) {
        text.clear();
        if self.mask.as_ref().is_none_or(|mask| mask[row] == 0) {
            self.values.write(row, text);
        }
    }
}

/// Reads the first block that has atoms.
pub fn read(bytes: &[u8]) -> Result<Structure> {
    let accepted = "a whole file in the BinaryCIF format, version 0.3, would be accepted";
    let refuse = |problem: String| Error::whole(problem, accepted);
    let mut rest = bytes;
    let root = rmpv::decode::read_value_ref(&mut rest)
        .map_err(|error| refuse(format!("it is not MessagePack: {error}")))?;
    let mut budget = Budget(ALWAYS + MOST_VALUES_PER_BYTE * bytes.len());
    let blocks = get(&root, "dataBlocks").and_then(array).map_err(refuse)?;
    let mut other = None;
    for (place, block) in blocks.iter().enumerate() {
        let mut structure = Structure::default();
        let tables = read_block(block, &mut structure, &mut other, &mut budget);
        let tables = tables.map_err(|problem| refuse(format!("block {}: {problem}", place + 1)))?;
        if structure.models.is_empty() {
            continue;
        }
        structure.other_blocks = place + 1 < blocks.len();
        let blame = |_: usize, problem: String, accepted: &str| Error::whole(problem, accepted);
        finish(&mut structure, &tables, &blame);
        return Ok(structure);
    }
    Err(no_atoms(other))
}

/// The atoms of a block, and its other categories.
fn read_block(
    block: &ValueRef,
    structure: &mut Structure,
    other: &mut Option<&'static str>,
    budget: &mut Budget,
) -> Read<Tables> {
    let mut tables = Tables::default();
    for category in array(get(block, "categories")?)? {
        let name = text(get(category, "name")?)?.to_ascii_lowercase();
        *other = other.or_else(|| instead_of_atoms(&name));
        let Some(name) = kept(&name) else { continue };
        let rows = match get(category, "rowCount")? {
            ValueRef::Integer(count) => count.as_u64().and_then(|n| usize::try_from(n).ok()),
            _ => None,
        };
        let rows = rows.ok_or_else(|| format!("{name}: its `rowCount` is no count"))?;
        let columns = read_columns(category, name, rows, budget);
        let columns = columns.map_err(|problem| format!("{name}.{problem}"))?;
        if name == ATOMS {
            push_atoms(&columns, rows, structure)?;
        } else {
            tables.insert(name, table(&columns, rows));
        }
    }
    Ok(tables)
}

fn read_columns<'a>(
    category: &ValueRef<'a>,
    name: &str,
    rows: usize,
    budget: &mut Budget,
) -> Read<Vec<Column<'a>>> {
    let mut columns = vec![];
    for column in array(get(category, "columns")?)? {
        let item = text(get(column, "name")?)?.to_ascii_lowercase();
        if name == ATOMS && !WANTED.contains(&item.as_str()) {
            continue;
        }
        let named = |problem: String| format!("{item}: {problem}");
        let values = get(column, "data").and_then(|data| budget.decode(data));
        let values = values.map_err(named)?;
        let mask = match get(column, "mask") {
            Ok(ValueRef::Nil) | Err(_) => None,
            Ok(mask) => match budget.decode(mask).map_err(named)? {
                Values::Whole(mask) => Some(mask),
                _ => return Err(named("its mask is not of whole numbers".to_owned())),
            },
        };
        let lengths = [Some(values.len()), mask.as_ref().map(Vec::len)];
        if let Some(length) = lengths.into_iter().flatten().find(|length| *length != rows) {
            return Err(named(format!("{length} values in {rows} rows")));
        }
        columns.push(Column { item, values, mask });
    }
    Ok(columns)
}

fn table(columns: &[Column], rows: usize) -> Vec<Row> {
    let mut text = String::new();
    let row = |place| {
        let mut row = Row::default();
        for column in columns {
            column.write(place, &mut text);
            row.set(&column.item, (text.as_bytes(), 0));
        }
        row
    };
    // A category without columns has no rows, whatever it says.
    let rows = if columns.is_empty() { 0 } else { rows };
    (0..rows).map(row).collect()
}

fn push_atoms(given: &[Column], rows: usize, structure: &mut Structure) -> Read<()> {
    let items: Vec<String> = given.iter().map(|column| column.item.clone()).collect();
    let Some(columns) = columns(&items) else {
        return Ok(());
    };
    let mut atoms = Atoms::default();
    let mut texts: [String; WANTED.len()] = Default::default();
    for row in 0..rows {
        for (text, column) in texts.iter_mut().zip(columns) {
            if let Some(column) = column {
                given[column].write(row, text);
            }
        }
        let cells = texts.each_ref().map(|text| text.as_bytes());
        atoms.push(structure, &cells).map_err(|defect| {
            let (item, row) = (WANTED[defect.column], row + 1);
            let (problem, accepted) = (defect.problem, defect.accepted);
            format!("{ATOMS}.{item}, row {row}: {problem}; {accepted}")
        })?;
    }
    Ok(())
}
