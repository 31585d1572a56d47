//! Every named extreme comes out as stated, and the page of the documentation holds the same statements.

use super::root;
use imogene_verif::extremes;
use std::collections::BTreeSet;

#[test]
fn every_extreme_comes_out_as_stated() {
    let failed: Vec<String> = extremes::all()
        .map(|extreme| extreme.run())
        .filter(|finding| !finding.held)
        .map(|finding| format!("{}: {}", finding.name, finding.detail))
        .collect();
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn names_are_unique_and_every_scene_file_has_a_case() {
    let names: BTreeSet<&str> = extremes::all().map(|e| e.name).collect();
    assert_eq!(names.len(), extremes::all().count());
    let folder = root().join("scenes/extremes");
    for entry in std::fs::read_dir(folder).expect("the folder of extremes") {
        let path = entry.expect("readable").path();
        let name = path.file_stem().expect("a file").to_string_lossy();
        assert!(names.contains(&*name), "{name} has no case");
    }
}

#[test]
fn the_documentation_states_the_same() {
    let page = root().join("docs/extremes.md");
    let page = std::fs::read_to_string(page).expect("docs/extremes.md");
    let rows = page.lines().filter(|line| line.starts_with("| `")).count();
    assert_eq!(rows, extremes::all().count());
    for extreme in extremes::all() {
        let (name, item, outcome) = (extreme.name, extreme.item, extreme.outcome);
        let row = format!("| `{name}` | {item} | {outcome} |");
        assert!(page.contains(&row), "docs/extremes.md lacks: {row}");
    }
}
