//! Links, lines and lists of the pages.

use super::{documents, read, root};
use crate::common::json;
use imogene::help::{GROUPS, command};
use regex::Regex;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The anchor that a heading gets: small letters, hyphens for blanks, no marks.
fn anchor(heading: &str) -> String {
    let kept = heading.trim().chars().filter_map(|c| match c {
        ' ' => Some('-'),
        c if c.is_alphanumeric() || "-_".contains(c) => c.to_lowercase().next(),
        _ => None,
    });
    kept.collect()
}

fn anchors(text: &str) -> BTreeSet<String> {
    let mut is_fenced = false;
    let headings = text.lines().filter(move |line| {
        is_fenced ^= line.starts_with("```");
        !is_fenced && line.starts_with('#')
    });
    let anchors = headings.map(|line| anchor(line.trim_start_matches('#')));
    anchors.collect()
}

#[test]
fn every_link_leads_somewhere() {
    let link = Regex::new(r"\]\(([^)\s]+)\)").unwrap();
    let mut problems = vec![];
    let mut count = 0;
    for (page, text) in documents() {
        let folder = root().join(Path::new(&page).parent().unwrap());
        for found in link.captures_iter(&text) {
            let target = &found[1];
            if target.contains("://") {
                continue;
            }
            count += 1;
            let (file, place) = target.split_once('#').unwrap_or((target, ""));
            let path = match file {
                "" => root().join(&page),
                _ => folder.join(file),
            };
            if !path.exists() {
                problems.push(format!("{page}: {target}: there is no such file"));
            } else if !place.is_empty() {
                let there = std::fs::read_to_string(&path).unwrap();
                if !anchors(&there).contains(place) {
                    problems.push(format!("{page}: {target}: there is no such heading"));
                }
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert!(count > 100, "{count} links");
}

/// Tables, blocks and pictures are as wide as they are.
#[test]
fn prose_ends_at_column_120() {
    let mut problems = vec![];
    let others = "CHANGELOG.md CONTRIBUTING.md import/tests/data/README.md ip/README.md";
    let others = others.split(' ');
    let others = others.map(|name| (name.to_owned(), read(name)));
    for (page, text) in documents().into_iter().chain(others) {
        let mut is_fenced = false;
        for (index, line) in text.lines().enumerate() {
            is_fenced ^= line.starts_with("```");
            let mut wide = ["|", "    ", "!["].iter();
            let is_wide = is_fenced || wide.any(|begin| line.starts_with(begin));
            if !is_wide && line.chars().count() > 120 {
                problems.push(format!("{page}:{}: {line}", index + 1));
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn comments_end_at_column_120() {
    let mut folders = vec![root()];
    let (mut problems, mut count) = (vec![], 0);
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy();
            if path.is_dir() && name != "target" && !name.starts_with('.') {
                folders.push(path);
            } else if name.ends_with(".rs") {
                count += 1;
                let text = std::fs::read_to_string(&path).unwrap();
                let lines = (1..).zip(text.lines());
                let is_wide =
                    |line: &str| line.trim_start().starts_with("//") && line.chars().count() > 120;
                let wide = lines.filter(|(_, line)| is_wide(line));
                problems.extend(wide.map(|(k, line)| format!("{}:{k}: {line}", path.display())));
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert!(count > 500, "{count} files");
}

/// A path in a sentence that begins with a folder of the repository.
#[test]
fn every_path_leads_to_a_file() {
    let path = Regex::new(r"`((?:cli|docs|files|import|ip|machines|models|parts|rtl|scenes|scripts|synth|verif)/[\w./-]+)`").unwrap();
    let mut count = 0;
    for (page, text) in documents() {
        for found in path.captures_iter(&text) {
            count += 1;
            let path = &found[1];
            let is_there = root().join(path).exists();
            assert!(is_there, "{page}: {path}: there is no such file");
        }
    }
    assert!(count > 100, "{count} paths");
}

/// Every page can be reached from the index, and the index from the README.
#[test]
fn the_index_names_every_page() {
    let pages: BTreeMap<String, String> = documents().into_iter().collect();
    assert!(pages["README.md"].contains("(docs/README.md)"));
    let names = pages.keys().filter_map(|page| page.strip_prefix("docs/"));
    for name in names.filter(|name| *name != "README.md") {
        let is_named = pages["docs/README.md"].contains(&format!("({name})"));
        assert!(is_named, "docs/{name} is not in docs/README.md");
    }
}

#[test]
fn the_readme_fits_a_screen_and_begins_with_the_two_commands() {
    let pages: BTreeMap<String, String> = documents().into_iter().collect();
    let readme = &pages["README.md"];
    let count = readme.lines().count();
    assert!(count <= 100, "{count} lines");
    for line in readme.lines() {
        assert!(line.chars().count() <= 100, "{line}");
    }
    for command in ["cargo run --release -- demo", "scripts/test"] {
        assert!(readme.contains(command), "{command}");
    }
}

/// docs/commands.md lists what the help lists, in its words.
#[test]
fn the_page_of_commands_is_that_of_the_help() {
    let page = read("docs/commands.md");
    let command = command();
    for group in GROUPS {
        let title = group.title;
        assert!(page.contains(&format!("## {title}\n")), "{title}");
        for (name, _) in group.commands() {
            let found = command.find_subcommand(name).expect("a command");
            let about = found.get_about().expect("a line of help");
            let row = format!("| `imogene {name}` | {about} |");
            assert!(page.contains(&row), "docs/commands.md lacks: {row}");
        }
    }
}

/// The units that the table of resources does not have stand on its page.
#[test]
fn the_page_of_resources_names_the_units_it_lacks() {
    let page = read("docs/resources.md");
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    let file = read("docs/resources.json");
    let figures: serde_json::Value = serde_json::from_str(&file).unwrap();
    let rows = figures["rows"].as_array().unwrap();
    let with = rows.iter().map(|row| row["unit"].as_str().unwrap());
    let with: BTreeSet<&str> = with.collect();
    let units = json("units");
    let units = units.as_array().unwrap();
    let readme = read("README.md");
    assert!(readme.contains(&format!("{} units as Verilog", units.len())));
    let names = units.iter().map(|unit| unit["name"].as_str().unwrap());
    let without = names.filter(|name| !with.contains(name));
    let without: Vec<String> = without.map(|name| format!("`{name}`")).collect();
    let begin = "Units without figures here, and without a baseline for `imogene synth --check`";
    let sentence = format!("{begin}: {}.", without.join(", "));
    let is_there = page.contains(&sentence);
    assert!(is_there, "docs/resources.md lacks: {sentence}");
}
