//! Standard output: the one file that it takes, its loss, and failures as documents.

use super::{Place, accepted, assert_says, refused};
use std::fs::{self, File};
use std::process::{Command, Output, Stdio};

#[test]
fn standard_output_takes_the_file_and_reports_go_to_standard_error() {
    let place = Place::new();
    for name in ["-", "/dev/stdout"] {
        let output = place.render(&["-o", name]);
        accepted(&output);
        assert_eq!(output.stdout, place.picture(), "{name}");
        assert_says(
            &String::from_utf8_lossy(&output.stderr),
            &["48 x 36 pixels"],
        );
    }
    let output = place.run(&["terrain", "--levels", "2", "-o", "-"]);
    accepted(&output);
    accepted(&place.run(&["terrain", "--levels", "2", "-o", "f.heights"]));
    assert_eq!(output.stdout, fs::read(place.path("f.heights")).unwrap());
    assert_eq!(place.names(), ["c.toml", "f.heights"]);
}

#[test]
fn standard_output_takes_one_file_and_no_document_beside_it() {
    let place = Place::new();
    for (arguments, said) in [
        (
            &["render", "c.toml", "-o", "-", "--depth", "-"][..],
            "--output - is the same file",
        ),
        (&["render", "c.toml", "-o", "-", "--json"], "--json"),
        (&["cosim", "c.toml", "--vcd", "-"], "several files"),
        (&["emit", "beam", "--out", "-"], "several files"),
    ] {
        assert_says(&refused(&place.run(arguments)), &[said]);
    }
    assert_eq!(place.names(), ["c.toml"]);
}

fn printed_into(arguments: &[&str], out: Stdio) -> Output {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin("imogene"));
    let child = command.args(arguments).stdout(out).stderr(Stdio::piped());
    child.spawn().unwrap().wait_with_output().unwrap()
}

#[test]
fn lost_standard_output_is_an_error() {
    for arguments in [
        &["units"][..],
        &["units", "--json"],
        &["--help"],
        &["--version"],
    ] {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let message = refused(&printed_into(arguments, full.into()));
        assert_says(&message, &["cannot write standard output"]);
    }
    let program = assert_cmd::cargo::cargo_bin("imogene");
    let mut shell = Command::new("sh");
    let shell = shell.arg("-c").arg("\"$0\" units >&-").arg(program);
    assert_says(
        &refused(&shell.output().unwrap()),
        &["standard output", "closed"],
    );
}

#[test]
fn a_closed_pipe_ends_the_program_quietly() {
    for arguments in [&["units"][..], &["units", "--json"]] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = printed_into(arguments, writer.into());
        assert_eq!(output.status.code(), Some(141));
        assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    }
}

#[test]
fn failures_are_documents_too() {
    let place = Place::new();
    for arguments in [
        &["render", "missing.toml", "-o", "x.png", "--json"][..],
        &["render", "c.toml", "-o", "c.toml", "--json"],
        &[
            "--json", "render", "c.toml", "--format", "nan", "-o", "x.png",
        ],
        &["nonsense", "--json"],
    ] {
        let output = place.run(arguments);
        let message = refused(&output);
        let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(document["error"]["exit_code"], 2);
        let said = document["error"]["message"].as_str().unwrap();
        assert_eq!(message, format!("error: {said}\n"));
    }
    // A report that was printed says of itself that a check failed; no second document follows.
    let output = place.run(&[
        "fit",
        "c.toml",
        "--size",
        "16x12",
        "--max-depth-error",
        "0.0000001",
        "--out",
        "f",
        "--json",
    ]);
    assert_eq!(output.status.code(), Some(1));
    let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(document["error"]["exit_code"], 1);
    assert!(!place.path("f").exists());
}

#[test]
fn usage_is_refused_in_plain_words() {
    let place = Place::new();
    for (arguments, said) in [
        (&["bounds", "--cases", "0"][..], "1 or more"),
        (&["bounds", "--cases", "x"], "a whole number is expected"),
        (
            &["render", "c.toml", "-o", "x", "--format", "nan"],
            "8 to 32",
        ),
        (&["emit", "pe1", "--out", "x", "--format", ""], "8 to 32"),
        (
            &["fit", "c.toml", "--out", "x", "--max-depth-error", "-1"],
            "is no limit of a depth",
        ),
        (
            &["fit", "c.toml", "--out", "x", "--max-colour-error", "-1"],
            "0 or more",
        ),
        (
            &["fit", "c.toml", "--out", "x", "--max-normal-error", "nan"],
            "0 or more",
        ),
        (&["terrain", "--roughness", "-1", "-o", "x"], "-1"),
        (
            &["terrain", "--roughness", "rough", "-o", "x"],
            "a number is expected",
        ),
        (&[], "a command is expected"),
    ] {
        let output = place.run(arguments);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert_says(&message, &[said]);
    }
    assert_eq!(place.names(), ["c.toml"]);
}
