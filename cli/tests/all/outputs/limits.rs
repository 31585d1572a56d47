//! Limits of what is read and said, and interruptions.

use super::{make_pipe, place, refused, shell};
use crate::common::names_in;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

#[test]
fn endless_files_are_refused() {
    let place = place();
    for (line, said) in [
        ("render /dev/zero -o x.png", "256 MiB"),
        ("import /dev/zero --as step -o x.toml", "1 GiB"),
        ("machine c.toml --machine /dev/zero --out x", "1 MiB"),
    ] {
        refused(place.run(line), &["/dev/zero", said]);
    }
    assert_eq!(place.names(), ["c.toml"]);
}

#[test]
fn a_scene_beyond_the_memory_is_refused_before_it_is_read() {
    let place = place();
    let comments = "# a comment that takes room\n".repeat(1_000_000);
    place.write("large.toml", place.text("c.toml") + &comments);
    let script = "ulimit -v 1000000; \"$0\" render large.toml -o x.png";
    let parts = ["large.toml", "GiB of memory", "free"];
    refused(shell(&place, script), &parts);
    assert_eq!(place.names(), ["c.toml", "large.toml"]);
}

#[test]
fn messages_are_short_whatever_they_quote() {
    let place = place();
    let own = place.text("c.toml");
    let name = "n".repeat(1 << 20);
    let material = |name: &str| format!("[[materials]]\nname = \"{name}\"\ncolour = [1, 1, 2]\n");
    let object = format!("[[objects]]\nname = \"{name}\"\nmaterial = \"{name}\"\n");
    for text in [
        format!("x = {}", "[".repeat(100_000)),
        format!("x = {}", "[ ".repeat(100_000)),
        format!("{}a = 1", "a.".repeat(500_000)),
        material(&name),
        material(&"\\n".repeat(500_000)),
        object + "kind = \"sphere\"\nradius = 1\n",
    ] {
        place.write("hostile.toml", format!("{own}\n{text}"));
        refused(place.run("render hostile.toml -o x.png"), &[]);
    }
    let path = format!("{}x", "long/".repeat(20_000));
    for line in [
        format!("render {path} -o x.png"),
        format!("render c.toml -o {path}"),
        format!("render c.toml --size {path} -o x.png"),
        path,
    ] {
        refused(place.run(&line), &[]);
    }
}

/// Waits until a file whose name begins like a temporary one is there.
fn wait_for_temporary_file(folder: &Path) {
    let begun = Instant::now();
    let is_temporary =
        |entry: fs::DirEntry| entry.file_name().to_string_lossy().starts_with(".imogene-");
    let is_there = || {
        let mut entries = fs::read_dir(folder).unwrap();
        entries.any(|entry| entry.is_ok_and(is_temporary))
    };
    while !is_there() {
        let is_late = begun.elapsed() > Duration::from_secs(60);
        assert!(!is_late, "no temporary file");
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn an_interruption_leaves_nothing_and_says_so() {
    for (signal, code) in [("INT", 130), ("TERM", 143)] {
        let place = place();
        let scratch = tempfile::tempdir().unwrap();
        make_pipe(&place.path("pipe"));
        // Nobody reads the pipe: the set waits there, complete but for its names.
        let line = "render c.toml --size 48x36 -o x.png --depth pipe --ids new/i.npy";
        let child = Command::new(assert_cmd::cargo::cargo_bin("imogene"))
            .args(line.split(' '))
            .current_dir(place.folder())
            .env("TMPDIR", scratch.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        wait_for_temporary_file(place.folder());
        let sent = Command::new("kill")
            .args(["-s", signal, &child.id().to_string()])
            .status();
        assert!(sent.unwrap().success());
        let output = child.wait_with_output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{message}");
        let is_told = message.starts_with("interrupted: ") && message.lines().count() == 1;
        assert!(is_told, "{message}");
        assert_eq!(place.names(), ["c.toml", "pipe"]);
        assert!(names_in(scratch.path()).is_empty());
    }
}
