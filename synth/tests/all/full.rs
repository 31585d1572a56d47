//! Synthesis with the real tools: only with `IMOGENE_FULL=1`, as `scripts/test --full` sets it, and then a missing tool
//! fails.

use crate::is_full;
use crate::regression::USUAL;
use crate::table::out_of_date;
use imogene_contract::{Request, RootForm, Unit};
use imogene_synth::baseline::{CheckOptions, RowCheck, check};
use imogene_synth::regression::Verdict;
use imogene_synth::table::{self, Table};
use imogene_synth::{Cache, SynthError, SynthReport, Target, synthesise};
use std::path::{Path, PathBuf};

fn run(unit: Unit, target: Target) -> SynthReport {
    let request = Request::new(unit);
    synthesise(&request, target, 1, Cache::Use)
        .unwrap_or_else(|error| panic!("{} for {}: {error}", unit.name(), target.name()))
}

#[test]
fn a_unit_is_synthesised_for_every_target() {
    if !is_full() {
        return;
    }
    for target in Target::ALL {
        let report = run(Unit::Pe1, target);
        if target == Target::Transistors {
            assert!(report.transistors > Some(1_000), "{report:?}");
            continue;
        }
        // Two registers of 26 bits, and nothing else that keeps a value.
        assert_eq!(report.ff, Some(52), "{report:?}");
        assert_eq!(report.dsp, Some(0), "{report:?}");
        assert!(report.lut > Some(26), "{report:?}");
        let is_placed = !matches!(target, Target::Xilinx7 | Target::Gowin);
        assert_eq!(report.fmax_mhz.is_some(), is_placed, "{report:?}");
        assert_eq!(report.logic_cells.is_some(), is_placed, "{report:?}");
    }
}

#[test]
fn the_exact_root_of_a_target_takes_no_more_cells_than_the_other() {
    if !is_full() {
        return;
    }
    let cells = |target: Target, form| {
        let request = Request::new(Unit::QuadricPe).with_root_form(form);
        let request = request.expect("a unit with a root");
        let report = synthesise(&request, target, 0, Cache::Use);
        report.expect("a report").logic_cells.expect("cells")
    };
    for target in [Target::Ecp5With45k, Target::Ice40Hx8k] {
        let all = [RootForm::Restoring, RootForm::NonRestoring].map(|form| cells(target, form));
        let own = cells(target, target.exact_root());
        assert!(all.iter().all(|other| own <= *other), "{all:?}");
    }
}

#[test]
fn a_report_is_kept() {
    if !is_full() {
        return;
    }
    let first = run(Unit::VisibilityNode, Target::Ice40Hx8k);
    // The seconds are measured once: equal ones show that the second report is the first.
    assert_eq!(run(Unit::VisibilityNode, Target::Ice40Hx8k), first);
}

/// A file of the documentation.
fn page(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs")).join(name)
}

fn check_all(rows: &[table::Row], baseline: &Table, clock: bool, cache: Cache) -> Vec<RowCheck> {
    let options = CheckOptions {
        tolerance: USUAL,
        clock,
        cache,
    };
    check(rows, baseline, &options, || ()).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_written_baseline_is_of_this_verilog_and_of_the_written_table() {
    if !is_full() {
        return;
    }
    let baseline = Table::read(&page("resources.json")).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(out_of_date(&baseline), Vec::<String>::new());
    let text = std::fs::read_to_string(page("resources.md")).expect("the table is written");
    let stale = "`imogene synth --table` writes both";
    assert_eq!(text, baseline.markdown(), "{stale}");
    assert!(page(table::PICTURE).is_file(), "the picture is written");
}

#[test]
fn small_rows_hold_the_written_baseline() {
    if !is_full() {
        return;
    }
    let baseline = Table::read(&page("resources.json")).unwrap_or_else(|e| panic!("{e}"));
    let mut rows = table::select(Some(Unit::Pe1), None);
    rows.extend(table::select(Some(Unit::CutPlane), None));
    let mut checks = check_all(&rows, &baseline, false, Cache::Renew);
    let clocked = table::select(Some(Unit::Pe1), Some(Target::Ice40Hx8k));
    checks.extend(check_all(&clocked, &baseline, true, Cache::Renew));
    for check in checks {
        assert!(check.verdict != Verdict::Worse, "{check:?}");
        assert!(check.is_same_verilog, "{check:?}");
    }
}

/// Rows that take no time: resources alone.
fn few_rows() -> Vec<table::Row> {
    let mut rows = table::select(Some(Unit::CutPlane), None);
    for row in &mut rows {
        row.seeds = 0;
    }
    rows
}

fn make(rows: &[table::Row]) -> Table {
    let table = table::make(rows, None, Cache::Use, |_| ());
    table.unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn what_a_table_knows_is_not_measured_again() {
    if !is_full() {
        return;
    }
    let rows = few_rows();
    let mut known = make(&rows);
    // No tool gives this figure: it can only be the one of the known table.
    known.rows[0].figures.lut = Some(1);
    known.rows[1].figures.lut = Some(1);
    known.rows[1].verilog = "other".into();
    let again = table::make(&rows, Some(&known), Cache::Use, |_| ());
    let again = again.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(again.rows[0], known.rows[0]);
    assert_eq!(again.rows[1], make(&rows).rows[1]);
}

#[test]
fn a_table_of_few_rows_is_its_own_baseline() {
    if !is_full() {
        return;
    }
    let rows = few_rows();
    let baseline = make(&rows);
    for check in check_all(&rows, &baseline, true, Cache::Use) {
        assert_eq!(check.verdict, Verdict::Same, "{check:?}");
        assert!(check.is_same_verilog, "{check:?}");
    }
    // Synthesised anew, the same tools give the same figures.
    for check in check_all(&rows, &baseline, true, Cache::Renew) {
        assert_eq!(check.verdict, Verdict::Same, "{check:?}");
    }
}

#[test]
fn a_row_that_got_worse_and_other_tools_are_found() {
    if !is_full() {
        return;
    }
    let rows = few_rows();
    let table = make(&rows);
    let mut smaller = table.clone();
    let cells = smaller.rows[1].figures.cells.expect("cells");
    smaller.rows[1].figures.cells = Some(cells * 9 / 10);
    let checks = check_all(&rows, &smaller, true, Cache::Use);
    let verdicts: Vec<Verdict> = checks.iter().map(|check| check.verdict).collect();
    assert_eq!(verdicts, [Verdict::Same, Verdict::Worse]);
    let mut older = table;
    older.rows[1].tools.insert("yosys".into(), "0.1".into());
    let options = CheckOptions {
        tolerance: USUAL,
        clock: true,
        cache: Cache::Use,
    };
    let error = check(&rows, &older, &options, || ()).expect_err("other tools");
    assert!(matches!(error, SynthError::OtherTools { .. }), "{error}");
    assert!(error.to_string().contains("yosys 0.1"), "{error}");
    let mut otherwise = make(&rows);
    otherwise.rows[1].synthesis = "synth -top other".into();
    let error = check(&rows, &otherwise, &options, || ()).expect_err("another command");
    assert!(error.to_string().contains("-top other"), "{error}");
}
