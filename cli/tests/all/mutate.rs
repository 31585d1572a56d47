//! `imogene mutate`: the score of a unit, and its page.

use crate::common::{Place, Run, imogene, json};

#[test]
fn mutate_scores_a_unit_and_writes_the_table() {
    let place = Place::new();
    let reports = place.json("mutate two_volume_merge,cut_plane --format 16,24 --out mutation.md");
    assert_eq!(reports.as_array().unwrap().len(), 4);
    let report = &reports[0];
    assert_eq!(report["unit"], "two_volume_merge");
    assert_eq!(report["mutants"], report["candidates"]);
    assert_eq!(report["score"], 100.0);
    let text = place.text("mutation.md");
    assert!(text.contains("| two_volume_merge |"), "{text}");
}

#[test]
fn mutants_of_a_netlist_are_as_many_as_asked_for() {
    let reports = json("mutate two_volume_merge --netlist 50");
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
