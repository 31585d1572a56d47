//! `imogene prove`: results, bad input, missing tools.

use crate::common::{Place, Run, assert_keys, imogene, json, run};

#[test]
fn a_proof_is_reported_with_the_keys_that_scripts_rely_on() {
    let reports = json("prove root-integers");
    assert_eq!(reports.as_array().map(Vec::len), Some(1));
    let keys = "name statement method widths mutant result ok detail tools seconds folder";
    assert_keys(&reports[0], keys);
    assert_eq!(reports[0]["result"], "proved");
}

#[test]
fn a_mutant_is_refuted_and_says_where() {
    let reports = json("prove root-integers --mutants");
    assert_eq!(reports[0]["result"], "refuted");
    let detail = reports[0]["detail"].as_str().unwrap();
    assert!(detail.contains("statement 3"));
}

#[test]
fn an_unknown_proof_is_bad_input() {
    run("prove pe9").refused(&["`pe9`", "pe1-26"]);
}

#[test]
fn missing_tools_are_named_with_the_command_that_installs_them() {
    let empty = Place::new();
    let mut command = imogene("prove pe1");
    let run = Run::of(command.env("IMOGENE_TOOLS", empty.folder()));
    run.refused(&["scripts/setup --formal", "z3", "yosys-smtbmc"]);
}
