//! `imogene mutate`: the score of a unit, and its page.

use crate::common::{Place, Run, imogene, json};

#[test]
fn mutate_scores_a_unit_and_writes_the_table() {
    let place = Place::new();
    let reports = place.json("mutate visibility_node,cut_plane --format 16,24 --out mutation.md");
    assert_eq!(reports.as_array().unwrap().len(), 4);
    let report = &reports[0];
    assert_eq!(report["unit"], "visibility_node");
    assert_eq!(report["mutants"], report["candidates"]);
    assert_eq!(report["score"], 100.0);
    let text = place.text("mutation.md");
    assert!(text.contains("| visibility_node |"), "{text}");
}

#[test]
fn a_unit_has_the_parameters_that_are_given() {
    let place = Place::new();
    let mutants = |line: &str| place.json(&format!("mutate decider {line}"))[0]["mutants"].as_u64();
    let two = mutants("--objects 2 --out two.md");
    assert!(two < mutants(""), "the default is four objects");
    let text = place.text("two.md");
    for part in [
        "imogene mutate decider --format 16 --objects 2 --stimuli",
        "| decider | `--format 16 --objects 2` |",
    ] {
        assert!(text.contains(part), "{text}");
    }
    let part = "the unit `pe1` has no parameter `objects`";
    place.run("mutate pe1 --objects 2").refused(&[part]);
    let machine = "mutate scenes/cone.toml --machine machines/beam-48x32.toml --objects 2";
    place.run(machine).refused(&["--machine", "--objects"]);
}

#[test]
fn mutants_of_a_netlist_are_as_many_as_asked_for() {
    let reports = json("mutate visibility_node --netlist 50");
    assert_eq!(reports[0]["mutants"], 50);
    assert_eq!(reports[0]["score"], 100.0);
}

#[test]
fn mutants_of_a_circuit_need_no_tool() {
    Run::of(imogene("mutate cut_plane").env("PATH", "")).ended(0);
}

#[test]
fn a_missing_yosys_is_one_message() {
    let run = Run::of(imogene("mutate cut_plane --netlist 100").env("PATH", ""));
    let run = run.refused(&["error: 'yosys' was not found", "package 'yosys'"]);
    assert_eq!(run.said.lines().count(), 1, "{}", run.said);
}
