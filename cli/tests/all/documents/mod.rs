//! The documents: every command line in them parses, quick ones are run, every link leads somewhere, and figures from
//! files agree with the files.

mod command_lines;
mod pages;

use crate::common::repository;
use std::path::PathBuf;

fn root() -> PathBuf {
    repository("")
}

/// README.md and the pages of docs/, by their paths from the root.
fn documents() -> Vec<(String, String)> {
    let entries = std::fs::read_dir(root().join("docs")).expect("docs/ is there");
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let pages = names.filter(|name| name.ends_with(".md"));
    let mut paths: Vec<String> = pages.map(|name| format!("docs/{name}")).collect();
    paths.extend(["README.md", "ARCHITECTURE.md"].map(String::from));
    paths.sort();
    assert!(paths.len() > 20, "{paths:?}");
    let page = |path: String| (path.clone(), read(&path));
    paths.into_iter().map(page).collect()
}

/// A file of the repository.
fn read(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).expect("a readable page")
}
