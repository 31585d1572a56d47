//! Refusals of a file as a text: missing, cut short, of another version.

use super::{GOOD, assert_says, check_each, file_with, refused};
use imogene_scene::SceneFile;
use std::fs;
use std::path::Path;

#[test]
fn missing_file() {
    let error = SceneFile::read(Path::new("no/such/scene.toml")).expect_err("no such file");
    let message = error.to_string();
    assert!(message.starts_with("no/such/scene.toml: "), "{message}");
    assert!(message.contains("cannot be read"), "{message}");
    assert!(message.contains("readable TOML scene file"), "{message}");
}

#[test]
fn directory_instead_of_file() {
    let error = SceneFile::read(&std::env::temp_dir()).expect_err("a directory");
    assert!(error.to_string().contains("cannot be read"), "{error}");
}

#[test]
fn not_utf8() {
    let path = file_with("not-utf8", b"format = 1\ntitle = \"caf\xe9\"\n");
    let error = SceneFile::read(&path).expect_err("Latin-1 text");
    fs::remove_file(&path).expect("the file was written");
    let message = error.to_string();
    assert!(message.contains(":2: byte 23 is not UTF-8"), "{message}");
}

#[test]
fn empty_file() {
    refused("", "format | the file is empty | `format = 1`");
}

#[test]
fn truncated_file() {
    let cut_short = &GOOD[..GOOD.len() - 20];
    refused(
        cut_short,
        "demo.toml:32:34: | unclosed inline table | expected `}`",
    );
    let without_objects = &GOOD[..GOOD.find("[[objects]]").expect("it is there")];
    refused(
        without_objects,
        "objects | no object | at least one `[[objects]]`",
    );
}

#[test]
fn every_truncation_is_refused_or_a_scene() {
    for end in 0..GOOD.len() {
        if let Err(error) = SceneFile::parse(&GOOD[..end], "demo.toml") {
            assert_says(&error.to_string(), &[]);
        }
    }
}

#[test]
fn missing_and_wrong_version() {
    check_each(
        r#"
        format = 1\n | | version of the format is missing | `format = 1`
        format = 1 | format = 2 | version 2 is not known | `format = 1`
        format = 1 | format = "1" | version | `format = 1`
        "#,
    );
}
