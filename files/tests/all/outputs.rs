//! Sets of files: all of them or none.

use imogene_files::{Identity, Outputs, Target, write_whole};
use std::fs;
use std::io::{Error, Write};
use std::path::Path;

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name();
    let mut names: Vec<String> = entries.map(|e| name(e).into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn files_appear_when_the_set_is_finished() {
    let folder = tempfile::tempdir().unwrap();
    let [first, second] = ["a/b/first", "second"].map(|name| folder.path().join(name));
    let mut set = Outputs::new();
    set.add_text(&first, "1").unwrap();
    set.open(&second).unwrap().write_all(b"2").unwrap();
    assert!(!first.exists() && !second.exists());
    assert_eq!(set.paths(), [first.clone(), second.clone()]);
    assert_eq!(set.finish().unwrap(), [first.clone(), second.clone()]);
    assert_eq!(fs::read(first).unwrap(), b"1");
    assert_eq!(fs::read(second).unwrap(), b"2");
    assert_eq!(names(folder.path()), ["a", "second"]);
}

#[test]
fn a_set_that_is_not_finished_leaves_neither_files_nor_folders() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("old")).unwrap();
    let mut set = Outputs::new();
    set.add_text(&folder.path().join("new/deep/file"), "1")
        .unwrap();
    set.add_text(&folder.path().join("old/file"), "1").unwrap();
    drop(set);
    assert_eq!(names(folder.path()), ["old"]);
    assert!(names(&folder.path().join("old")).is_empty());
}

#[test]
fn a_file_that_was_not_filled_is_no_part_of_the_set() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file");
    let mut set = Outputs::new();
    let error = set.add(&path, |_| Err(Error::other("no room")));
    let message = error.unwrap_err().to_string();
    assert!(message.contains("file") && message.contains("no room"));
    assert!(set.finish().unwrap().is_empty());
    assert!(write_whole(&path, |_| Err(Error::other("no room"))).is_err());
    assert!(names(folder.path()).is_empty());
}

#[test]
fn inputs_and_files_of_the_set_are_not_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("input");
    fs::write(&input, "old").unwrap();
    let identity = Identity::of(&input).unwrap().unwrap();
    let mut set = Outputs::sparing(vec![identity]);
    let message = set.add_text(&input, "new").unwrap_err().to_string();
    assert!(message.contains("read by the same command"), "{message}");
    set.add_text(&folder.path().join("file"), "1").unwrap();
    let again = set.add_text(&folder.path().join("./file"), "2");
    let message = again.unwrap_err().to_string();
    assert!(message.contains("the same file"), "{message}");
    set.finish().unwrap();
    assert_eq!(fs::read(&input).unwrap(), b"old");
    assert_eq!(fs::read(folder.path().join("file")).unwrap(), b"1");
}

#[test]
fn a_file_that_may_not_be_written_to_is_not_replaced_by_its_owner() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file");
    fs::write(&path, "old").unwrap();
    let mut facts = fs::metadata(&path).unwrap().permissions();
    facts.set_readonly(true);
    fs::set_permissions(&path, facts).unwrap();
    // The administrator may write to it, and then its mode is kept.
    let may = fs::OpenOptions::new().write(true).open(&path).is_ok();
    assert_eq!(Target::of(&path).is_ok(), may);
    assert_eq!(write_whole(&path, |out| out.write_all(b"new")).is_ok(), may);
    assert!(fs::metadata(&path).unwrap().permissions().readonly());
}
