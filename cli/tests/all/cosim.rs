//! `imogene cosim` and `speed`: seeds, widths, faults, engines, waveforms.

use crate::common::{COSIM_KEYS, assert_keys, imogene, json, scene};
use serde_json::Value;

#[test]
fn cosim_replays_its_seed_and_writes_waveforms() {
    let folder = tempfile::tempdir().unwrap();
    let vcd = folder.path().join("pe2.vcd");
    let arguments = [
        "cosim",
        "pe2",
        "--seed",
        "42",
        "--clocks",
        "3000",
        "--vcd",
        vcd.to_str().unwrap(),
    ];
    let report = json(&arguments);
    assert_keys(&report, &COSIM_KEYS);
    assert_eq!(
        (&report["seed"], &report["mismatches"]),
        (&Value::from(42), &Value::from(0))
    );
    let first = std::fs::read(&vcd).unwrap();
    json(&arguments);
    assert_eq!(
        first,
        std::fs::read(&vcd).unwrap(),
        "the same seed gave another stimulus"
    );
    assert!(vcd.with_extension("gtkw").is_file());
}

#[test]
fn waveforms_of_a_scene_begin_where_it_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let vcd = folder.path().join("cone.vcd");
    let run = |more: &[&str]| {
        let mut run = imogene();
        run.arg("cosim").arg(scene("cone.toml"));
        run.args(["--size", "48x36", "--vcd"]).arg(&vcd).args(more);
        let ended = run.output().unwrap();
        let said = String::from_utf8_lossy(&ended.stderr).into_owned();
        (ended.status.code(), said)
    };
    assert_eq!(run(&["--vcd-from", "5,1", "--vcd-clocks", "40"]).0, Some(0));
    let text = std::fs::read_to_string(&vcd).unwrap();
    assert!(
        text.contains("#530\n") && !text.contains("#520\n"),
        "pixel 48 + 5"
    );
    let line = ["--vcd-from", "line:3", "--vcd-clocks", "40"];
    assert_eq!(run(&line).0, Some(0));
    let text = std::fs::read_to_string(&vcd).unwrap();
    assert!(text.contains("#1440\n") && !text.contains("#1430\n"));
    std::fs::remove_file(&vcd).unwrap();

    assert_eq!(run(&["--vcd-at-mismatch"]).0, Some(0));
    assert!(!vcd.exists(), "nothing differs");
    assert_eq!(
        run(&["--vcd-at-mismatch", "--inject-fault", "0:2:18"]).0,
        Some(1)
    );
    assert!(vcd.is_file());

    for (given, wanted) in [
        ("48,0", "accepted: 0,0 to 47,35"),
        ("line:36", "accepted: 0,0 to 47,35"),
        ("frame:2", "accepted: frame:1"),
        ("7", "COLUMN,LINE"),
    ] {
        let (code, said) = run(&["--vcd-from", given]);
        assert!(code == Some(2) && said.contains(wanted), "{given}: {said}");
    }
}

#[test]
fn cosim_of_a_scene_takes_any_widths() {
    let cone = scene("cone.toml");
    let cosim = |more: &[&str]| {
        let scene = ["cosim", cone.to_str().unwrap(), "--size", "48x36"];
        json(&[&scene, more].concat())
    };
    // Bit 27 of the first word of f1 is there with guard bits alone.
    let fault = |more: &[&str]| {
        let mut run = imogene();
        run.arg("cosim").arg(&cone).args(["--size", "48x36"]);
        let run = run.args(["--inject-fault", "0:0:27"]).args(more);
        run.output().unwrap().status.code()
    };
    assert_eq!(
        (fault(&[]), fault(&["--guards", "2:3"])),
        (Some(2), Some(1))
    );
    let own = [
        "--widths",
        "depth=19,root=17,plane=29,normal=14,g1=3,g2=4,dropped=1",
    ];
    // The root has 16 rows in the place of 24.
    let clocks = |report: &Value| report["cycles"].as_u64().unwrap();
    assert!(clocks(&cosim(&own)) < clocks(&cosim(&[])));
    for words in [own, ["--guards", "2:3"]] {
        let report = cosim(&words);
        assert_eq!(report["mismatches"], 0);
        let again = report["reproduce"].as_str().unwrap();
        assert!(again.contains(&words.join(" ")), "{again}");
    }
}

#[test]
fn an_injected_fault_fails_with_exit_code_1() {
    let folder = tempfile::tempdir().unwrap();
    let vcd = folder.path().join("fault.vcd");
    let output = imogene()
        .arg("cosim")
        .arg(scene("cone.toml"))
        .args(["--size", "48x36", "--inject-fault", "0:2:20", "--vcd"])
        .arg(&vcd)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8(output.stderr).unwrap();
    for part in [
        "cycle",
        "pixel",
        "hardware",
        "golden",
        "fault.vcd",
        "reproduce",
    ] {
        assert!(message.contains(part), "no '{part}' in: {message}");
    }
    assert!(vcd.is_file());
}

#[test]
fn the_built_in_engine_has_its_old_name_too() {
    for name in ["built-in", "rust-hdl"] {
        let report = json(&["cosim", "pe1", "--clocks", "100", "--engine", name]);
        assert_eq!(report["engine"], "built-in");
        let reproduce = report["reproduce"].as_str().unwrap();
        assert!(reproduce.contains("--engine built-in"), "{reproduce}");
    }
}

#[test]
fn cosim_of_a_unit_in_icarus() {
    let report = json(&[
        "cosim",
        "cut_plane",
        "--engine",
        "icarus",
        "--clocks",
        "2000",
    ]);
    assert_eq!(
        (&report["engine"], &report["mismatches"]),
        (&Value::from("icarus"), &Value::from(0))
    );
}

#[test]
fn a_scene_in_icarus_has_waveforms_of_its_outputs() {
    let folder = tempfile::tempdir().unwrap();
    let vcd = folder.path().join("cone.vcd");
    let cone = scene("cone.toml");
    let report = json(&[
        "cosim",
        cone.to_str().unwrap(),
        "--size",
        "32x24",
        "--engine",
        "icarus",
        "--vcd",
        vcd.to_str().unwrap(),
    ]);
    assert_eq!(
        (&report["engine"], &report["pixels"]),
        (&Value::from("icarus"), &Value::from(32 * 24))
    );
    assert_eq!(report["mismatches"], 0);
    let text = std::fs::read_to_string(&vcd).unwrap();
    assert!(text.contains("$scope module beam") && !text.contains("processor_0"));
}

#[test]
fn the_engines_are_timed_side_by_side() {
    let speeds = json(&["speed", "pe1", "--seconds", "1"]);
    let rows = speeds.as_array().expect("a list");
    assert_eq!(rows.len(), 15);
    for row in rows {
        assert_keys(
            row,
            &[
                "engine",
                "lanes",
                "work",
                "clocks_per_second",
                "ratio",
                "first_clock_seconds",
                "frame_seconds",
            ],
        );
    }
    let engines = [
        ("built-in", 1),
        ("built-in", 4),
        ("levelised", 1),
        ("icarus", 1),
        ("verilator", 1),
    ];
    for (row, (engine, lanes)) in rows.iter().zip(engines.into_iter().cycle()) {
        assert_eq!(
            (&row["engine"], &row["lanes"]),
            (&engine.into(), &lanes.into())
        );
    }
    assert_eq!(rows[0]["ratio"], 1.0);
}

#[test]
fn cosim_of_a_unit_in_verilator_writes_waveforms() {
    let folder = tempfile::tempdir().unwrap();
    let vcd = folder.path().join("cut_plane.vcd");
    let report = json(&[
        "cosim",
        "cut_plane",
        "--engine",
        "verilator",
        "--clocks",
        "2000",
        "--vcd",
        vcd.to_str().unwrap(),
    ]);
    assert_eq!(
        (&report["engine"], &report["mismatches"]),
        (&Value::from("verilator"), &Value::from(0))
    );
    let reproduce = report["reproduce"].as_str().unwrap();
    assert!(reproduce.contains("--engine verilator"), "{reproduce}");
    assert!(vcd.is_file());
}

#[test]
fn a_missing_verilator_is_one_message() {
    let output = imogene()
        .args(["cosim", "cut_plane", "--engine", "verilator"])
        .env("PATH", "")
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    for part in ["error: 'verilator' was not found", "package 'verilator'"] {
        assert!(message.contains(part), "no '{part}' in: {message}");
    }
}

#[test]
fn cosim_of_a_scene_in_verilator_agrees_and_finds_a_fault() {
    let cone = scene("cone.toml");
    let arguments = ["--engine", "verilator", "--size", "64x48"];
    let mut good = vec!["cosim", cone.to_str().unwrap()];
    good.extend(arguments);
    let report = json(&good);
    assert_eq!(report["engine"], Value::from("verilator"));
    assert_eq!(report["mismatches"], Value::from(0));
    assert_eq!(report["pixels"], Value::from(64 * 48));

    let output = imogene()
        .args(&good)
        .args(["--inject-fault", "0:2:20"])
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("--engine verilator"), "{message}");
}
