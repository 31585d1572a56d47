//! Outputs destroy nothing: devices, pipes, links, modes, inputs, sets of files, standard output, interruptions,
//! limits.
//!
//! Every path that is written to lies in a folder of the test's own.

mod files;
mod limits;
mod standard_output;

use crate::common::{imogene, scene};
use std::fs::{self};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

const SIZE: [&str; 2] = ["--size", "48x36"];

/// A folder with a scene of its own in it.
struct Place {
    folder: TempDir,
}

impl Place {
    fn new() -> Place {
        let folder = tempfile::tempdir().unwrap();
        fs::copy(scene("cut-sphere.toml"), folder.path().join("c.toml")).unwrap();
        Place { folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn run(&self, arguments: &[&str]) -> Output {
        let mut command = imogene();
        command.current_dir(self.folder.path()).args(arguments);
        command.output().unwrap()
    }

    fn render(&self, arguments: &[&str]) -> Output {
        let mut all = vec!["render", "c.toml"];
        all.extend(SIZE);
        all.extend(arguments);
        self.run(&all)
    }

    /// The picture of the scene, by another file of its own.
    fn picture(&self) -> Vec<u8> {
        let other = Place::new();
        accepted(&other.render(&["-o", "x.png"]));
        fs::read(other.path("x.png")).unwrap()
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder.path()).unwrap();
        let mut names: Vec<String> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }
}

fn accepted(output: &Output) {
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{message}");
}

/// The message of a refusal, which is never long.
fn refused(output: &Output) -> String {
    let message = String::from_utf8(output.stderr.clone()).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.starts_with("error: "), "{message}");
    assert!(message.len() < 2_048, "{} bytes", message.len());
    message
}

fn assert_says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "no '{part}' in: {message}");
    }
}

fn make_pipe(path: &Path) {
    let made = Command::new("mkfifo").arg(path).status().unwrap();
    assert!(made.success());
}
