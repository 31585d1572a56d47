//! Synthesis with the real tools: only with `IMOGENE_FULL=1`, as `scripts/test --full` sets it, and then a missing tool fails.

use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::EmitRequest;
use imogene_synth::{Options, SynthReport, Target, synthesise, table};

fn is_full() -> bool {
    std::env::var_os("IMOGENE_FULL").is_some_and(|value| value == "1")
}

fn run(unit: Unit, target: Target) -> SynthReport {
    let request = EmitRequest::new(unit);
    synthesise(&request, target, &Options { seeds: 1 })
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
        // Four registers of 26 bits, and nothing else that keeps a value.
        assert_eq!(report.ff, Some(104), "{report:?}");
        assert_eq!(report.dsp, Some(0), "{report:?}");
        assert!(report.lut > Some(26), "{report:?}");
        let is_placed = !matches!(target, Target::Xilinx7 | Target::Gowin);
        assert_eq!(report.fmax_mhz.is_some(), is_placed, "{report:?}");
        assert_eq!(report.logic_cells.is_some(), is_placed, "{report:?}");
    }
}

#[test]
fn a_report_is_kept() {
    if !is_full() {
        return;
    }
    let first = run(Unit::TwoVolumeMerge, Target::Ice40Hx8k);
    // The seconds are measured once: equal ones show that the second report is the first.
    assert_eq!(run(Unit::TwoVolumeMerge, Target::Ice40Hx8k), first);
}

#[test]
fn the_written_table_is_of_this_verilog() {
    if !is_full() {
        return;
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/resources.md");
    let text = std::fs::read_to_string(path).expect("the table is written");
    assert!(
        table::is_current(&text).expect("every unit is emitted"),
        "docs/resources.md was made of other Verilog; run `imogene synth --table`"
    );
}
