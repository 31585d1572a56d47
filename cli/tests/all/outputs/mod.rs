//! Outputs destroy nothing: devices, pipes, links, modes, inputs, sets of files, standard output, interruptions,
//! limits.
//!
//! Every path that is written to lies in a folder of the test's own.

mod files;
mod limits;
mod standard_output;

use crate::common::{Place, Run, scene};
use std::fs;
use std::path::Path;
use std::process::Command;

/// A folder with a scene of its own in it.
fn place() -> Place {
    let place = Place::new();
    fs::copy(scene("cut-sphere.toml"), place.path("c.toml")).unwrap();
    place
}

/// A run of the scene.
fn render(place: &Place, options: &str) -> Run {
    place.run(&format!("render c.toml --size 48x36 {options}"))
}

/// The picture of the scene, by another file of its own.
fn picture() -> Vec<u8> {
    let other = place();
    render(&other, "-o x.png").ended(0);
    other.bytes("x.png")
}

/// A refusal, whose message is never long and has these parts.
fn refused(run: Run, parts: &[&str]) -> Run {
    let run = run.refused(parts);
    assert!(run.said.starts_with("error: "), "{}", run.said);
    assert!(run.said.len() < 2_048, "{} bytes", run.said.len());
    run
}

/// The program as `$0` of a script, in a folder.
fn shell(place: &Place, script: &str) -> Run {
    let mut shell = assert_cmd::Command::new("sh");
    let program = assert_cmd::cargo::cargo_bin("imogene");
    shell.arg("-c").arg(script).arg(program);
    Run::of(shell.current_dir(place.folder()))
}

fn make_pipe(path: &Path) {
    let made = Command::new("mkfifo").arg(path).status().unwrap();
    assert!(made.success());
}
