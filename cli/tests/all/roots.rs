//! `imogene roots`: the measured table of the square root networks.

use crate::common::{imogene, scene};
use serde_json::Value;

fn output(arguments: &[&str]) -> String {
    let output = imogene().arg("roots").args(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// The page shows what the command prints, so its figures cannot grow old.
#[test]
fn the_page_holds_the_table_that_the_command_prints() {
    let page = scene("../docs/root-network.md");
    let page = std::fs::read_to_string(page).unwrap();
    assert!(page.contains(&output(&[])), "run `imogene roots` and paste");
}

#[test]
fn rows_have_the_keys_that_scripts_rely_on() {
    let rows: Vec<Value> = serde_json::from_str(&output(&["--format", "16", "--json"])).unwrap();
    assert!(rows.len() > 9);
    for row in &rows {
        for key in [
            "method", "label", "exact", "error", "steps", "sphere", "cost",
        ] {
            assert!(row.get(key).is_some(), "no key '{key}' in {row}");
        }
        assert!(row["error"]["max_percent"].is_f64() && row["steps"]["monotone"].is_boolean());
        assert!(row["sphere"].is_null() && row["cost"]["latency"].is_u64());
    }
}

#[test]
fn a_depth_word_that_no_machine_has_is_bad_input() {
    let output = imogene()
        .args(["roots", "--format", "33"])
        .output()
        .unwrap();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2));
    assert!(message.contains("8 to 32"), "{message}");
}
