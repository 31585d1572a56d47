//! Limits of what is read and said, and interruptions.

use super::{Place, SIZE, assert_says, make_pipe, refused};
use std::fs::{self};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

#[test]
fn endless_files_are_refused() {
    let place = Place::new();
    for (arguments, said) in [
        (&["render", "/dev/zero", "-o", "x.png"][..], "256 MiB"),
        (
            &["import", "/dev/zero", "--as", "step", "-o", "x.toml"],
            "1 GiB",
        ),
        (
            &["machine", "c.toml", "--machine", "/dev/zero", "--out", "x"],
            "1 MiB",
        ),
    ] {
        assert_says(&refused(&place.run(arguments)), &["/dev/zero", said]);
    }
    assert_eq!(place.names(), ["c.toml"]);
}

#[test]
fn a_scene_beyond_the_memory_is_refused_before_it_is_read() {
    let place = Place::new();
    let mut text = fs::read_to_string(place.path("c.toml")).unwrap();
    text += &"# a comment that takes room\n".repeat(1_000_000);
    fs::write(place.path("large.toml"), text).unwrap();
    let program = assert_cmd::cargo::cargo_bin("imogene");
    let mut shell = Command::new("sh");
    let script = "ulimit -v 1000000; \"$0\" render large.toml -o x.png";
    shell.arg("-c").arg(script).arg(program);
    let output = shell.current_dir(place.folder.path()).output().unwrap();
    assert_says(&refused(&output), &["large.toml", "GiB of memory", "free"]);
    assert_eq!(place.names(), ["c.toml", "large.toml"]);
}

#[test]
fn messages_are_short_whatever_they_quote() {
    let place = Place::new();
    let own = fs::read_to_string(place.path("c.toml")).unwrap();
    let name = "n".repeat(1 << 20);
    for text in [
        format!("{own}\nx = {}", "[".repeat(100_000)),
        format!("{own}\nx = {}", "[ ".repeat(100_000)),
        format!("{own}\n{}a = 1", "a.".repeat(500_000)),
        format!("{own}\n[[materials]]\nname = \"{name}\"\ncolour = [1, 1, 2]\n"),
        format!(
            "{own}\n[[materials]]\nname = \"{}\"\ncolour = [1, 1, 2]\n",
            "\\n".repeat(500_000)
        ),
        format!(
            "{own}\n[[objects]]\nname = \"{name}\"\nmaterial = \"{name}\"\nkind = \"sphere\"\nradius = 1\n"
        ),
    ] {
        fs::write(place.path("hostile.toml"), text).unwrap();
        refused(&place.run(&["render", "hostile.toml", "-o", "x.png"]));
    }
    let path = format!("{}x", "long/".repeat(20_000));
    refused(&place.run(&["render", &path, "-o", "x.png"]));
    refused(&place.run(&["render", "c.toml", "-o", &path]));
    refused(&place.run(&["render", "c.toml", "--size", &path, "-o", "x.png"]));
    let of_a_command = place.run(&[&path]);
    refused(&of_a_command);
}

/// Waits until a file whose name begins like a temporary one is there.
fn wait_for_temporary_file(folder: &Path) {
    let begun = Instant::now();
    let is_temporary =
        |entry: fs::DirEntry| entry.file_name().to_string_lossy().starts_with(".imogene-");
    while !fs::read_dir(folder)
        .unwrap()
        .any(|entry| entry.is_ok_and(is_temporary))
    {
        assert!(
            begun.elapsed() < Duration::from_secs(60),
            "no temporary file"
        );
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn an_interruption_leaves_nothing_and_says_so() {
    for (signal, code) in [("INT", 130), ("TERM", 143)] {
        let place = Place::new();
        let scratch = tempfile::tempdir().unwrap();
        make_pipe(&place.path("pipe"));
        // Nobody reads the pipe: the set waits there, complete but for its names.
        let child = Command::new(assert_cmd::cargo::cargo_bin("imogene"))
            .args([
                "render",
                "c.toml",
                "-o",
                "x.png",
                "--depth",
                "pipe",
                "--ids",
                "new/i.npy",
            ])
            .args(SIZE)
            .current_dir(place.folder.path())
            .env("TMPDIR", scratch.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        wait_for_temporary_file(place.folder.path());
        let sent = Command::new("kill")
            .args(["-s", signal, &child.id().to_string()])
            .status();
        assert!(sent.unwrap().success());
        let output = child.wait_with_output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{message}");
        assert!(
            message.starts_with("interrupted: ") && message.lines().count() == 1,
            "{message}"
        );
        assert_eq!(place.names(), ["c.toml", "pipe"]);
        assert_eq!(fs::read_dir(scratch.path()).unwrap().count(), 0);
    }
}
