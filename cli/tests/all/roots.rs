//! `imogene roots`: the measured table of the square root networks.

use crate::common::{assert_keys, json, repository, run};

/// The page shows what the command prints, so its figures cannot grow old.
#[test]
fn the_page_holds_the_table_that_the_command_prints() {
    let page = std::fs::read_to_string(repository("docs/root-network.md")).unwrap();
    let table = run("roots").ended(0).out;
    assert!(page.contains(&table), "run `imogene roots` and paste");
}

#[test]
fn rows_have_the_keys_that_scripts_rely_on() {
    let rows = json("roots --format 16");
    let rows = rows.as_array().unwrap();
    assert!(rows.len() > 9);
    for row in rows {
        assert_keys(row, "method label exact error steps sphere cost");
        assert!(row["error"]["max_percent"].is_f64() && row["steps"]["monotone"].is_boolean());
        assert!(row["sphere"].is_null() && row["cost"]["latency"].is_u64());
    }
}

#[test]
fn a_depth_word_that_no_machine_has_is_bad_input() {
    run("roots --format 33").refused(&["8 to 32"]);
}
