//! The netlist that synthesis makes of a unit, run in the engines against the golden model. Needs the packages 'yosys'
//! and 'iverilog', and under `IMOGENE_FULL=1` 'verilator', 'g++' and the tools of `scripts/setup --synth`; fails
//! without them.

use crate::common::{columns, is_full, json, run};

fn check(unit: &str, engine: &str, target: &str, clocks: u32) {
    let report = json(&format!(
        "cosim {unit} --engine {engine} --netlist {target} --clocks {clocks}"
    ));
    assert_eq!(report["mismatches"], 0, "{unit} on {target}");
    assert_eq!(report["netlist"], target);
    assert_eq!(report["engine"], engine);
    assert!(report["pixels"].as_u64().unwrap() > 100, "{unit}: {report}");
    let reproduce = report["reproduce"].as_str().unwrap();
    let netlist = format!("--netlist {target}");
    assert!(reproduce.contains(&netlist), "{reproduce}");
}

#[test]
fn small_units_agree_after_synthesis() {
    for unit in ["pe1", "cut_plane"] {
        check(unit, "icarus", "ice40-hx8k", 1_000);
    }
}

/// The normal unit has multipliers, of which ECP5 has no model; iCE40 makes them of look-up tables.
#[test]
fn the_units_of_the_quadric_processor_agree_after_synthesis() {
    if !is_full() {
        return;
    }
    let units = "pe2 quadric_pe plane_depth quadric_cut";
    for unit in units.split(' ') {
        for target in ["ice40-hx8k", "ecp5-45k"] {
            check(unit, "verilator", target, 20_000);
        }
    }
    check("normal_unit", "verilator", "ice40-hx8k", 20_000);
    check("quadric_processor", "icarus", "ice40-hx8k", 1_000);
}

#[test]
fn what_cannot_be_run_is_refused_by_name() {
    let cases = "
        pe1 --netlist ice40-hx8k                              | --engine icarus
        pe1 --engine icarus --netlist xilinx7                 | ice40-hx8k
        pe1 --engine icarus --netlist ecp6                    | there is no target `ecp6`
        scenes/cone.toml --engine icarus --netlist ice40-hx8k | --netlist is for a unit, not for a scene
    ";
    for [line, part] in columns(cases) {
        run(&format!("cosim {line}")).refused(&[part]);
    }
}
