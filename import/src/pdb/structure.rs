//! The atoms of a file, as they stand in it.

use super::columns::Columns;
use super::element::{self, Element, UNKNOWN};
use crate::error::ImportError;
use std::collections::HashMap;

/// An atom.
#[derive(Clone, Debug)]
pub struct Atom {
    /// Serial number as it is written: five columns hold decimal, hybrid-36 and hexadecimal numbers, or stars.
    pub serial: String,
    /// Name without spaces.
    pub name: String,
    /// Alternate location, or a space.
    pub alternate: u8,
    /// Residue name.
    pub residue: String,
    /// Chain, or a space.
    pub chain: u8,
    /// Residue number and insertion code as they are written.
    pub number: String,
    /// Place in angstroms.
    pub place: [f64; 3],
    /// Share of the molecules that have the atom here; 1 if the file does not say.
    pub occupancy: f64,
    /// What it is.
    pub element: &'static Element,
}

impl Atom {
    /// Part of a water molecule.
    pub fn is_water(&self) -> bool {
        const NAMES: [&str; 13] = [
            "HOH", "WAT", "H2O", "DOD", "SOL", "TIP", "TP3", "TIP3", "TIP4", "T3P", "T4P", "SPC",
            "OH2",
        ];
        NAMES.iter().any(|n| n.eq_ignore_ascii_case(&self.residue))
    }
}

/// The atoms of one model.
#[derive(Debug)]
pub struct Model {
    /// Its number in the file.
    pub number: i64,
    /// Atoms in the order of the file.
    pub atoms: Vec<Atom>,
}

/// What a file holds.
#[derive(Debug, Default)]
pub struct Structure {
    /// Title, or the classification of the header, or nothing.
    pub title: String,
    /// The four characters of the entry, or nothing.
    pub entry: String,
    /// Models that have atoms.
    pub models: Vec<Model>,
    /// Pairs of serial numbers that are bonded.
    pub connections: Vec<[String; 2]>,
    /// What was unusual, each with the number of lines.
    pub remarks: HashMap<Remark, usize>,
}

/// What a reader may want to know of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Remark {
    /// Element from the atom's name.
    NamedElement,
    /// Element unknown.
    NoElement,
    /// Occupancy not a number.
    NoOccupancy,
}

/// State of a reading.
#[derive(Default)]
struct Reading {
    structure: Structure,
    header: String,
    /// Number that the next atoms' model has been given, if it has not begun yet.
    next_model: Option<i64>,
}

impl Structure {
    /// Reads the lines of a file.
    pub fn read(bytes: &[u8], file: &str) -> Result<Structure, ImportError> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        refuse_others(bytes, file)?;
        let mut reading = Reading {
            next_model: Some(1),
            ..Reading::default()
        };
        // Old Macintosh files end their lines with a carriage return alone.
        let end = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
        for (index, line) in bytes.split(|c| *c == end).enumerate() {
            let line = line.strip_suffix(b"\r").unwrap_or(line);
            reading.line(&Columns::new(file, index + 1, line), line)?;
        }
        let mut structure = reading.structure;
        if structure.title.is_empty() {
            structure.title = reading.header;
        }
        if structure.models.is_empty() {
            return Err(unusable(
                file,
                "it has no ATOM or HETATM line",
                "a structure in the PDB format with at least one atom would be accepted",
            ));
        }
        Ok(structure)
    }
}

/// Formats that are mistaken for this one.
fn refuse_others(bytes: &[u8], file: &str) -> Result<(), ImportError> {
    let first = bytes.trim_ascii_start();
    let accepted =
        "a structure in the PDB format, text with ATOM lines of fixed columns, would be accepted";
    let refuse = |problem| Err(unusable(file, problem, accepted));
    if first.starts_with(b"data_") || first.starts_with(b"loop_") {
        return refuse("this is a file in the mmCIF format");
    }
    if bytes.starts_with(&[0x1f, 0x8b]) {
        return refuse("this is a compressed file");
    }
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return refuse("this is text in UTF-16");
    }
    Ok(())
}

/// A refusal of the file as a whole.
pub fn unusable(
    file: &str,
    problem: impl Into<String>,
    accepted: impl Into<String>,
) -> ImportError {
    ImportError::Unusable {
        file: file.to_owned(),
        problem: problem.into(),
        accepted: accepted.into(),
    }
}

impl Reading {
    fn line(&mut self, columns: &Columns, line: &[u8]) -> Result<(), ImportError> {
        let record = columns.field(1, 6).to_ascii_uppercase();
        let is = |name: &str| record == name;
        // Serial numbers of six digits reach into the record's name or into the column behind their own.
        if record.starts_with("ATOM")
            && record[4..].trim_start().bytes().all(|c| c.is_ascii_digit())
            || is("HETATM")
        {
            return self.atom(columns);
        }
        if is("MODEL") {
            let number = columns.number(7, 14).filter(|n| n.fract() == 0.0);
            self.next_model = Some(number.map_or_else(|| self.following(), |n| n as i64));
        } else if is("ENDMDL") || is("END") {
            // Some programs write one of the two between models and no MODEL line.
            self.next_model = Some(self.following());
        } else if is("CONECT") {
            self.connections(columns);
        } else if is("TITLE") {
            join(&mut self.structure.title, line, 10);
        } else if is("HEADER") {
            self.structure.entry = columns.field(63, 66);
            self.header = columns.field(11, 50);
        }
        Ok(())
    }

    /// The number of a model without one.
    fn following(&self) -> i64 {
        self.structure
            .models
            .last()
            .map_or(1, |m| m.number.saturating_add(1))
    }

    fn atom(&mut self, columns: &Columns) -> Result<(), ImportError> {
        let place = [
            columns.coordinate('x', 31, 38)?,
            columns.coordinate('y', 39, 46)?,
            columns.coordinate('z', 47, 54)?,
        ];
        let residue = columns.field(18, 20);
        let atom = Atom {
            serial: serial(columns),
            name: columns.field(13, 16),
            alternate: columns.character(17),
            chain: columns.character(22),
            number: columns.field(23, 27).replace(' ', ""),
            place,
            occupancy: self.occupancy(columns),
            element: self.element(columns, &residue),
            residue,
        };
        if let Some(number) = self.next_model.take() {
            let atoms = Vec::new();
            self.structure.models.push(Model { number, atoms });
        }
        let model = self.structure.models.last_mut();
        model.expect("begun with the first atom").atoms.push(atom);
        Ok(())
    }

    fn occupancy(&mut self, columns: &Columns) -> f64 {
        if columns.field(55, 60).is_empty() {
            return 1.0;
        }
        columns.number(55, 60).unwrap_or_else(|| {
            self.remark(Remark::NoOccupancy);
            1.0
        })
    }

    fn element(&mut self, columns: &Columns, residue: &str) -> &'static Element {
        // A charge may have slipped into the columns of the symbol; in files before 1996 there are digits.
        let text = columns.field(77, 78);
        let letters: String = text.chars().take_while(char::is_ascii_alphabetic).collect();
        if let Some(element) = element::of_symbol(&letters) {
            return element;
        }
        let name = std::array::from_fn(|k| columns.character(13 + k));
        let found = element::of_name(name, residue);
        self.remark(match found {
            Some(_) => Remark::NamedElement,
            None => Remark::NoElement,
        });
        found.unwrap_or(&UNKNOWN)
    }

    fn connections(&mut self, columns: &Columns) {
        let from = columns.field(7, 11);
        for first in [12, 17, 22, 27] {
            let to = columns.field(first, first + 4);
            if !from.is_empty() && !to.is_empty() && from != to {
                self.structure.connections.push([from.clone(), to]);
            }
        }
    }

    fn remark(&mut self, remark: Remark) {
        *self.structure.remarks.entry(remark).or_default() += 1;
    }
}

/// The serial number, with a sixth digit in front or behind if there is one.
fn serial(columns: &Columns) -> String {
    let digit = |column| columns.character(column).is_ascii_digit();
    let first = if digit(6) { 6 } else { 7 };
    let last = if digit(11) && digit(12) { 12 } else { 11 };
    columns.field(first, last)
}

/// Adds the text of a continued record, which keeps what is not ASCII.
fn join(text: &mut String, line: &[u8], skipped: usize) {
    let whole = String::from_utf8_lossy(line);
    let part: String = whole.chars().skip(skipped).take(70).collect();
    let plain = |c: char| if c.is_control() { ' ' } else { c };
    let part: String = part.trim().chars().map(plain).collect();
    // Some hundred lines of title are the work of a program gone wrong.
    if part.is_empty() || text.len() > 400 {
        return;
    }
    if !text.is_empty() && !text.ends_with('-') {
        text.push(' ');
    }
    text.push_str(&part);
}
