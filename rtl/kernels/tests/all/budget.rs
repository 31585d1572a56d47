//! The kernels stay an example that is read in one sitting.

use std::fs::{read_dir, read_to_string};

const MOST_LINES: usize = 660;

#[test]
fn the_source_has_at_most_660_lines() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src");
    let files = read_dir(folder).expect("the source of the kernels");
    let texts = files.map(|file| read_to_string(file.expect("a file").path()));
    let lines: usize = texts
        .map(|text| text.expect("a text").lines().count())
        .sum();
    assert!((1..=MOST_LINES).contains(&lines), "{lines} lines");
}
