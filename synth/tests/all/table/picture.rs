use super::invented;
use imogene_synth::table::rows::{DEVICES, ROOTS, ROWS_PER_STAGE, Section};

/// Area, clock, and latency in clocks and in time.
const PANELS: usize = 4;

#[test]
fn every_figure_has_its_mark_and_every_line_its_name() {
    let table = invented();
    let picture = table.picture().expect("a drawing").expect("a picture");
    let lines = DEVICES.len() * ROOTS.len();
    // A mark for each number of rows, and one beside each name in the first panel.
    let marks = PANELS * lines * ROWS_PER_STAGE.len() + lines;
    assert_eq!(picture.matches("<circle").count(), marks);
    for name in [
        "non-restoring, ice40-hx8k",
        "restoring, ecp5-45k",
        "Fmax (MHz)",
    ] {
        assert!(picture.contains(name), "{name}");
    }
}

#[test]
fn a_table_without_a_clock_has_no_picture() {
    let mut table = invented();
    let mut rows = table.rows.iter_mut();
    let root = rows.find(|row| row.section == Section::Rows);
    root.expect("a row of a root").figures.fmax_mhz = None;
    assert_eq!(table.picture().expect("no failure"), None);
}
