//! The page of the processors is what the command writes.

use imogene_package::processors::{COMMAND, markdown, processors};

#[test]
fn the_page_is_not_stale() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/processor-table.md");
    let page = std::fs::read_to_string(path).expect("docs/processor-table.md");
    let made = markdown(&processors().expect("legal requests"));
    assert_eq!(page, made, "run `{COMMAND}`");
}
