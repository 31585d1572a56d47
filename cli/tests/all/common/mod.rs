//! Shared by the command line tests: command lines as a person types them.

use assert_cmd::Command;
use imogene_studies::picture::write_png;
use serde_json::Value;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// The head of a small scene with a material.
pub const HEAD: &str = r#"
format = 1
title = "t"
image = { width = 32, height = 24 }
[camera]
kind = "perspective"
eye = [0, 0, 10]
target = [0, 0, 0]
field_of_view = 30
[[materials]]
name = "m"
colour = [1, 1, 1]
"#;
/// A mesh of which a corner is behind the viewer.
pub const SHEET: &str = r#"
[[objects]]
name = "sheet"
material = "m"
kind = "mesh"
vertices = [[0, 0, 0], [1, 0, 0], [0, 0, 20]]
faces = [[0, 1, 2]]
"#;

/// A file or folder of the repository.
pub fn repository(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name)
}

/// A scene of the repository.
pub fn scene(name: &str) -> String {
    repository("scenes").join(name).display().to_string()
}

/// The program with the words of a line, at the root of the repository.
pub fn imogene(line: &str) -> Command {
    let mut command = Command::cargo_bin("imogene").expect("the program was built");
    command.args(line.split_whitespace());
    command.current_dir(repository(""));
    command
}

/// How a run ended and what it said.
pub struct Run {
    /// Its exit code.
    pub code: Option<i32>,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub said: String,
}

impl Run {
    /// Runs a command.
    pub fn of(command: &mut Command) -> Run {
        let output = command.output().expect("the program runs");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
        Run {
            code: output.status.code(),
            out: text(output.stdout),
            said: text(output.stderr),
        }
    }

    /// The same, which ended with this exit code.
    pub fn ended(self, code: i32) -> Run {
        assert_eq!(self.code, Some(code), "{}{}", self.out, self.said);
        self
    }

    /// The same, which was refused with a message that has these parts.
    pub fn refused(self, parts: &[&str]) -> Run {
        let run = self.ended(2);
        assert!(!run.said.contains("panicked"), "{}", run.said);
        run.says(parts)
    }

    /// The same, whose message has these parts.
    pub fn says(self, parts: &[&str]) -> Run {
        for part in parts {
            assert!(self.said.contains(part), "no '{part}' in: {}", self.said);
        }
        self
    }

    /// The document that was printed.
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.out).expect("one JSON document")
    }
}

/// Runs a command line at the root of the repository.
pub fn run(line: &str) -> Run {
    Run::of(&mut imogene(line))
}

/// What a command says as JSON.
pub fn json(line: &str) -> Value {
    run(&format!("{line} --json")).ended(0).json()
}

/// A folder of a test's own, in which command lines are run.
pub struct Place(TempDir);

impl Place {
    /// An empty one.
    pub fn new() -> Place {
        Place(tempfile::tempdir().expect("a folder"))
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        self.0.path()
    }

    /// A file in it.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder().join(name)
    }

    /// True if a file or folder is in it.
    pub fn has(&self, name: &str) -> bool {
        self.path(name).exists()
    }

    /// What a file in it holds.
    pub fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The same as text.
    pub fn text(&self, name: &str) -> String {
        String::from_utf8(self.bytes(name)).expect("text")
    }

    /// Writes a file in it.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).expect("a file");
    }

    /// The names of what is in it.
    pub fn names(&self) -> Vec<String> {
        names_in(self.folder())
    }

    /// Runs a command line in it.
    pub fn run(&self, line: &str) -> Run {
        Run::of(&mut self.command(line))
    }

    /// A command line in it, in which `scenes/cone.toml` and the like are files of the repository.
    pub fn command(&self, line: &str) -> Command {
        let folders = ["scenes/", "machines/", "parts/", "docs/"];
        let word = |word: &str| match repository(word) {
            path if folders.iter().any(|begin| word.starts_with(begin)) && path.exists() => {
                path.display().to_string()
            }
            _ => word.to_owned(),
        };
        let words: Vec<String> = line.split_whitespace().map(word).collect();
        let mut command = imogene(&words.join(" "));
        command.current_dir(self.folder());
        command
    }

    /// What a command that a report names says as JSON, its files in this folder.
    pub fn reproduced(&self, command: &Value, folder: &str) -> Value {
        let command = command.as_str().expect("a command");
        let command = command.replacen("imogene ", "", 1);
        self.json(&command.replace(" DIR", &format!(" {folder}")))
    }

    /// What a command says as JSON, run in it.
    pub fn json(&self, line: &str) -> Value {
        self.run(&format!("{line} --json")).ended(0).json()
    }

    /// Writes a plane for the overlay of a screen: stripes.
    pub fn write_mask(&self, name: &str, width: usize, height: usize) {
        let stripes = (0..3 * width * height).map(|byte| u8::from(byte / 3 % 11 == 4));
        let stripes: Vec<u8> = stripes.collect();
        write_png(&self.path(name), width, height, &stripes).expect("a picture");
    }

    /// Every file that a report names is in it.
    pub fn assert_files(&self, report: &Value) {
        for file in report["files"].as_array().expect("files") {
            let path = self.path(file.as_str().expect("a path"));
            assert!(path.is_file(), "{file}");
        }
    }
}

/// The names of what is in a folder.
pub fn names_in(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let name = |entry: std::io::Result<std::fs::DirEntry>| entry.expect("an entry").file_name();
    let names = entries.map(|entry| name(entry).into_string().expect("a plain name"));
    let mut names: Vec<String> = names.collect();
    names.sort();
    names
}

/// The rows of a table, one a line, as their cells between bars.
pub fn rows(table: &str) -> impl Iterator<Item = Vec<&str>> {
    let lines = table.lines().filter(|line| !line.trim().is_empty());
    lines.map(|line| line.split('|').map(str::trim).collect())
}

/// The rows of a table that has so many columns.
pub fn columns<const N: usize>(table: &str) -> impl Iterator<Item = [&str; N]> {
    let cells = |row: Vec<_>| row.try_into();
    rows(table).map(move |row| cells(row).unwrap_or_else(|row| panic!("{row:?}")))
}

/// Refuses a text that lacks a cell of a table.
pub fn assert_has(text: &str, table: &str) {
    for part in rows(table).flatten() {
        assert!(text.contains(part), "no '{part}' in: {text}");
    }
}

/// Refuses a document that lacks one of these keys.
pub fn assert_keys(value: &Value, keys: &str) {
    for key in keys.split_whitespace() {
        assert!(value.get(key).is_some(), "no key '{key}' in {value}");
    }
}

/// As `scripts/test --full` sets it.
pub fn is_full() -> bool {
    std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1")
}

/// Keys of every co-simulation.
pub const COSIM_KEYS: &str = "engine cycles pixels mismatches seconds cycles_per_second seed files";
