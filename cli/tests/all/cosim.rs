//! `imogene cosim` and `speed`: seeds, widths, faults, engines, waveforms.

use crate::common::{COSIM_KEYS, Place, Run, assert_keys, imogene, json, run};
use serde_json::Value;

#[test]
fn cosim_replays_its_seed_and_writes_waveforms() {
    let place = Place::new();
    let again = || place.json("cosim pe2 --seed 42 --clocks 3000 --vcd pe2.vcd");
    let report = again();
    assert_keys(&report, COSIM_KEYS);
    assert_eq!(report["seed"], 42);
    assert_eq!(report["mismatches"], 0);
    let first = place.bytes("pe2.vcd");
    again();
    let other = "the same seed gave another stimulus";
    assert_eq!(first, place.bytes("pe2.vcd"), "{other}");
    assert!(place.has("pe2.gtkw"));
}

#[test]
fn waveforms_of_a_scene_begin_where_it_is_said() {
    let place = Place::new();
    let cosim = "cosim scenes/cone.toml --size 48x36 --vcd cone.vcd";
    let run = |more: &str| place.run(&format!("{cosim} {more}"));
    run("--vcd-from 5,1 --vcd-clocks 40").ended(0);
    let text = place.text("cone.vcd");
    // Pixel 48 + 5.
    assert!(text.contains("#530\n") && !text.contains("#520\n"));
    run("--vcd-from line:3 --vcd-clocks 40").ended(0);
    let text = place.text("cone.vcd");
    assert!(text.contains("#1440\n") && !text.contains("#1430\n"));
    std::fs::remove_file(place.path("cone.vcd")).unwrap();

    run("--vcd-at-mismatch").ended(0);
    assert!(!place.has("cone.vcd"), "nothing differs");
    run("--vcd-at-mismatch --inject-fault 0:2:18").ended(1);
    assert!(place.has("cone.vcd"));

    for (given, wanted) in [
        ("48,0", "accepted: 0,0 to 47,35"),
        ("line:36", "accepted: 0,0 to 47,35"),
        ("frame:2", "accepted: frame:1"),
        ("7", "COLUMN,LINE"),
    ] {
        run(&format!("--vcd-from {given}")).refused(&[wanted]);
    }
}

#[test]
fn cosim_of_a_scene_takes_any_widths() {
    let cosim = |more: &str| json(&format!("cosim scenes/cone.toml --size 48x36 {more}"));
    // Bit 27 of the first word of f1 is there with guard bits alone.
    let fault = "cosim scenes/cone.toml --size 48x36 --inject-fault 0:0:27";
    run(fault).ended(2);
    run(&format!("{fault} --guards 2:3")).ended(1);
    let own = "--widths depth=19,root=17,plane=29,normal=14,g1=3,g2=4,dropped=1";
    // The root has 16 rows in the place of 24.
    let clocks = |report: &Value| report["cycles"].as_u64().unwrap();
    assert!(clocks(&cosim(own)) < clocks(&cosim("")));
    for words in [own, "--guards 2:3"] {
        let report = cosim(words);
        assert_eq!(report["mismatches"], 0);
        let again = report["reproduce"].as_str().unwrap();
        assert!(again.contains(words), "{again}");
    }
}

#[test]
fn an_injected_fault_fails_with_exit_code_1() {
    let place = Place::new();
    let fault = "cosim scenes/cone.toml --size 48x36 --inject-fault 0:2:20 --vcd fault.vcd";
    let parts = "cycle pixel hardware golden fault.vcd reproduce";
    let parts: Vec<&str> = parts.split(' ').collect();
    place.run(fault).ended(1).says(&parts);
    assert!(place.has("fault.vcd"));
}

#[test]
fn the_built_in_engine_has_its_old_name_too() {
    for name in ["built-in", "rust-hdl"] {
        let report = json(&format!("cosim pe1 --clocks 100 --engine {name}"));
        assert_eq!(report["engine"], "built-in");
        let reproduce = report["reproduce"].as_str().unwrap();
        assert!(reproduce.contains("--engine built-in"), "{reproduce}");
    }
}

#[test]
fn cosim_of_a_unit_in_icarus() {
    let report = json("cosim cut_plane --engine icarus --clocks 2000");
    assert_eq!(report["engine"], "icarus");
    assert_eq!(report["mismatches"], 0);
}

#[test]
fn a_scene_in_icarus_has_waveforms_of_its_outputs() {
    let place = Place::new();
    let report = place.json("cosim scenes/cone.toml --size 32x24 --engine icarus --vcd cone.vcd");
    assert_eq!(report["engine"], "icarus");
    assert_eq!(report["pixels"], 32 * 24);
    assert_eq!(report["mismatches"], 0);
    let text = place.text("cone.vcd");
    assert!(text.contains("$scope module beam") && !text.contains("processor_0"));
}

#[test]
fn the_engines_are_timed_side_by_side() {
    let speeds = json("speed pe1 --seconds 1");
    let rows = speeds.as_array().expect("a list");
    assert_eq!(rows.len(), 15);
    for row in rows {
        let keys = "engine lanes work clocks_per_second ratio first_clock_seconds frame_seconds";
        assert_keys(row, keys);
    }
    let engines = "built-in built-in levelised icarus verilator".split(' ');
    let engines = engines.zip([1, 8, 1, 1, 1]).cycle();
    for (row, (engine, lanes)) in rows.iter().zip(engines) {
        assert_eq!(row["engine"], engine);
        assert_eq!(row["lanes"], lanes);
    }
    assert_eq!(rows[0]["ratio"], 1.0);
}

#[test]
fn cosim_of_a_unit_in_verilator_writes_waveforms() {
    let place = Place::new();
    let report = place.json("cosim cut_plane --engine verilator --clocks 2000 --vcd unit.vcd");
    assert_eq!(report["engine"], "verilator");
    assert_eq!(report["mismatches"], 0);
    let reproduce = report["reproduce"].as_str().unwrap();
    assert!(reproduce.contains("--engine verilator"), "{reproduce}");
    assert!(place.has("unit.vcd"));
}

#[test]
fn a_missing_verilator_is_one_message() {
    let mut command = imogene("cosim cut_plane --engine verilator");
    let run = Run::of(command.env("PATH", ""));
    let run = run.refused(&["error: 'verilator' was not found", "package 'verilator'"]);
    assert_eq!(run.said.lines().count(), 1, "{}", run.said);
}

#[test]
fn cosim_of_a_scene_in_verilator_agrees_and_finds_a_fault() {
    let good = "cosim scenes/cone.toml --engine verilator --size 64x48";
    let report = json(good);
    assert_eq!(report["engine"], "verilator");
    assert_eq!(report["mismatches"], 0);
    assert_eq!(report["pixels"], 64 * 48);
    let bad = run(&format!("{good} --inject-fault 0:2:20")).ended(1);
    bad.says(&["--engine verilator"]);
}
