//! The page of the processors is what the command writes, and its counts those of the source.

use imogene_package::processors::{COMMAND, markdown, processors};

#[test]
fn the_page_is_not_stale() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/processor-table.md");
    let page = std::fs::read_to_string(path).expect("docs/processor-table.md");
    let made = markdown(&processors().expect("legal requests"));
    assert_eq!(page, made, "run `{COMMAND}`");
}

/// Where the counts are said to be the same, the first numbers of the source's text are those of the hierarchy.
#[test]
fn same_counts_are_the_same() {
    let mut compared = 0;
    let all = processors().unwrap().into_iter();
    for p in all.filter(|p| p.difference == "the same") {
        compared += 1;
        let counted = |word: &str| {
            let parts = p.source.split([',', ';']);
            let mut found = parts.filter_map(|part| part.trim().split_once(' '));
            let found = found.find(|(_, name)| name.starts_with(word));
            found.map_or(0, |(number, _)| number.parse().unwrap())
        };
        let c = p.census;
        let wanted = ["PE1", "PE2", "root", "multiplier"].map(counted);
        let own = [c.pe1, c.pe2, c.roots, c.multipliers];
        assert_eq!(own, wanted, "{} {}", p.unit, p.parameters);
    }
    assert!(compared > 0, "no counts are said to be the same");
}
