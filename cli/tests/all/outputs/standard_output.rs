//! Standard output: the one file that it takes, its loss, and failures as documents.

use super::{picture, place, refused, shell};
use crate::common::{Run, columns, imogene};
use std::fs::File;
use std::process::{Command, Output, Stdio};

/// What a command line prints, run in a folder.
fn printed(line: &str, place: &crate::common::Place) -> Output {
    let mut command = imogene(line);
    let output = command.current_dir(place.folder()).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{line}");
    output
}

#[test]
fn standard_output_takes_the_file_and_reports_go_to_standard_error() {
    let place = place();
    for name in ["-", "/dev/stdout"] {
        let output = printed(&format!("render c.toml --size 48x36 -o {name}"), &place);
        assert_eq!(output.stdout, picture(), "{name}");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(said.contains("48 x 36 pixels"), "{said}");
    }
    let output = printed("terrain --levels 2 -o -", &place);
    place.run("terrain --levels 2 -o f.heights").ended(0);
    assert_eq!(output.stdout, place.bytes("f.heights"));
    assert_eq!(place.names(), ["c.toml", "f.heights"]);
}

#[test]
fn standard_output_takes_one_file_and_no_document_beside_it() {
    let place = place();
    let cases = "
        render c.toml -o - --depth - | --output - is the same file
        render c.toml -o - --json    | --json
        cosim c.toml --vcd -         | several files
        emit beam --out -            | several files
    ";
    for [line, said] in columns(cases) {
        refused(place.run(line), &[said]);
    }
    assert_eq!(place.names(), ["c.toml"]);
}

/// A command line whose standard output goes elsewhere.
fn printed_into(line: &str, out: Stdio) -> Run {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin("imogene"));
    let child = command.args(line.split(' ')).stdout(out);
    let child = child.stderr(Stdio::piped()).spawn().unwrap();
    let output = child.wait_with_output().unwrap();
    Run {
        code: output.status.code(),
        out: String::new(),
        said: String::from_utf8(output.stderr).unwrap(),
    }
}

#[test]
fn lost_standard_output_is_an_error() {
    for line in ["units", "units --json", "--help", "--version"] {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let run = printed_into(line, full.into());
        refused(run, &["cannot write standard output"]);
    }
    let run = shell(&place(), "\"$0\" units >&-");
    refused(run, &["standard output", "closed"]);
}

#[test]
fn a_closed_pipe_ends_the_program_quietly() {
    for line in ["units", "units --json"] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let run = printed_into(line, writer.into()).ended(141);
        assert_eq!(run.said, "");
    }
}

#[test]
fn failures_are_documents_too() {
    let place = place();
    for line in [
        "render missing.toml -o x.png --json",
        "render c.toml -o c.toml --json",
        "--json render c.toml --format nan -o x.png",
        "nonsense --json",
    ] {
        let run = refused(place.run(line), &[]);
        let document = run.json();
        assert_eq!(document["error"]["exit_code"], 2);
        let said = document["error"]["message"].as_str().unwrap();
        assert_eq!(run.said, format!("error: {said}\n"));
    }
    // A report that was printed says of itself that a check failed; no second document follows.
    let line = "fit c.toml --size 16x12 --max-depth-error 0.0000001 --out f --json";
    let document = place.run(line).ended(1).json();
    assert_eq!(document["error"]["exit_code"], 1);
    assert!(!place.has("f"));
}

#[test]
fn usage_is_refused_in_plain_words() {
    let place = place();
    let cases = "
        bounds --cases 0                          | 1 or more
        bounds --cases x                          | a whole number is expected
        render c.toml -o x --format nan           | 8 to 32
        emit pe1 --out x --format=                | 8 to 32
        fit c.toml --out x --max-depth-error -1   | is no limit of a depth
        fit c.toml --out x --max-colour-error -1  | 0 or more
        fit c.toml --out x --max-normal-error nan | 0 or more
        terrain --roughness -1 -o x               | -1
        terrain --roughness rough -o x            | a number is expected
                                                  | a command is expected
    ";
    for [line, said] in columns(cases) {
        place.run(line).refused(&[said]);
    }
    assert_eq!(place.names(), ["c.toml"]);
}
