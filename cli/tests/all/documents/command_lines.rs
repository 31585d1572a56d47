//! Command lines of the pages and of the help: all parse, quick ones run.

use super::{documents, root};
use crate::common::{Run, columns, imogene};
use clap::error::ErrorKind;
use imogene::help::{GROUPS, Group, command};
use regex::Regex;
use std::collections::BTreeSet;
use std::path::Path;

/// A command line of a document.
struct Line {
    page: String,
    text: String,
    /// In a code block, where it can be typed as it stands; within a sentence it may be the beginning of one.
    is_whole: bool,
}

/// What can be typed in a shell with the README's alias: without the remark behind it.
fn without_remark(text: &str) -> String {
    let typed = text.split(" #").next().unwrap_or_default();
    typed.trim().to_owned()
}

fn lines() -> Vec<Line> {
    let inline = Regex::new("`(imogene [^`]*)`").unwrap();
    let mut all = vec![];
    for (page, text) in documents() {
        let mut is_fenced = false;
        let mut add = |text: &str, is_whole| {
            all.push(Line {
                page: page.clone(),
                text: without_remark(text),
                is_whole,
            });
        };
        for line in text.lines() {
            if line.starts_with("```") {
                is_fenced = !is_fenced;
            }
            let is_block = is_fenced || line.starts_with("    ");
            if is_block && line.trim().starts_with("imogene ") {
                add(line, true);
            } else {
                for found in inline.captures_iter(line) {
                    add(&found[1], false);
                }
            }
        }
    }
    for (name, examples) in GROUPS.iter().flat_map(Group::commands) {
        all.extend(examples.iter().map(|text| Line {
            page: format!("imogene {name} --help"),
            text: without_remark(text),
            is_whole: true,
        }));
    }
    assert!(all.len() > 150, "{} command lines", all.len());
    all
}

/// What stands for what the reader chooses.
const PLACEHOLDERS: [(&str, &str); 13] = [
    ("COMMAND", "render"),
    ("SCENE.toml", "placeholder.toml"),
    ("SCENE...", "scenes/cone.toml"),
    ("SCENE..", "scenes/cone.toml"),
    ("SCENE", "scenes/cone.toml"),
    ("UNIT", "pe1"),
    ("DIR", "folder"),
    ("FOLDER", "server"),
    ("FILE.toml", "machines/beam-160x120.toml"),
    ("T", "ecp5-45k"),
    ("W", "24"),
    ("G1:G2", "1:2"),
    ("..", "scenes/cone.toml"),
];

fn words(line: &str) -> Vec<String> {
    let word = |word: &str| {
        let found = PLACEHOLDERS.iter().find(|(name, _)| *name == word);
        found.map_or(word, |(_, value)| value).to_owned()
    };
    line.split_whitespace().map(word).collect()
}

/// Whether a line fails for what is not written alone: an argument, or the value of its last option.
fn is_begun(kind: ErrorKind, words: &[String]) -> bool {
    let ends_in_option = words.last().is_some_and(|word| word.starts_with("--"));
    kind == ErrorKind::MissingRequiredArgument || kind == ErrorKind::InvalidValue && ends_in_option
}

#[test]
fn every_command_line_parses_and_uses_the_names_of_today() {
    let mut problems = vec![];
    for line in lines() {
        let words = words(&line.text);
        let matches = match command().try_get_matches_from(&words) {
            Ok(matches) => matches,
            Err(error) if error.kind() == ErrorKind::DisplayHelp => continue,
            // A sentence may name a command or an option without all that it needs.
            Err(error) if !line.is_whole && is_begun(error.kind(), &words) => continue,
            Err(error) => {
                problems.push(format!("{}: {}\n{error}", line.page, line.text));
                continue;
            }
        };
        if matches.subcommand_name() != words.get(1).map(String::as_str) {
            problems.push(format!("{}: {}: an old name", line.page, line.text));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// Beginnings of command lines that are not run here, with the reason. What begins otherwise is run.
const NOT_RUN: &str = "
    imogene board                                           | Verilator, Yosys and nextpnr; cli/tests/all/board.rs runs it
    imogene demo                                            | seconds to minutes; cli/tests/all/commands.rs runs it
    imogene fit                                             | synthesis and Verilator; cli/tests/all/fit.rs runs it
    imogene synth                                           | Yosys and nextpnr
    imogene peers                                           | Yosys and nextpnr
    imogene prove                                           | Yosys and z3; cli/tests/all/prove.rs runs it
    imogene mutate                                          | minutes; cli/tests/all/mutate.rs runs it
    imogene cosim cut_plane --engine icarus                 | Icarus Verilog; cli/tests/all/commands.rs runs it
    imogene cosim quadric_pe --engine verilator             | Verilator and Yosys; cli/tests/all/netlist.rs runs it
    imogene cosim scenes/teapot.toml --engine verilator     | Verilator, a minute of compilation
    imogene raytrace scenes/*.toml                          | all scenes, minutes; cli/tests/all/oracles.rs traces some
    imogene cosim extremes/NAME                             | NAME stands for any extreme
    imogene cosim extremes                                  | minutes; verif/tests/all/extremes.rs runs all of them
    imogene machine                                         | Verilator, or minutes; cli/tests/all/machine.rs runs it
    imogene speed                                           | all engines side by side; cli/tests/all/commands.rs runs it
    imogene trade SCENE --out DIR --engine hq               | HyperQueue; cli/tests/all/trade_parts.rs runs it
    imogene trade SCENE --out DIR --points quick --target   | Yosys and nextpnr
    imogene trade SCENE --out DIR --points roots            | Yosys, where it is installed
    imogene trade scenes/teapot.toml --size 320x240 --out   | Yosys and nextpnr
    imogene trade scenes/teapot.toml --size 320x240 --clock | Yosys and nextpnr
    imogene trade SCENE --out DIR --shard                   | cli/tests/all/trade.rs runs it
    imogene sweep                                           | a minute each; cli/tests/all/sweep.rs runs them
    imogene primitives                                      | cli/tests/all/compare.rs runs it
    imogene evaluate                                        | cli/tests/all/evaluate.rs runs it
    imogene bounds scenes/*.toml                            | minutes; cli/tests/all/commands.rs runs it on two scenes
";

/// Options that make a quick run of a long one, by the beginning of the command line; they stand behind its own,
/// which they replace.
const SMALLER: &str = "
    imogene bounds --cases | --cases 100
    imogene bounds scenes  | --sizes 40x30 --formats 24
    imogene shading scenes |
    imogene shading        | --cases 4096
    imogene package        | --clocks 0
    imogene cosim scenes   | --size 40x30
    imogene cosim          | --clocks 500
    imogene trade          | --size 32x24 --points quick
    imogene raytrace       | --size 40x30
    imogene detail         | --size 80x60 --zone 16
    imogene render         | --size 40x30
    imogene check          | --size 40x30
    imogene cracks         | --size 80x60
    imogene repair         | --size 40x30
";

/// The words of a command line that is run, or nothing.
fn to_run(line: &str) -> Option<Vec<String>> {
    if columns(NOT_RUN).any(|[begin, _]| line.starts_with(begin)) {
        return None;
    }
    let mut words = words(line);
    let found = columns(SMALLER).find(|[begin, _]| line.starts_with(begin));
    let options = found.map_or("", |[_, options]| options).split_whitespace();
    for pair in options.map(str::to_owned).collect::<Vec<_>>().chunks(2) {
        match words.iter().position(|word| *word == pair[0]) {
            Some(place) => words[place + 1].clone_from(&pair[1]),
            None => words.extend_from_slice(pair),
        }
    }
    Some(words)
}

/// A star in the last part of a path, as a shell spells it out.
fn expanded(word: &str) -> Vec<String> {
    let Some((folder, "*.toml")) = word.rsplit_once('/') else {
        return vec![word.to_owned()];
    };
    let entries = std::fs::read_dir(root().join(folder)).into_iter().flatten();
    let paths = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut files: Vec<String> = paths.filter(|name| name.ends_with(".toml")).collect();
    files.sort();
    let whole = |name| format!("{folder}/{name}");
    files.into_iter().map(whole).collect()
}

/// In the order of the pages, so that one line can use what another wrote.
#[test]
fn quick_command_lines_run() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["scenes", "parts", "machines"] {
        copy(&root().join(name), &folder.path().join(name));
    }
    let mut seen = BTreeSet::new();
    let mut problems = vec![];
    for line in lines().iter().filter(|line| line.is_whole) {
        if !seen.insert(line.text.clone()) {
            continue;
        }
        let Some(words) = to_run(&line.text) else {
            continue;
        };
        let words: Vec<String> = words.iter().skip(1).flat_map(|w| expanded(w)).collect();
        let typed = words.join(" ");
        let run = Run::of(imogene(&typed).current_dir(folder.path()));
        if run.code != Some(0) {
            problems.push(format!("{}: imogene {typed}\n{}", line.page, run.said));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert!(seen.len() > 80, "{} lines", seen.len());
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).unwrap();
        }
    }
}

#[test]
fn no_entry_of_the_tables_is_idle() {
    let lines = lines();
    for [begin, _] in columns(NOT_RUN).chain(columns(SMALLER)) {
        let mut whole = lines.iter().filter(|line| line.is_whole);
        assert!(whole.any(|line| line.text.starts_with(begin)), "{begin}");
    }
}
