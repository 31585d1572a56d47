//! `imogene mutate`: the score of a unit, and its page.

use crate::common::{imogene, json};
use serde_json::Value;

#[test]
fn mutate_scores_a_unit_and_writes_the_table() {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("mutation.md");
    let reports = json(&[
        "mutate",
        "two_volume_merge,cut_plane",
        "--format",
        "16,24",
        "--out",
        page.to_str().unwrap(),
    ]);
    assert_eq!(reports.as_array().unwrap().len(), 4);
    let report = &reports[0];
    assert_eq!(report["unit"], Value::from("two_volume_merge"));
    assert_eq!(report["mutants"], report["candidates"]);
    assert_eq!(report["score"], Value::from(100.0));
    let text = std::fs::read_to_string(page).unwrap();
    assert!(text.contains("| two_volume_merge |"), "{text}");
}

#[test]
fn mutants_of_a_netlist_are_as_many_as_asked_for() {
    let reports = json(&["mutate", "two_volume_merge", "--netlist", "50"]);
    let report = &reports[0];
    assert_eq!(report["mutants"], Value::from(50));
    assert_eq!(report["score"], Value::from(100.0));
}

#[test]
fn mutants_of_a_circuit_need_no_tool() {
    let run = imogene()
        .args(["mutate", "cut_plane"])
        .env("PATH", "")
        .output();
    assert!(run.unwrap().status.success());
}

#[test]
fn a_missing_yosys_is_one_message() {
    let output = imogene()
        .args(["mutate", "cut_plane", "--netlist", "100"])
        .env("PATH", "")
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    for part in ["error: 'yosys' was not found", "package 'yosys'"] {
        assert!(message.contains(part), "no '{part}' in: {message}");
    }
}
