//! The PDB format: lines of fixed columns.

use super::assembly::Biomt;
use super::columns::Columns;
use super::structure::{Atom, End, Model, Serial, Structure};
use super::words::Repeated;
use crate::error::{Error, Result};

#[derive(Default)]
struct Reading {
    structure: Structure,
    header: String,
    /// Number that the next atoms' model has been given, if it has not begun yet.
    next_model: Option<i64>,
    biomt: Biomt,
    residue: Repeated,
    number: Repeated,
}

pub fn read(bytes: &[u8]) -> Result<Structure> {
    let mut reading = Reading {
        next_model: Some(1),
        ..Reading::default()
    };
    // Old Macintosh files end their lines with a carriage return alone.
    let end = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
    for (index, line) in bytes.split(|c| *c == end).enumerate() {
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        reading.line(&Columns::new(index + 1, line), line)?;
    }
    let mut structure = reading.structure;
    if structure.title.is_empty() {
        structure.title = reading.header;
    }
    if structure.models.is_empty() {
        let accepted = "a structure in the PDB format with at least one atom would be accepted";
        return Err(Error::whole("it has no ATOM or HETATM line", accepted));
    }
    structure.assemblies = reading.biomt.assemblies(&mut structure.words);
    Ok(structure)
}

impl Reading {
    fn line(&mut self, columns: &Columns, line: &[u8]) -> Result<()> {
        let record = columns.record();
        // Serial numbers of six digits reach into the record's name or into the column behind their own.
        let digits = || record[4..].trim_ascii().iter().all(u8::is_ascii_digit);
        match &record {
            b"HETATM" => return self.atom(columns),
            [b'A', b'T', b'O', b'M', ..] if digits() => return self.atom(columns),
            b"MODEL " => {
                let number = columns.number(7, 14).filter(|n| n.fract() == 0.0);
                self.next_model = Some(number.map_or_else(|| self.following(), |n| n as i64));
            }
            // Some programs write one of the two between models and no MODEL line.
            b"ENDMDL" | b"END   " => self.next_model = Some(self.following()),
            b"CONECT" => self.connections(columns),
            b"REMARK" if columns.bytes(8, 10) == b"350" => self.biomt.line(columns),
            b"TITLE " => join(&mut self.structure.title, line, 10),
            b"HEADER" => {
                self.structure.entry = columns.field(63, 66);
                self.header = columns.field(11, 50);
            }
            _ => {}
        }
        Ok(())
    }

    /// The number of a model without one.
    fn following(&self) -> i64 {
        let last = self.structure.models.last();
        last.map_or(1, |m| m.number.saturating_add(1))
    }

    fn atom(&mut self, columns: &Columns) -> Result<()> {
        let place = [
            columns.coordinate('x', 31, 38)?,
            columns.coordinate('y', 39, 46)?,
            columns.coordinate('z', 47, 54)?,
        ];
        let is_given = !columns.bytes(55, 60).trim_ascii().is_empty();
        let structure = &mut self.structure;
        let occupancy = structure.occupancy(is_given, columns.number(55, 60));
        let element = structure.element(columns.bytes(77, 78).trim_ascii(), || {
            let name = std::array::from_fn(|k| columns.character(13 + k));
            (name, columns.field(18, 20))
        });
        let words = &mut self.structure.words;
        let mut again = |known: &mut Repeated, first, last| {
            let text = || columns.field(first, last).replace(' ', "");
            known.of(columns.bytes(first, last), || words.keep(&text()))
        };
        let residue = again(&mut self.residue, 18, 20);
        let number = again(&mut self.number, 23, 27);
        let chain = words.keep_bytes(columns.bytes(22, 22).trim_ascii());
        // A sixth digit of a serial number stands in front or behind.
        let digit = |column| columns.character(column).is_ascii_digit();
        let first = if digit(6) { 6 } else { 7 };
        let last = if digit(11) && digit(12) { 12 } else { 11 };
        let atom = Atom {
            place,
            element,
            serial: Serial::of(columns.bytes(first, last).trim_ascii(), words),
            occupancy,
            name: words.keep_bytes(columns.bytes(13, 16).trim_ascii()),
            alternate: words.keep_bytes(columns.bytes(17, 17).trim_ascii()),
            residue,
            number,
            chain,
            part: chain,
        };
        if let Some(number) = self.next_model.take() {
            let atoms = Vec::new();
            self.structure.models.push(Model { number, atoms });
        }
        let model = self.structure.models.last_mut();
        model.expect("begun with the first atom").atoms.push(atom);
        Ok(())
    }

    fn connections(&mut self, columns: &Columns) {
        let from = columns.bytes(7, 11).trim_ascii();
        for first in [12, 17, 22, 27] {
            let to = columns.bytes(first, first + 4).trim_ascii();
            if !from.is_empty() && !to.is_empty() && from != to {
                let words = &mut self.structure.words;
                let ends = [from, to].map(|text| End::Serial(Serial::of(text, words)));
                self.structure.connections.push(ends);
            }
        }
    }
}

/// Adds the text of a continued record, which keeps what is not ASCII.
fn join(text: &mut String, line: &[u8], skipped: usize) {
    let whole = String::from_utf8_lossy(line);
    let part: String = whole.chars().skip(skipped).take(70).collect();
    let part = part.trim().replace(char::is_control, " ");
    // Some hundred lines of title are the work of a program gone wrong.
    if part.is_empty() || text.len() > 400 {
        return;
    }
    if !text.is_empty() && !text.ends_with('-') {
        text.push(' ');
    }
    text.push_str(&part);
}
