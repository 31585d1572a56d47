//! `imogene evaluate`: every row is counted, the page of the documentation is what the command makes, and what must
//! hold between the rows holds.

use crate::common::{Place, repository, run};
use serde_json::Value;

fn groups(report: &Value) -> Vec<&Value> {
    report["groups"].as_array().unwrap().iter().collect()
}

fn rows<'a>(report: &'a Value) -> Vec<&'a Value> {
    let rows = |group: &'a Value| group["rows"].as_array().unwrap();
    groups(report).into_iter().flat_map(rows).collect()
}

fn ours(report: &Value, group: &str, name: &str) -> f64 {
    let groups = groups(report);
    let group = groups.iter().find(|g| g["name"] == group).expect(group);
    let rows = group["rows"].as_array().unwrap();
    let row = rows.iter().find(|row| row["name"] == name).expect(name);
    row["ours"].as_f64().unwrap()
}

#[test]
fn the_page_of_the_documentation_is_what_the_command_makes() {
    let place = Place::new();
    let report = place.json("evaluate --out .");
    for name in "evaluation.md images/duplication.svg images/operations.svg".split(' ') {
        let shown = std::fs::read_to_string(repository("docs").join(name)).unwrap();
        let makes = "is not what `imogene evaluate --out DIR` makes";
        assert_eq!(place.text(name), shown, "docs/{name} {makes}");
    }
    let figures: Value = serde_json::from_str(&place.text("evaluation.json")).unwrap();
    assert_eq!(figures["groups"], report["groups"]);
    assert_eq!(report["files"].as_array().unwrap().len(), 5);
    let page = place.text("index.html");
    for row in rows(&report) {
        let name = row["name"].as_str().unwrap();
        assert!(page.contains(&format!("<td>{name}</td>")), "{name}");
    }
    assert!(!page.contains("src=\"") && !page.contains("href=\"http"));
    assert_rows(&report);
    assert_relations(&report);
}

/// Every row has a figure of ours, says why it is what it is, and its difference is that to what it is compared with.
fn assert_rows(report: &Value) {
    let rows = rows(report);
    assert!(rows.len() > 150, "{} rows", rows.len());
    for row in rows {
        for key in ["name", "section", "unit", "why"] {
            assert_ne!(row[key].as_str().expect("a text"), "", "{key}: {row}");
        }
        let number = |key: &str| row[key].as_f64();
        let ours = number("ours").unwrap_or_else(|| panic!("nothing counted: {row}"));
        assert!(ours.is_finite() && ours >= 0.0, "{row}");
        let printed = row["printed"]["value"].as_f64();
        match number("corrected").or(printed) {
            Some(value) => {
                let off = number("difference").unwrap() - (ours - value);
                assert!(off.abs() < 1e-9, "{row}");
            }
            None => assert!(number("difference").is_none(), "{row}"),
        }
        assert_ne!(row["printed"]["text"].as_str().unwrap(), "", "{row}");
    }
    for one in report["omitted"].as_array().unwrap() {
        for key in ["name", "section", "printed", "why"] {
            assert!(!one[key].as_str().unwrap().is_empty(), "{one}");
        }
    }
}

fn assert_relations(report: &Value) {
    let of = |group: &str, name: &str| ours(report, group, name);
    // (20 + 32)^2 / 32^2, and as many in four times the size.
    let near = |name: &str, wanted: f64| {
        let found = of("duplication", &format!("{name}: duplication factor"));
        assert!((found - wanted).abs() < 1e-12, "{name}");
    };
    near("20 in 32", 2.640625);
    near("80 in 128", 2.640625);
    let shares = ["one zone", "two zones", "four zones"];
    let shares = shares.map(|n| of("duplication", &format!("20 in 32: {n}")));
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    // ((80 + 128 - 1) / 128)^2 by counting places and by the plans of the machine.
    near("80 in 128, whole pixels", (207.0f64 / 128.0).powi(2));
    let plans = "80 in 128, plans of our zone machine";
    near(plans, (207.0f64 / 128.0).powi(2));
    // Words of a patch processor on the bus: 24, 7 for each of four planes, and the id.
    assert_eq!(of("pipeline", "loading of a patch"), 24.0 + 7.0 * 4.0 + 1.0);
    let rate = of("pipeline", "patches of 80 x 80, zones of 128");
    let zones = of("pipeline", "patches times zones, zones of 128");
    assert!((zones / rate - 2.640625).abs() < 1e-9);
    // The frame has passes that show, and passes with idle processors: it is slower than the formula, but not by an
    // order.
    let patches = "patches of 100 processors";
    let formula = of("pipeline", patches);
    let frame = of("pipeline", &format!("{patches}, clocks of a whole frame"));
    let is_slower = frame < formula && frame > formula / 10.0;
    assert!(is_slower, "{frame} {formula}");
    assert_eq!(of("storage", "quadric with three planes"), 10.0 + 3.0 * 4.0);
    assert_eq!(of("storage", "facet, words to send"), 7.0 * 3.0);
    let product = of("frame", "product of two 4 x 4 matrices");
    assert_eq!(of("frame", "facet, all"), product + 117.0 + 33.0);
    assert_eq!(of("processors", "patch, four planes: PE1"), 8.0);
    assert_eq!(of("machine", "PE2 with memory, clocks between lines"), 15.0);
}

#[test]
fn tables_are_printed_without_a_folder() {
    let out = run("evaluate").ended(0).out;
    assert!(out.starts_with("# Evaluation"));
    for part in [
        "| what | printed | corrected | ours |",
        "## Printed and not counted",
    ] {
        assert!(out.contains(part), "{part}");
    }
}

#[test]
fn a_folder_that_cannot_be_made_is_bad_input() {
    let place = Place::new();
    place.write("file", "");
    let refused = place.run("evaluate --out file/sub").refused(&["file"]);
    assert_eq!(refused.out, "");
}
