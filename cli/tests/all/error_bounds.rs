//! The tables of `docs/error-bounds.md` are those that the command prints.

use crate::common::{is_full, repository, run, scene};

fn page() -> String {
    std::fs::read_to_string(repository("docs/error-bounds.md")).expect("the page")
}

/// The lines of the tables that a command prints, without heads.
fn rows(arguments: &str) -> Vec<String> {
    let text = run(&format!("bounds {arguments}")).ended(0).out;
    let is_row = |l: &&str| l.starts_with("| ") && l.contains(|c: char| c.is_ascii_digit());
    let rows = text.lines().filter(is_row);
    let rows = rows.filter(|l| !l.contains("depth word") && !l.contains("violations"));
    rows.map(str::to_string).collect()
}

fn assert_documented(rows: &[String]) {
    let page = page();
    for row in rows {
        let is_there = page.lines().any(|l| l == row);
        assert!(is_there, "not in docs/error-bounds.md: {row}");
    }
}

/// All sizes in the full run, the two smaller ones otherwise. The page shows each scene in the base format only.
#[test]
fn scenes_are_documented_as_they_are() {
    let folder = scene("");
    let entries = std::fs::read_dir(folder).expect("the scenes");
    let files = entries.map(|e| e.unwrap().path().to_str().unwrap().to_string());
    let mut files: Vec<String> = files.filter(|path| path.ends_with(".toml")).collect();
    files.sort();
    let count = files.len();
    let more = if is_full() { ",640x480,1024x768" } else { "" };
    let sizes = format!("160x120,320x240{more}");
    let rows = rows(&format!("{} --sizes {sizes}", files.join(" ")));
    let sizes = sizes.split(',').count();
    assert_eq!(rows.len(), 3 * sizes + 3 * sizes * count);
    let (summary, scenes) = rows.split_at(3 * sizes);
    assert_documented(summary);
    let base = |row: &&String| row.split(" | ").nth(2) == Some("24");
    let scenes: Vec<String> = scenes.iter().filter(base).cloned().collect();
    assert_eq!(scenes.len(), sizes * count);
    assert_documented(&scenes);
}

/// A million cases at each format in the full run, as documented; otherwise the documented table must at least be about
/// these formats.
#[test]
fn the_trial_is_documented_as_it_is() {
    let cases = if is_full() { "1000000" } else { "100" };
    let rows = rows(&format!("--cases {cases}"));
    assert!(rows.len() >= 8);
    if is_full() {
        assert_documented(&rows);
    }
    let page = page();
    for row in &rows {
        let name = row.split(" | ").next().unwrap();
        let documented = page.lines().find(|l| l.starts_with(&format!("{name} |")));
        let documented = documented.unwrap_or_else(|| panic!("no row {name}"));
        assert!(documented.starts_with(&format!("{name} | 1000000 |")));
        let violations = documented.split(" | ").nth(4);
        assert_eq!(violations, Some("0"), "violations in {documented}");
    }
}
