//! A table for the tests of its pages, and tests of its rows.

use super::is_current;
use super::rows::{DEVICES, Row, Table, rows, select, units};
use crate::report::SynthReport;
use crate::target::Target;
use imogene_contract::Unit;
use std::collections::BTreeMap;

/// A table of all rows with figures that are none of any tool, all different.
pub fn invented() -> Table {
    let rows = rows().into_iter().enumerate();
    Table {
        rows: rows
            .map(|(index, row)| (row, report(&row, index)))
            .collect(),
        digest: "0123".repeat(16),
    }
}

fn report(row: &Row, index: usize) -> SynthReport {
    let count = |base: u64| (row.target != Target::Transistors).then_some(base + index as u64);
    SynthReport {
        unit: row.request.unit.name().to_owned(),
        target: row.target.name().to_owned(),
        parameters: crate::flow::parameters(&row.request),
        latency: row.request.latency(),
        lut: count(1_000),
        ff: count(2_000),
        carry: count(300),
        dsp: count(0),
        bram: count(0),
        logic_cells: count(4_000),
        transistors: (row.target == Target::Transistors).then_some(50_000 + index as u64),
        fmax_mhz: (row.options.seeds > 0).then_some(100.5 + index as f64),
        does_not_fit: None,
        seeds: Vec::new(),
        goal_mhz: Some(300),
        cells: BTreeMap::new(),
        tools: BTreeMap::from([("yosys".to_owned(), "0.70".to_owned())]),
        verilog: format!("{index:064}"),
        seconds: 1.0,
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

#[test]
fn another_text_is_not_current() {
    assert!(!is_current("# Resources").expect("every unit is emitted"));
}
