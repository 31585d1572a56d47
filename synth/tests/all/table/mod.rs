//! A table for the tests of its page, and tests of its rows and its file.

mod markdown;
mod picture;
mod transistors;

use imogene_contract::{Request, Unit};
use imogene_rtl::emit::emit;
use imogene_synth::table::rows::{DEVICES, units};
use imogene_synth::table::{Measured, Row, Table, rows, select};
use imogene_synth::{Figures, SynthError, Target, digest};
use std::collections::BTreeMap;
use std::path::Path;

/// A table of all rows with figures that are none of any tool, all different.
pub fn invented() -> Table {
    let rows = rows().into_iter().enumerate();
    Table::of(rows.map(|(index, row)| measured(&row, index)).collect())
}

/// Depth word and parameters of a request, by option of the command line.
fn parameters(request: &Request) -> BTreeMap<String, usize> {
    let options = [("format", request.depth_word)].into_iter();
    let options = options.chain(request.options());
    let options = options.map(|(option, value)| (option.to_owned(), value as usize));
    options.collect()
}

fn measured(row: &Row, index: usize) -> Measured {
    let count = |base: u64| (row.target != Target::Transistors).then_some(base + index as u64);
    Measured {
        section: row.section,
        unit: row.request.unit.name().to_owned(),
        parameters: parameters(&row.request),
        target: row.target.name().to_owned(),
        seeds: row.seeds,
        tools: BTreeMap::from([("yosys".to_owned(), "0.1".to_owned())]),
        synthesis: row.synthesis(),
        latency: row.request.latency(),
        figures: Figures {
            lut: count(1_000),
            ff: count(2_000),
            carry: count(300),
            dsp: count(0),
            bram: count(0),
            cells: count(4_000),
            transistors: (row.target == Target::Transistors).then_some(50_000 + index as u64),
            fmax_mhz: (row.seeds > 0).then_some(100.5 + index as f64),
            does_not_fit: None,
        },
        slowest_path: None,
        verilog: format!("{index:064}"),
    }
}

#[test]
fn every_unit_of_the_machine_is_in_the_table_for_every_device() {
    let rows = rows();
    for target in DEVICES {
        for unit in units() {
            let shown = |row: &&Row| row.target == target && row.request.unit == unit;
            assert!(rows.iter().any(|row| shown(&row)), "{}", unit.name());
        }
    }
}

#[test]
fn every_request_is_legal() {
    for row in rows() {
        row.request.check().expect("a legal request");
    }
}

#[test]
fn rows_are_selected_by_unit_and_target() {
    let both = select(Some(Unit::CutPlane), None);
    let targets: Vec<Target> = both.iter().map(|row| row.target).collect();
    assert_eq!(targets, DEVICES);
    let one = select(Some(Unit::CutPlane), Some(Target::Ice40Hx8k));
    assert_eq!(one, both[1..]);
    assert_eq!(select(None, None), rows());
    assert!(select(None, Some(Target::Gowin)).is_empty());
}

fn read(text: &str) -> Result<Table, SynthError> {
    let file = tempfile::NamedTempFile::new().expect("a temporary file");
    std::fs::write(file.path(), text).expect("a file");
    Table::read(file.path())
}

#[test]
fn what_is_written_is_read() {
    let written = invented();
    assert_eq!(read(&written.json()).expect("a table"), written);
}

#[test]
fn a_file_that_is_not_there_or_none_is_one_message() {
    let missing = Table::read(Path::new("no/resources.json")).expect_err("no file");
    let message = missing.to_string();
    for part in ["no/resources.json", "imogene synth --table"] {
        assert!(message.contains(part), "{message}");
    }
    let whole = invented().json();
    for text in ["", "{", "[1]", &whole[..whole.len() / 2]] {
        let message = read(text).expect_err("no table").to_string();
        assert!(message.contains("line "), "{message}");
    }
    let misspelt = whole.replace("\"lut\"", "\"luts\"");
    let message = read(&misspelt).expect_err("no table").to_string();
    assert!(message.contains("luts"), "{message}");
    let newer = whole.replace("\"version\": 3", "\"version\": 4");
    let message = read(&newer).expect_err("no table").to_string();
    assert!(message.contains("version 4"), "{message}");
}

#[test]
fn a_row_is_found_by_all_that_it_is() {
    let known = invented();
    let mut row = rows()[0];
    assert_eq!(known.find(&row), Some(&known.rows[0]));
    row.seeds += 1;
    assert_eq!(known.find(&row), None);
    row = rows()[0];
    row.request.depth_word = 16;
    assert_eq!(known.find(&row), None);
}

#[test]
fn every_figure_is_on_the_page() {
    let table = invented();
    let page = table.markdown();
    let lines = page.lines().filter(|line| line.starts_with("| `"));
    assert_eq!(lines.count(), rows().len());
    let counts: [fn(&mut Figures) -> &mut Option<u64>; 7] = [
        |figures| &mut figures.lut,
        |figures| &mut figures.ff,
        |figures| &mut figures.carry,
        |figures| &mut figures.dsp,
        |figures| &mut figures.bram,
        |figures| &mut figures.cells,
        |figures| &mut figures.transistors,
    ];
    for row in 0..table.rows.len() {
        for count in counts {
            let mut other = table.clone();
            if let Some(count) = count(&mut other.rows[row].figures) {
                *count += 1;
                assert_ne!(other.markdown(), page, "row {row}");
            }
        }
        let mut other = table.clone();
        if let Some(clock) = &mut other.rows[row].figures.fmax_mhz {
            *clock += 1.0;
            assert_ne!(other.markdown(), page, "row {row}");
        }
    }
}

/// Where a table differs from the rows and the Verilog of today; empty if it is current.
pub fn out_of_date(table: &Table) -> Vec<String> {
    let today = rows();
    let mut problems = vec![];
    for row in &today {
        let emitted = emit(&row.request).expect("every unit is emitted");
        let verilog = digest(&emitted.bundle());
        match table.find(row) {
            None => problems.push(format!("{row:?}: no row")),
            Some(known) if known.verilog != verilog => {
                problems.push(format!("{row:?}: other Verilog"));
            }
            Some(_) => {}
        }
    }
    if table.rows.len() != today.len() {
        problems.push(format!("{} rows of {}", table.rows.len(), today.len()));
    }
    problems
}

#[test]
fn other_verilog_and_rows_too_few_are_out_of_date() {
    let mut table = invented();
    table.rows.truncate(1);
    let problems = out_of_date(&table);
    assert!(problems[0].contains("other Verilog"), "{problems:?}");
    assert_eq!(problems.len(), rows().len() + 1);
}
