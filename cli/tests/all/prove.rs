//! `imogene prove`: results, bad input, missing tools.

use crate::common::imogene;
use serde_json::Value;

#[test]
fn a_proof_is_reported_with_the_keys_that_scripts_rely_on() {
    let output = imogene()
        .args(["prove", "root-integers", "--json"])
        .output()
        .unwrap();
    assert!(output.status.success());
    let reports: Vec<Value> = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(reports.len(), 1);
    for key in [
        "name",
        "statement",
        "method",
        "widths",
        "mutant",
        "result",
        "ok",
        "detail",
        "tools",
        "seconds",
        "folder",
    ] {
        assert!(reports[0].get(key).is_some(), "no key '{key}'");
    }
    assert_eq!(reports[0]["result"], "proved");
}

#[test]
fn a_mutant_is_refuted_and_says_where() {
    let output = imogene()
        .args(["prove", "root-integers", "--mutants", "--json"])
        .output()
        .unwrap();
    assert!(output.status.success());
    let reports: Vec<Value> = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(reports[0]["result"], "refuted");
    assert!(
        reports[0]["detail"]
            .as_str()
            .unwrap()
            .contains("statement 3")
    );
}

#[test]
fn an_unknown_proof_is_bad_input() {
    let output = imogene().args(["prove", "pe9"]).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2));
    assert!(
        message.contains("`pe9`") && message.contains("pe1-26"),
        "{message}"
    );
}

#[test]
fn missing_tools_are_named_with_the_command_that_installs_them() {
    let empty = tempfile::tempdir().unwrap();
    let output = imogene()
        .args(["prove", "pe1"])
        .env("IMOGENE_TOOLS", empty.path())
        .output()
        .unwrap();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2));
    for part in ["scripts/setup --formal", "z3", "yosys-smtbmc"] {
        assert!(message.contains(part), "no `{part}` in {message}");
    }
}
